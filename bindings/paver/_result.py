"""What a run gives: arrays, report, files."""
import json
import os
from typing import NamedTuple

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

    points: (k, 3) float32, mm; shared within a B-rep face, not between faces.
    normals: (k, 3) float32, outward, of unit length.
    triangles: (t, 3) int32, rows of `points`, counter-clockwise seen from outside.
    triangle_elements: (t,) int32, the element of each triangle; quads come first, then triangles.
    outlines: (e, n + 1) int32, every mesh edge once, as rows of `points`.
    outline_edges: (e,) int32, the B-rep edge (0: Edge1) that the mesh edge lies on, or -1.
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


def of_data(name, doc):
    """A property of the compiled module's MeshData, passed on."""
    return property(lambda self: getattr(self._data, name), doc=doc)


class Result:
    """A mesh with its report.

    Arrays are read-only and look straight into Paver's memory; each stays valid on its own, also when the result is
    gone. Faces and edges count from 0 in FreeCAD's order: 0 is Face1, Edge1 of the shape that was passed. p is `order`.
    """

    def __init__(self, data, model):
        self._data, self._model = data, model
        self._report = None

    def __repr__(self):
        quads, triangles = len(self.quads), len(self.triangles)
        return f"<paver.Result of {self._model.name!r}: {quads} quads, {triangles} triangles, order {self.order}>"

    order = of_data("order", "Order p of the elements.")
    nodes = of_data("nodes", "(n, 3) float64: coordinates, mm.")
    quads = of_data("quads", """(q, (p + 1)^2) int32: rows of `nodes`, in Gmsh's order:
        corners, inner nodes of each side in turn, then the inside. Counter-clockwise seen from outside.""")
    triangles = of_data("triangles", "(t, (p + 1) (p + 2) / 2) int32: rows of `nodes`, ordered likewise.")
    lines = of_data("lines", "(l, p + 1) int32: pieces of B-rep edges, rows of `nodes`: ends, then inner nodes.")
    quad_faces = of_data("quad_faces", "(q,) int32: face of each quad.")
    triangle_faces = of_data("triangle_faces", "(t,) int32: face of each triangle.")
    line_edges = of_data("line_edges", """(l,) int32: edge of each line. Numbers from the
        shape's count of edges on are edges that Paver added, see `edge_names`.""")
    further_edges = of_data("further_edges", """(k, 2) int32: (line, edge) where edges of
        the shape were sewn to one: those that a line lies on besides its own of `line_edges`.""")
    node_edges = of_data("node_edges", "(n,) int32: an edge each node lies on, or -1.")
    node_targets = of_data("node_targets", "(n,) float64: target length at each corner node, mm; 0 at the others.")
    face_names = of_data("face_names", 'Name of each face in the file, else "Face12".')
    edge_names = of_data("edge_names", '"Edge7", or "Added1" for edges that Paver added.')

    @property
    def report(self):
        """The report as a dict: the same as the command line's JSON. Keys: core/docs/quality.md."""
        if self._report is None:
            self._report = json.loads(self._data.report_json())
        return self._report

    @property
    def table(self):
        """The report as lines of text."""
        return self._data.report_table()

    @property
    def failed_faces(self):
        """{"Face12": reason} of the faces that could not be meshed."""
        return {face["name"]: face["reason"] for face in self.report["faces"] if face["status"] == "failed"}

    @property
    def parts(self):
        """A Part for every shape of the list that was passed, or member of the compound that was read."""
        return self._model.parts()

    def quality(self):
        """ElementQuality: figures of every element, measured at the first call."""
        return ElementQuality(**self._data.quality())

    def tessellate(self, subdivision=2):
        """Tessellation with every element side cut in `subdivision` pieces, 1 to 32. OptionError outside of that."""
        return Tessellation(**self._data.tessellate(subdivision))

    def write(self, path=None, *, report=None, msh_version="4.1", ascii=False, progress=None, cancel=None):
        """Writes the mesh to `path` (.msh or .vtu, by its ending), the report (JSON) to `report`: whole or not at all.

        msh_version: "4.1" or "2.2"; ascii: text instead of binary. OptionError for another ending and for the path of
        the model itself, OutputError when a file cannot be written.
        """
        files = file_arguments(self._model, path, report, msh_version, ascii)
        self._data.write(files, poll_of(progress, cancel))
        self._report = None


def file_arguments(model, path, report, msh_version, is_ascii):
    """As the compiled module wants them."""
    names = [os.fsencode(name) if name is not None else b"" for name in (path, report)]
    return (*names, str(msh_version), bool(is_ascii), os.fsencode(model.path))
