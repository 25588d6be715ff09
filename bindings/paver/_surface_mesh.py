"""A mesh as arrays, without its report: what can be measured, drawn and picked of it."""
from typing import NamedTuple

from . import _paver
from ._arguments import encoded_path, whole_number, whole_numbers
from ._jobs import poll_of


class ElementQuality(NamedTuple):
    """Figures of every element, quads first, then triangles; read-only arrays. core/docs/quality.md defines them.

    sj: (elements,) float64, straight-sided scaled Jacobian.
    jacobian_ratio: (elements,) float64, lower bound of the curved Jacobian over its mean.
    area: (elements,) float64, mm^2, of the curved element.
    validity: (elements,) int8, 0 Jacobian proven positive, 1 inverted, 2 undecided.
    """

    sj: object
    jacobian_ratio: object
    area: object
    validity: object


class Tessellation(NamedTuple):
    """A mesh cut into flat pieces for drawing; read-only arrays. n is the subdivision.

    points: (k, 3) float32, mm; shared within a B-rep face, not between faces; with `apart` not between elements.
    normals: (k, 3) float32, outward, of unit length.
    triangles: (t, 3) int32, rows of `points`, counter-clockwise seen from outside.
    triangle_elements: (t,) int32, the element of each triangle; quads come first, then triangles.
    outlines: (e, n + 1) int32, every mesh edge once, as rows of `points`.
    outline_edges: (e,) int32, the B-rep edge (0: Edge1) that the mesh edge lies on, or -1.
    outline_elements: (e,) int32, how many elements have the mesh edge; 1 for a free edge.
    triangle_indices, outline_indices: the memory of `triangles` and `outlines` as Coin wants it, in one dimension and
        with -1 after each row.
    """

    points: object
    normals: object
    triangles: object
    triangle_indices: object
    triangle_elements: object
    outlines: object
    outline_indices: object
    outline_edges: object
    outline_elements: object


class Measured:
    """What a mesh in `_data`, of the compiled module, is measured and drawn by."""

    def quality(self):
        """ElementQuality: figures of every element, measured at the first call."""
        return ElementQuality(**self._data.quality())

    def tessellate(self, subdivision=2, apart=False):
        """Tessellation with every element side cut in `subdivision` pieces, 1 to 32. OptionError outside of that.

        apart: no two elements share a point, so that each can have a colour of its own; the points of the elements
        then follow one another in the order of the elements, (n + 1)^2 of a quad, (n + 1) (n + 2) / 2 of a triangle.
        """
        return Tessellation(**self._data.tessellate(whole_number("subdivision", subdivision), bool(apart)))


class SurfaceMesh(Measured):
    """A mesh from arrays as those of a Result, which may come from a file; the arrays are copied, and
    other threads of Python run meanwhile.

    ValueError when they do not fit together, and for numbers of nodes, faces and edges that are not whole or not from 0.
    """

    def __init__(self, order, nodes, quads, triangles, quad_faces, triangle_faces, lines, line_edges, points=()):
        tables = {"quads": quads, "triangles": triangles, "quad_faces": quad_faces, "triangle_faces": triangle_faces,
                  "lines": lines, "line_edges": line_edges, "points": points}
        self._data = _paver.BareMesh(whole_number("order", order), nodes,
                                     *(whole_numbers(name, table) for name, table in tables.items()))

    def write(self, path, *, face_names=(), edge_names=(), edge_groups=(), point_names=(), volumes=(), msh_version="4.1",
              ascii=False, progress=None, cancel=None):
        """Writes the mesh to `path` (.msh or .vtu, by its ending), whole or not at all, as Result.write does.

        face_names, edge_names: of the faces and edges by number, for groups; without them "Face1", "Edge1".
        edge_groups: by number the group that an edge is in, or an empty text. point_names: of `points`, for groups.
        volumes: as those of a Result.
        """
        files = (encoded_path(path), b"", str(msh_version), bool(ascii), b"", b"", b"")
        self._data.write(files, list(face_names), list(edge_names), list(edge_groups), list(point_names),
                         [(name, medium, list(sides)) for name, medium, sides in volumes], poll_of(progress, cancel))


class PickTree:
    """Search tree over the triangles of a Tessellation: finds in microseconds what lies under the mouse."""

    def __init__(self, tessellation):
        self._tree = _paver.Picker(tessellation.points, tessellation.triangle_indices)

    def hits(self, origin, direction):
        """[(triangle, along)] of all triangles that a ray meets, nearest first: rows of `triangles`, and the factor of
        `direction` with which origin + along * direction is the point."""
        return self._tree.hits(tuple(origin), tuple(direction))
