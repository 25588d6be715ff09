"""Finds and loads the compiled part of the package, and says in one sentence what to do when it cannot."""
import importlib.machinery
import importlib.util
import mmap
import os
import re
import sys
import warnings

NAME = "paver._paver"
FOLDER = os.path.dirname(os.path.abspath(os.path.realpath(__file__)))
LIBRARIES = "paver.libs"  # beside the package: what a wheel brings along
CHECKOUT = os.path.dirname(os.path.dirname(FOLDER))
IS_CHECKOUT = os.path.isdir(os.path.join(CHECKOUT, "core"))
SCRIPT = os.path.join(CHECKOUT, "scripts", "build")
BASH = "bash " if os.path.exists(SCRIPT) and not os.access(SCRIPT, os.X_OK) else ""  # unpacked without permissions
SOURCES = ("core/include", "core/src", "bindings/src")  # relative to the checkout
NOT_LINKED = tuple(os.path.join("core", "src", name) for name in ("cli", "formats", "watch", "worker"))
MARK = re.compile(rb"Paver's compiled module, version ([\w.+-]+)")  # in the compiled module


def own_version():
    """The version of the checkout; empty where the package is installed, which has its compiled part beside it."""
    path = os.path.join(CHECKOUT, "package.xml")
    if not os.path.isfile(path):
        return ""
    with open(path, encoding="utf-8") as file:
        return re.search("<version>([^<]*)</version>", file.read()).group(1).strip()


def marked_version(content):
    """The version that a compiled module, as bytes, says it has; empty without one."""
    found = MARK.search(content)
    return found.group(1).decode() if found else ""


def version_of(path):
    """That of a file, which is not loaded for it: two versions in one process do not go together."""
    with open(path, "rb") as file:
        if os.fstat(file.fileno()).st_size == 0:
            return ""
        with mmap.mmap(file.fileno(), 0, access=mmap.ACCESS_READ) as content:
            return marked_version(content)


def remedy(target="paver_python"):
    """What to do when something is missing."""
    if IS_CHECKOUT:
        return f"run {BASH}scripts/build {target} in {CHECKOUT}"
    return "install Paver again, as it was made for this system and this Python"


def candidates(folder):
    """Files in `folder` that hold the module for some Python; those for this one first."""
    try:
        found = sorted(n for n in os.listdir(folder) if n.startswith("_paver."))
    except OSError:  # it is not there, or not ours to look into
        found = []
    suffixes = importlib.machinery.EXTENSION_SUFFIXES
    mine = [n for n in found if n[len("_paver"):] in suffixes]
    return [os.path.join(folder, n) for n in mine], [n for n in found if n.endswith((".so", ".pyd")) and n not in mine]


def build_folder():
    return os.environ.get("PAVER_BUILD") or os.path.join(CHECKOUT, "build")


def other_packages():
    """Folders of packages of this name elsewhere on sys.path: an unpacked binary, what the system or pip has installed."""
    folders = (os.path.join(path, "paver") for path in sys.path)
    return [f for f in folders if os.path.isdir(f) and not os.path.samefile(f, FOLDER)]


def find():
    """Paths of compiled modules that fit, best first: beside the package where it is installed, in the build folder, in
    another package of this name. ImportError, one sentence, without any."""
    wanted, fitting, foreign, others = own_version(), [], [], []
    for folder in (FOLDER, os.path.join(build_folder(), "bindings"), *other_packages()):
        mine, not_mine = candidates(folder)
        foreign += not_mine
        for path in mine:
            version = version_of(path) if wanted else ""
            (others if version and version != wanted else fitting).append((path, version))
    if fitting:
        return [path for path, _ in fitting]
    if others:
        raise ImportError(f"Paver's compiled module {others[0][0]} has version {others[0][1]}, but its package in "
                          f"{FOLDER} has version {wanted}; {remedy()}.")
    if foreign:
        raise ImportError(f"Paver's compiled module is for another Python than {sys.version.split()[0]} "
                          f"({', '.join(foreign)}); {remedy()}, or use the Python it was built for.")
    raise ImportError(f"Paver's compiled module is missing; {remedy()}.")


def newest_source(checkout):
    """When a source of the module last changed, seconds; 0 without sources."""
    newest = 0.0
    for top in SOURCES:
        for folder, _, names in os.walk(os.path.join(checkout, top)):
            if not folder.endswith(NOT_LINKED):
                newest = max([newest] + [os.stat(os.path.join(folder, n)).st_mtime for n in names
                                         if n.endswith((".h", ".cpp"))])
    return newest


def search_order(path):
    """Flags of the loader. A wheel's own OpenCASCADE and TBB go before others that the host has loaded for all to see;
    not always, as the system's memory allocator would go before one that somebody put in, too."""
    if not os.path.isdir(os.path.join(os.path.dirname(os.path.dirname(path)), LIBRARIES)):
        return sys.getdlopenflags()
    import ctypes
    seen_by_all = ctypes.CDLL(None)
    has_others = any(hasattr(seen_by_all, name) for name in ("_ZTI18Standard_Transient", "TBB_runtime_interface_version"))
    return os.RTLD_NOW | os.RTLD_LOCAL | (os.RTLD_DEEPBIND if has_others else 0)


def load_file(path):
    loader = importlib.machinery.ExtensionFileLoader(NAME, path)
    flags = sys.getdlopenflags()
    try:
        sys.setdlopenflags(search_order(path))
        module = importlib.util.module_from_spec(importlib.util.spec_from_file_location(NAME, path, loader=loader))
        loader.exec_module(module)
    finally:
        sys.setdlopenflags(flags)
    return module


def numpy_version():
    """As NumPy tells it."""
    try:
        import numpy
    except ImportError:
        raise ImportError(f"Paver needs NumPy, which {sys.executable or 'this Python'} does not have; install it (package "
                          "python3-numpy, or pip install numpy).", name="numpy") from None
    return numpy.__version__


def load():
    """The compiled module. ImportError, or RuntimeWarning when the sources are newer, with one sentence each."""
    numpy, faults = numpy_version(), []
    for path in find():
        if os.path.dirname(path) == os.path.join(build_folder(), "bindings") and newest_source(CHECKOUT) > os.stat(path).st_mtime:
            warnings.warn(f"Paver's compiled module is older than its sources; {remedy()}.", RuntimeWarning, stacklevel=3)
        try:
            module = load_file(path)
        except ImportError as error:
            faults.append(str(error))
            continue
        if int(numpy.split(".")[0]) > 1 and not getattr(module, "knows_numpy_2", False):
            raise ImportError(f"Paver's compiled module needs NumPy 1, and this is NumPy {numpy}; install one below 2.",
                              name="numpy")
        sys.modules[NAME] = module
        return module
    what = f"run {BASH}scripts/setup in {CHECKOUT}, then {BASH}scripts/build paver_python" if IS_CHECKOUT else remedy()
    raise ImportError(f"Paver's compiled module does not load ({faults[0]}); {what}.")
