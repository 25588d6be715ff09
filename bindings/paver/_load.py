"""Finds and loads the compiled part of the package, and says in one sentence what to do when it cannot."""
import importlib.machinery
import importlib.util
import os
import sys
import warnings

NAME = "paver._paver"
FOLDER = os.path.dirname(os.path.abspath(os.path.realpath(__file__)))
LIBRARIES = os.path.join(os.path.dirname(FOLDER), "paver.libs")  # what a wheel brings along
CHECKOUT = os.path.dirname(os.path.dirname(FOLDER))
IS_CHECKOUT = os.path.isdir(os.path.join(CHECKOUT, "core"))
BUILD_FOLDER = os.environ.get("PAVER_BUILD") or os.path.join(CHECKOUT, "build")
SOURCES = ("core/include", "core/src", "bindings/src")  # relative to the checkout
NOT_LINKED = tuple(os.path.join("core", "src", name) for name in ("cli", "formats", "watch", "worker"))


def remedy(target="paver_python"):
    """What to do when something is missing."""
    if IS_CHECKOUT:
        return f"run scripts/build {target} in {CHECKOUT}"
    return "install Paver again, as it was made for this system and this Python"


def candidates(folder):
    """Files in `folder` that hold the module for some Python; those for this one first."""
    found = sorted(n for n in os.listdir(folder) if n.startswith("_paver.")) if os.path.isdir(folder) else []
    suffixes = importlib.machinery.EXTENSION_SUFFIXES
    mine = [n for n in found if n[len("_paver"):] in suffixes]
    return [os.path.join(folder, n) for n in mine], [n for n in found if n.endswith((".so", ".pyd")) and n not in mine]


def find():
    """Path of the compiled module: beside the package where it is installed, else in the build folder."""
    foreign = []
    for folder in (FOLDER, os.path.join(BUILD_FOLDER, "bindings")):
        mine, others = candidates(folder)
        if mine:
            return mine[0]
        foreign += others
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


def search_order():
    """Flags of the loader. A wheel's own OpenCASCADE and TBB go before others that the host has loaded for all to see;
    not always, as the system's memory allocator would go before one that somebody put in, too."""
    if not os.path.isdir(LIBRARIES):
        return sys.getdlopenflags()
    import ctypes
    seen_by_all = ctypes.CDLL(None)
    has_others = any(hasattr(seen_by_all, name) for name in ("_ZTI18Standard_Transient", "TBB_runtime_interface_version"))
    return os.RTLD_NOW | os.RTLD_LOCAL | (os.RTLD_DEEPBIND if has_others else 0)


def load_file(path):
    loader = importlib.machinery.ExtensionFileLoader(NAME, path)
    flags = sys.getdlopenflags()
    try:
        sys.setdlopenflags(search_order())
        module = importlib.util.module_from_spec(importlib.util.spec_from_file_location(NAME, path, loader=loader))
        loader.exec_module(module)
    finally:
        sys.setdlopenflags(flags)
    return module


def numpy_version():
    try:
        import numpy
    except ImportError:
        raise ImportError("Paver's Python module needs NumPy; install it (package python3-numpy, or pip install numpy).") from None
    return numpy.__version__


def load():
    """The compiled module. ImportError, or RuntimeWarning when the sources are newer, with one sentence each."""
    path = find()
    if not path.startswith(FOLDER + os.sep) and newest_source(CHECKOUT) > os.stat(path).st_mtime:
        warnings.warn(f"Paver's compiled module is older than its sources; {remedy()}.", RuntimeWarning, stacklevel=3)
    numpy = numpy_version()
    try:
        module = load_file(path)
    except ImportError as error:
        what = f"run scripts/setup in {CHECKOUT}, then scripts/build paver_python" if IS_CHECKOUT else remedy()
        raise ImportError(f"Paver's compiled module does not load ({error}); {what}.") from None
    if int(numpy.split(".")[0]) > 1 and not module.knows_numpy_2:
        raise ImportError(f"Paver's compiled module needs NumPy 1, and this is NumPy {numpy}; install one below 2.")
    sys.modules[NAME] = module
    return module
