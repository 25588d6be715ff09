"""The compiled core, which may not be there: the workbench loads all the same and says what to do."""
import os

# Besides building, which the package itself tells about.
BINARY = ("with a binary of it, a file paver-*.whl, run in FreeCAD: from paver_wb import binary; "
          "binary.install(\"FILE\")")


class CoreMissing(RuntimeError):
    """The core is not there, or does not load. The text is one sentence that says what to run."""


class NumPyUnfit(CoreMissing):
    """The core does not load as NumPy is missing or too new, which neither a build nor a binary changes."""


def load():
    """The module `paver`. CoreMissing when it cannot be loaded; tried again at every call, as it may come later."""
    try:
        import paver
    except ImportError as error:
        if error.name == "numpy":
            raise NumPyUnfit(str(error)) from None
        raise CoreMissing(f"{str(error).rstrip('.')}; or, {BINARY}.") from None
    return paver


def stages():
    """[(name, what users read, share of the time of a common run in percent)] of a run, in order."""
    return load()._paver.stages()


def exit_code(code):
    """Of a program that ends with an error of the core, by its `code`."""
    return load()._paver.exit_codes()[code]


def fault():
    """The CoreMissing that says why nothing can be meshed, or None."""
    try:
        load()
    except CoreMissing as error:
        return error
    return None


def problem():
    """Empty, or the sentence that says why nothing can be meshed and what to run."""
    return str(fault() or "")


def binary_folder():
    """Where a binary is unpacked. Init.py puts it on sys.path; it may not exist."""
    import FreeCAD
    return os.path.join(FreeCAD.getUserAppDataDir(), "Paver", "binary")


def about():
    """Lines for a report of a fault: versions of Paver, FreeCAD and Python, and where the core lies."""
    import sys

    import FreeCAD
    lines = ["FreeCAD " + ".".join(FreeCAD.Version()[:3]) + ", Python " + sys.version.split()[0]]
    try:
        paver = load()
    except CoreMissing as error:
        return [str(error)] + lines
    return [f"Paver {paver.__version__}, core {paver._paver.__file__}"] + lines
