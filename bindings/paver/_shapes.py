"""What may be meshed: FreeCAD shapes and objects, files, bytes. FreeCAD is imported only where its things come in.

Shapes travel as FreeCAD's own binary stream, which keeps every coordinate bit for bit and the order of faces and edges.
"""
import os
import tempfile

from . import _face_labels
from ._arguments import in_one_piece
from ._errors import InputError


def is_shape(thing):
    """A Part.Shape, told by what it can do."""
    return hasattr(thing, "exportBinary") and hasattr(thing, "isNull")


def is_object(thing):
    """An object of a FreeCAD document."""
    return hasattr(thing, "isDerivedFrom") and hasattr(thing, "Document") and hasattr(thing, "Label")


def label_of(thing):
    return thing.Label if is_object(thing) else "Shape"


def enclosing(thing):
    """What a document object stands in and is moved by: an App::Part, a Body, the link array it is an element of; or None."""
    if thing.isDerivedFrom("App::LinkElement"):
        return next((other for other in thing.InList if thing in getattr(other, "ElementList", ())), None)
    return thing.getParentGeoFeatureGroup()


def parent_placement(thing):
    """Placement of what encloses a document object, all the way up."""
    import FreeCAD
    placement = FreeCAD.Placement()
    parent = enclosing(thing)
    while parent is not None:
        if hasattr(parent, "Placement"):
            placement = parent.Placement.multiply(placement)
        parent = enclosing(parent)
    return placement


def object_shape(thing, path=""):
    """Shape of a document object, or of what a path in it leads to ("Link.Box.", "Link.Box.Face3"), where it stands in the
    document: its own placement and those of what encloses it."""
    import Part
    shape = Part.getShape(thing, path, needSubElement=bool(path) and not path.endswith("."))
    if shape.isNull():
        raise InputError(f"'{thing.Label}' has no shape; recompute it or choose another object.", "no_faces",
                         "recompute it or choose another object")
    matrix = parent_placement(thing).toMatrix()
    return shape if matrix.isUnity() else shape.transformed(matrix)


def shape_of(thing):
    if is_object(thing):
        return object_shape(thing)
    if thing.isNull():
        raise InputError("The shape is empty; pass one that has faces.", "no_faces", "pass one that has faces")
    return thing


def binary(shape):
    """The bytes that Part.Shape.exportBinary writes. It wants a file: one in memory where the system has them."""
    if not hasattr(os, "memfd_create"):
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "shape.bin")
            shape.exportBinary(path)
            with open(path, "rb") as file:
                return file.read()
    descriptor = os.memfd_create("paver")
    with open(descriptor, "rb") as file:
        shape.exportBinary(f"/proc/self/fd/{descriptor}")
        return file.read()


def source_of(thing, name):
    """(path or bytes, name, labels of faces) of whatever may be meshed."""
    if isinstance(thing, (str, os.PathLike)):
        path = os.fsdecode(os.fspath(thing))
        return path, name or path, []
    if isinstance(thing, (bytes, bytearray, memoryview)):
        return in_one_piece(thing), name or "bytes", []
    if is_shape(thing) or is_object(thing):
        shape = shape_of(thing)
        return binary(shape), name or label_of(thing), _face_labels.of([thing], [shape], shape)
    if isinstance(thing, (list, tuple)) and thing and all(is_shape(t) or is_object(t) for t in thing):
        import Part
        shapes = [shape_of(t) for t in thing]
        compound = Part.Compound(shapes)  # FreeCAD 1.0's makeCompound crashes in a plain Python
        return binary(compound), name or ", ".join(label_of(t) for t in thing), _face_labels.of(thing, shapes, compound)
    remedy = "pass a Part.Shape, an object of a FreeCAD document, a list of these, the path of a CAD file, or its bytes"
    raise TypeError(f"A {type(thing).__name__} cannot be meshed; {remedy}.")
