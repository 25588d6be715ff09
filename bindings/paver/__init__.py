"""Paver: curved quadrilateral surface meshes of CAD models.

    import paver
    result = paver.mesh("box.step", size="5 mm")
    result.write("box.msh")

mesh() makes a Result: NumPy arrays, a report, files. predict() says beforehand what it will come to. A Model is taken
once and meshed often, in any thread. All errors are Error.
"""
import atexit as _atexit

from . import _load, _program

if _program.is_asked():
    import sys as _sys
    _program.run(_sys.argv[1:])

_paver = _load.load()

from ._errors import (Cancelled, Error, FaceError, InputError, InternalError, LimitError, OptionError,  # noqa: E402
                      OutOfMemory, OutputError)
from ._jobs import Cancel  # noqa: E402
from ._model import Model, Part  # noqa: E402
from ._result import Result  # noqa: E402
from ._run import Prediction, mesh, options, predict, target_lengths  # noqa: E402
from ._surface_mesh import ElementQuality, PickTree, SurfaceMesh, Tessellation  # noqa: E402

__version__ = _paver.version
__all__ = ["Cancel", "Cancelled", "ElementQuality", "Error", "FaceError", "InputError", "InternalError", "LimitError",
           "Model", "OptionError", "OutOfMemory", "OutputError", "Part", "PickTree", "Prediction", "Result", "SurfaceMesh",
           "Tessellation", "mesh", "options", "predict", "target_lengths"]

for _name in __all__:
    globals()[_name].__module__ = __name__  # where users find it, and what tracebacks show

_atexit.register(_paver.cancel_all_jobs)
