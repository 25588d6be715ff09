"""What FreeCAD's C++ writes to the standard output without being asked, such as a line for each group of a FemMesh."""
import ctypes
import os
import sys
from contextlib import contextmanager


def flush():
    """All that C and Python have not written yet."""
    for stream in (sys.stdout, sys.__stdout__):
        if stream is not None and hasattr(stream, "flush"):
            stream.flush()
    try:
        ctypes.CDLL(None).fflush(None)
    except (OSError, TypeError, AttributeError):  # a system without it writes at once, or a little later
        pass


@contextmanager
def output():
    """Nothing that is written to the process's standard output meanwhile appears. Short work only: it is that of all
    threads."""
    flush()
    try:
        kept = os.dup(1)
    except OSError:  # a window without a terminal
        yield
        return
    nowhere = os.open(os.devnull, os.O_WRONLY)
    os.dup2(nowhere, 1)
    os.close(nowhere)
    try:
        yield
    finally:
        flush()
        os.dup2(kept, 1)
        os.close(kept)
