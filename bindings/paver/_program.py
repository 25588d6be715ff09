"""The command line as a part of the package: python -m paver. It needs neither NumPy nor the compiled module."""
import os
import sys

from ._load import FOLDER, IS_CHECKOUT, build_folder, remedy

PREFIX = os.path.normpath(os.path.join(FOLDER, "../../../.."))  # of lib/python3/dist-packages/paver


def is_asked():
    """Whether Python is on its way to paver/__main__.py; the package comes first."""
    return sys.argv[:1] == ["-m"] and sys.orig_argv[-len(sys.argv)] in ("paver", "-mpaver")


def find():
    """Path of the program: beside the package in a wheel, else in the build folder or where it is installed."""
    beside = os.path.join(FOLDER, "paver")
    if os.path.isfile(beside):
        return beside
    return os.path.join(build_folder(), "core", "paver") if IS_CHECKOUT else os.path.join(PREFIX, "bin", "paver")


def run(arguments):
    """Becomes the program, with its options and exit codes."""
    path = find()
    try:
        os.execv(path, [path, *arguments])
    except OSError as error:
        sys.exit(f"paver: The program '{path}' does not start ({error.strerror}); {remedy('paver')}.")
