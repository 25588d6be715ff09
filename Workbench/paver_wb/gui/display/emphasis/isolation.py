"""Parts of a mesh alone: which elements are drawn and picked."""
from typing import NamedTuple

import numpy as np

from paver_wb.formats import mesh_file

EVERYTHING, WORST, TRIANGLES, FREE, LISTED = CHOICES = ("Everything", "Worst elements", "Triangles", "Free edges",
                                                       "Listed elements")
FEW_WORST = 10  # where the view object asks for no other number


class Shown(NamedTuple):
    """elements: (elements,) whether each is drawn, None for all; edges: the same for free edges of elements; is_part: whether
    something is left out besides faces."""

    elements: object
    edges: object
    is_part: bool


ALL = Shown(None, None, False)


def of_view(mesh, vobj, worst):
    """What the properties of a view object leave of a DrawnMesh. worst(count): numbers of the worst elements."""
    faces = is_shown_by_face(mesh, vobj.HiddenFaces)
    if vobj.Isolate == EVERYTHING:
        return Shown(faces, faces, False)
    chosen = np.zeros(mesh.count, dtype=bool)
    if vobj.Isolate == WORST:
        chosen[worst(vobj.ShowWorst or FEW_WORST)] = True
    elif vobj.Isolate == TRIANGLES:
        chosen[mesh.quad_count:] = True
    elif vobj.Isolate == LISTED:
        listed = np.array(vobj.IsolatedElements, np.int64) - 1
        chosen[listed[(listed >= 0) & (listed < mesh.count)]] = True
    elements = chosen if faces is None else chosen & faces
    return Shown(elements, faces if vobj.Isolate == FREE else elements, True)


def is_shown_by_face(mesh, hidden):
    """(elements,), None where no face is hidden."""
    is_hidden = np.array([is_named(label, set(hidden)) for label in mesh.face_names], dtype=bool)
    return ~is_hidden[mesh.faces] if is_hidden.any() else None


def is_named(label, names):
    """Whether a face is among names of faces and objects: "A/Face2 + B/Face1" by itself, by one of its two names, or by both
    objects."""
    faces = label.split(mesh_file.BOTH)
    objects = [face.rpartition("/")[0] for face in faces]
    return label in names or not names.isdisjoint(faces) or all(name and name in names for name in objects)


def is_of(label, name):
    """Whether `name` is that of a face, of one side of it, or of an object that has it."""
    faces = label.split(mesh_file.BOTH)
    return name == label or name in faces or name in [face.rpartition("/")[0] for face in faces]
