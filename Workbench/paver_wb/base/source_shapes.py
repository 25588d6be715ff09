"""Shapes of what a mesh object meshes, each where it stands, and their digest.

FreeCAD hands shapes out anew at each question, some of them put together anew. Whether they are those of before is seen
without looking into surfaces and curves; only where it is not is a digest made of all their bytes.
"""
import hashlib

from paver_wb import core


def of(sources):
    """Shapes of objects. InputError for one without."""
    core.load()
    from paver import _shapes
    return [_shapes.shape_of(source) for source in sources]


def labels_of(sources):
    """Labels of the faces of objects meshed together, as paver.Model gives them. InputError for one without a shape."""
    import Part
    shapes = of(sources)
    from paver import _face_labels
    return _face_labels.of(sources, shapes, shapes[0] if len(shapes) == 1 else Part.Compound(shapes))


def digest_of(stream):
    """Digest of the bytes of a shape."""
    return hashlib.blake2b(stream, digest_size=16).hexdigest()


def are_same(some, others):
    """Whether two lists of shapes are the same for certain."""
    return len(some) == len(others) and all(map(is_same, some, others))


def is_same(one, other):
    """Whether two shapes are one and the same, at one place: they share their surfaces and curves, or all their parts do."""
    if one.isEqual(other):
        return True
    if one.ShapeType != other.ShapeType or one.Orientation != other.Orientation or (
            one.Placement.toMatrix() != other.Placement.toMatrix()):
        return False
    return one.isPartner(other) or one.ShapeType == "Compound" and are_same(one.SubShapes, other.SubShapes)


class Known:
    """The digest of the shapes that were asked for last."""

    def __init__(self):
        self.shapes, self.digest = None, ""

    def digest_of(self, shapes):
        if self.shapes is None or not are_same(shapes, self.shapes):
            from paver import _shapes
            self.shapes, self.digest = None, digest_of(_shapes.source_of(shapes, None)[0])
            self.shapes = shapes  # kept, so that none of their parts is another one at its address
        return self.digest
