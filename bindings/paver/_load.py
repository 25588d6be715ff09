"""Finds and loads the compiled part of the package, and says in one sentence what to do when it cannot."""
import importlib.machinery
import importlib.util
import os
import sys
import warnings

NAME = "paver._paver"
FOLDER = os.path.dirname(os.path.abspath(os.path.realpath(__file__)))
CHECKOUT = os.path.dirname(os.path.dirname(FOLDER))
BUILD = "run scripts/build paver_python in " + CHECKOUT
SOURCES = ("core/include", "core/src", "bindings/src")  # relative to the checkout
NOT_LINKED = tuple(os.path.join("core", "src", name) for name in ("cli", "formats", "watch", "worker"))


def candidates(folder):
    """Files in `folder` that hold the module for some Python; those for this one first."""
    found = sorted(n for n in os.listdir(folder) if n.startswith("_paver.")) if os.path.isdir(folder) else []
    suffixes = importlib.machinery.EXTENSION_SUFFIXES
    mine = [n for n in found if n[len("_paver"):] in suffixes]
    return [os.path.join(folder, n) for n in mine], [n for n in found if n.endswith((".so", ".pyd")) and n not in mine]


def find():
    """Path of the compiled module: beside the package where it is installed, else in the build folder."""
    build = os.environ.get("PAVER_BUILD") or os.path.join(CHECKOUT, "build")
    foreign = []
    for folder in (FOLDER, os.path.join(build, "bindings")):
        mine, others = candidates(folder)
        if mine:
            return mine[0]
        foreign += others
    if foreign:
        raise ImportError(f"Paver's compiled module is for another Python than {sys.version.split()[0]} "
                          f"({', '.join(foreign)}); {BUILD}, or use the Python it was built for.")
    raise ImportError(f"Paver's compiled module is missing; {BUILD}.")


def newest_source(checkout):
    """When a source of the module last changed, seconds; 0 without sources."""
    newest = 0.0
    for top in SOURCES:
        for folder, _, names in os.walk(os.path.join(checkout, top)):
            if not folder.endswith(NOT_LINKED):
                newest = max([newest] + [os.stat(os.path.join(folder, n)).st_mtime for n in names
                                         if n.endswith((".h", ".cpp"))])
    return newest


def load():
    """The compiled module. ImportError, or RuntimeWarning when the sources are newer, with one sentence each."""
    if importlib.util.find_spec("numpy") is None:
        raise ImportError(f"Paver needs NumPy, which {sys.executable or 'this Python'} does not have; install the package "
                          "python3-numpy.")
    path = find()
    if not path.startswith(FOLDER + os.sep) and newest_source(CHECKOUT) > os.stat(path).st_mtime:
        warnings.warn(f"Paver's compiled module is older than its sources; {BUILD}.", RuntimeWarning, stacklevel=3)
    loader = importlib.machinery.ExtensionFileLoader(NAME, path)
    try:
        module = importlib.util.module_from_spec(importlib.util.spec_from_file_location(NAME, path, loader=loader))
        loader.exec_module(module)
    except ImportError as error:
        raise ImportError(f"Paver's compiled module does not load ({error}); run scripts/setup in {CHECKOUT}, "
                          f"then scripts/build paver_python.") from None
    sys.modules[NAME] = module
    return module
