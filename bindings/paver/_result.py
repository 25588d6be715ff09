"""What a run gives: arrays, report, files."""
import json

from ._arguments import encoded_path
from ._jobs import poll_of
from ._surface_mesh import Measured


def of_data(name, doc):
    """A property of the compiled module's MeshData, passed on."""
    return property(lambda self: getattr(self._data, name), doc=doc)


class Result(Measured):
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
        shape's count of edges on are edges that Paver added, or pieces, see `edge_names`.""")
    further_edges = of_data("further_edges", """(k, 2) int32: (line, edge) where edges of
        the shape were sewn to one: those that a line lies on besides its own of `line_edges`.""")
    node_edges = of_data("node_edges", "(n,) int32: an edge each node lies on, or -1.")
    points = of_data("points", """(k,) int32: rows of `nodes` that are vertices which end no edge, feed points for
        instance, or vertices of ports.""")
    node_targets = of_data("node_targets", "(n,) float64: target length at each corner node, mm; 0 at the others.")
    face_names = of_data("face_names", 'Name of each face in the file, else "Face12".')
    edge_names = of_data("edge_names", """"Edge7"; "Added1" for edges that Paver added; "Junction1" for pieces of an edge
        where more than two faces meet, if its other pieces are ordinary.""")
    face_groups = of_data("face_groups", "The port that each face is in, which is its group in mesh files; else empty.")
    edge_groups = of_data("edge_groups", """Group of each edge in mesh files: the port or wire it was named in, the name
        of the wire it is of ("Wire1"), "Junctions" where more than two faces meet, else empty.""")
    point_names = of_data("point_names", """Name of each of `points`, which is its group in mesh files: "Point1", or the
        port it is in.""")
    volumes = of_data("volumes", """[(name, medium, sides)] of the solids that have a medium: "Solid2", "FR4", and numbers
        from 1 of the faces that bound it, negative where the outward normal looks into the solid.""")

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

    def write(self, path=None, *, report=None, msh_version="4.1", ascii=False, progress=None, cancel=None):
        """Writes the mesh to `path` (.msh or .vtu, by its ending), the report (JSON) to `report`: whole or not at all.

        msh_version: "4.1" or "2.2"; ascii: text instead of binary. OptionError for another ending and for the path of
        the model itself, OutputError when a file cannot be written.
        """
        self._write(file_arguments(self._model, path, report, msh_version, ascii), progress, cancel)

    def _write(self, files, progress, cancel):
        self._data.write(files, poll_of(progress, cancel))
        self._report = None


def file_arguments(model, path, report, msh_version, is_ascii, repaired=None, repaired_text=b""):
    """As the compiled module wants them."""
    path, report, repaired = (encoded_path(name) if name is not None else b"" for name in (path, report, repaired))
    return path, report, str(msh_version), bool(is_ascii), encoded_path(model.path), repaired, repaired_text
