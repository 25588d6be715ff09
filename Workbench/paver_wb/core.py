"""The compiled core, which may not be built: the workbench loads all the same and says what to run."""


class CoreMissing(RuntimeError):
    """The core is not built, or does not load. The text is one sentence that says what to run."""


def load():
    """The module `paver`. CoreMissing when it cannot be loaded; tried again at every call, as it may be built later."""
    try:
        import paver
    except ImportError as error:
        raise CoreMissing(str(error)) from None
    return paver


def problem():
    """Empty, or the sentence that says why nothing can be meshed and what to run."""
    try:
        load()
    except CoreMissing as error:
        return str(error)
    return ""


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
