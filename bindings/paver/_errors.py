"""Exceptions. Each is one sentence: what, where, what to do."""


class Error(Exception):
    """Base of all that Paver raises.

    code: what went wrong, as the core names it, e.g. "bad_option".
    face, edge: "Face12", "Edge7" as FreeCAD numbers them, or None.
    point: (x, y, z) in mm near the trouble, or None.
    stage: where the run was, e.g. "paving", or "".
    remedy: what to do.
    """

    def __init__(self, text, code="internal", remedy="", stage="", face=None, edge=None, point=None):
        super().__init__(text)
        self.code, self.remedy, self.stage = code, remedy, stage
        self.face, self.edge, self.point = face, edge, point

    def __reduce__(self):
        return type(self), (str(self), self.code, self.remedy, self.stage, self.face, self.edge, self.point)


class OptionError(Error, ValueError):
    """An option is unknown, of the wrong kind or out of range, or two exclude each other."""


class InputError(Error):
    """The model cannot be read or has no faces. code: file_missing, not_a_cad_file, damaged_file, no_faces."""


class LimitError(Error):
    """More elements are predicted than max_elements."""


class OutputError(Error):
    """A file cannot be written. Nothing is left of it."""


class Cancelled(Error):
    """Stopped by a Cancel token or by a progress callback that gave False."""


class FaceError(Error):
    """A face cannot be meshed; `face` is the first one.

    faces: the names of all such faces.
    result: the Result with the mesh of the others, or None.
    """

    faces = ()
    result = None


class OutOfMemory(Error, MemoryError):
    """An allocation failed."""


class InternalError(Error, RuntimeError):
    """A defect of Paver: please report it with the model."""


CLASSES = {"bad_option": OptionError, "file_missing": InputError, "not_a_cad_file": InputError,
           "damaged_file": InputError, "no_faces": InputError, "too_many_elements": LimitError,
           "unwritable_output": OutputError, "cancelled": Cancelled, "out_of_memory": OutOfMemory,
           "face_failed": FaceError, "internal": InternalError}


def from_core(code, text, remedy, stage, face, edge, point):
    """The exception for an error of the core, whose faces and edges count from 0 (-1: none)."""
    return CLASSES[code](text, code, remedy, stage, f"Face{face + 1}" if face >= 0 else None,
                         f"Edge{edge + 1}" if edge >= 0 else None, point)
