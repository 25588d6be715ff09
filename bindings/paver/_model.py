"""Models: what is meshed, taken once."""
import os
from typing import NamedTuple

from . import _paver, _shapes
from ._arguments import encoded_path, texts
from ._jobs import poll_of


class Part(NamedTuple):
    """One of several shapes meshed together.

    faces, edges, vertices, solids: int32 arrays, in the shape's own order: their numbers in the whole, from 0.
    """

    faces: object
    edges: object
    vertices: object
    solids: object


class Model:
    """A CAD model, taken once and meshed any number of times.

    `shape` is a Part.Shape, an object of a FreeCAD document (taken where it stands, with all placements; App::Part and
    links too), a list of these, the path of a STEP, IGES or BREP file, or the content of one as bytes. `name` stands
    for it in messages and in the report. `path` is that of a file, else empty. Faces of several objects, or of an
    App::Part, are called by the labels of these, "Board/Face3"; `labels` gives other names, in the order of the faces.

    FreeCAD's objects are looked at here and now; after that the model may be used in any thread. Files are read when
    first needed, and what was read is kept.
    """

    def __init__(self, shape, name=None, labels=None):
        source, self.name, own = _shapes.source_of(shape, name)
        self.path = source if isinstance(source, str) else ""
        if isinstance(source, str):
            self._source = _paver.Source.of_file(encoded_path(source), os.fsencode(self.name))
        else:
            self._source = _paver.Source.of_bytes(source, os.fsencode(self.name),
                                                  own if labels is None else texts("labels", labels))

    def __repr__(self):
        return f"<paver.Model {self.name!r}>"

    def parts(self, progress=None, cancel=None):
        """A Part for every member of the list that was passed, or of the compound that was read."""
        return [Part(*numbers_) for numbers_ in _paver.parts(self._source, poll_of(progress, cancel))]


def as_model(shape, name):
    return shape if isinstance(shape, Model) else Model(shape, name)
