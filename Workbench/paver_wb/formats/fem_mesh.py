"""FreeCAD's FemMesh of a stored mesh: tri3, tri6, quad4 and quad8 with a group of faces for each B-rep face, seg2 and seg3
with a group of edges for each wire, port and for junctions, a group of faces for each port that has some, and a group of nodes for
each vertex that ends no edge and the vertices of each port.

FreeCAD has no quad9: the node in the middle is left out. Elements have the numbers 1, 2, ..., quads first, as in Paver, lines
last; nodes are numbered without gaps. Faces go through a VTU file with raw data, the fastest way in: one call for each
element from Python takes about five times as long, and UNV more. FreeCAD reads no lines from it; of those there are few.
"""
import os
import tempfile

import numpy as np

from paver_wb.base import quiet
from paver_wb.formats import mesh_file

VTK_TYPES = {("quad", 1): (9, 4), ("quad", 2): (23, 8), ("triangle", 1): (5, 3), ("triangle", 2): (22, 6)}
GROUPED = (".unv", ".med")  # formats that hold groups, without which lines of ports and junctions are only in the way
ALL_ELEMENTS = 0  # of FreeCAD's writer of .inp


class NoFemMesh(ValueError):
    """FreeCAD's FemMesh cannot hold the mesh. The text is one sentence."""


class Incomplete(ValueError):
    """A file does not hold what was to be written. The text is one sentence."""


def serendipity(mesh):
    """(quads, triangles): corner and mid-side nodes, in the order of Gmsh, VTK and FreeCAD alike."""
    if mesh.order > 2:
        raise NoFemMesh(f"FreeCAD's FemMesh has no elements of order {mesh.order}; mesh with order 1 or 2.")
    return [np.asarray(rows)[:, :VTK_TYPES[kind, mesh.order][1]]
            for kind, rows in (("quad", mesh.quads), ("triangle", mesh.triangles))]


def numbered(mesh, lines):
    """lines: {name: rows of nodes}. (points, quads, triangles, {name: lines}, {name: nodes of vertices}) with only the nodes that these use."""
    quads, triangles = serendipity(mesh)
    is_used = mesh_file.used_nodes(len(mesh.nodes), quads, triangles, *lines.values())
    number = np.cumsum(is_used) - 1
    return (np.asarray(mesh.nodes)[is_used], number[quads], number[triangles],
            {name: number[rows] for name, rows in lines.items()},
            {name: [int(number[node]) for node in nodes if is_used[node]] for name, nodes in mesh_file.points(mesh).items()})


def write_vtu(path, points, blocks):
    """blocks: (VTK type, (n, k) rows of `points`) in order."""
    offsets = np.cumsum(np.concatenate([np.full(len(rows), rows.shape[1]) for _, rows in blocks]))
    arrays = [("Float64", "Points", 3, np.ascontiguousarray(points, "<f8")),
              ("Int64", "connectivity", 1, np.concatenate([rows.ravel() for _, rows in blocks]).astype("<i8")),
              ("Int64", "offsets", 1, offsets.astype("<i8")),
              ("UInt8", "types", 1, np.concatenate([np.full(len(rows), kind) for kind, rows in blocks]).astype("u1"))]
    tags, at = [], 0
    for kind, name, components, array in arrays:
        tags.append(f'<DataArray type="{kind}" Name="{name}" NumberOfComponents="{components}" format="appended" '
                    f'offset="{at}"/>')
        at += 8 + array.nbytes
    head = ('<?xml version="1.0"?><VTKFile type="UnstructuredGrid" version="1.0" byte_order="LittleEndian" '
            f'header_type="UInt64"><UnstructuredGrid><Piece NumberOfPoints="{len(points)}" '
            f'NumberOfCells="{len(offsets)}"><Points>{tags[0]}</Points><Cells>{"".join(tags[1:])}</Cells></Piece>'
            '</UnstructuredGrid><AppendedData encoding="raw">_')
    with open(path, "wb") as file:
        file.write(head.encode())
        for _, _, _, array in arrays:
            file.write(np.array([array.nbytes], "<u8").tobytes())
            file.write(array.tobytes())
        file.write(b"</AppendedData></VTKFile>")


def memory_folder():
    """A folder in memory where the system has one."""
    folder = "/dev/shm"
    return folder if os.path.isdir(folder) and os.access(folder, os.W_OK) else None


def add_elements(fem, groups, kind="Face"):
    """Groups of elements, or with the kind "Node" of nodes: {name: numbers}."""
    with quiet.output():
        for name, members in groups.items():
            fem.addGroupElements(fem.addGroup(name, kind), members)


def add_groups(fem, mesh, groups):
    """A group for each face that has elements, and those of `groups`, {name: numbers of faces}."""
    faces = np.concatenate([mesh.quad_faces, mesh.triangle_faces])
    order = np.argsort(faces, kind="stable")
    present, starts = np.unique(faces[order], return_index=True)
    found = {mesh.face_names[face]: members.tolist() for face, members in zip(present, np.split(order + 1, starts[1:]))}
    for name, wanted in groups.items():
        members = np.flatnonzero(np.isin(faces, list(wanted))) + 1
        if len(members):
            found[name] = members.tolist()
    add_elements(fem, found)


def add_wires(fem, wires, first):
    """A group for each of `wires`, {name: rows of nodes}; the lines are elements from the number `first` on."""
    found = {}
    for name, lines in wires.items():
        for number, nodes in enumerate((lines + 1).tolist(), first):
            fem.addEdge(nodes, number)
        found[name] = list(range(first, first + len(lines)))
        first += len(lines)
    add_elements(fem, found, "Edge")


def write(mesh, groups, path):
    """Writes a StoredMesh in a format of FreeCAD's, by the ending of `path`; `groups` as in of_mesh.

    NoFemMesh where the format cannot hold the mesh, Incomplete where what was written is not all of it.
    """
    ending = os.path.splitext(path)[1].lower()
    fem = of_mesh(mesh, groups, None if ending in GROUPED else mesh_file.wires(mesh))
    check_format(ending, mesh.order, fem)
    if ending == ".inp":
        fem.writeABAQUS(path, ALL_ELEMENTS, False)  # write() would leave out the lines of wires beside faces
    else:
        fem.write(path)
    wanted, found = counts(fem, ending), counts_in(path, ending)
    if found != wanted:
        raise Incomplete(f"{os.path.basename(path)} cannot be written: read back it has (nodes, faces, lines) {found} instead "
                         f"of {wanted}; make room on the disk, or use .msh or .vtu.")


def check_format(ending, order, fem):
    """NoFemMesh for what FreeCAD writes wrongly, or not at all: empty files, and it ends at an STL file without faces."""
    if ending == ".z88" and order == 1 and fem.FaceCount:
        raise NoFemMesh("FreeCAD writes no faces of order 1 to .z88; mesh with order 2, or use another format.")
    if ending == ".z88" and fem.FaceCount and fem.EdgeCount:
        raise NoFemMesh("FreeCAD writes no wires beside faces to .z88; use .msh, .unv, .med or .inp.")
    if ending == ".stl" and not fem.FaceCount:
        raise NoFemMesh("An .stl file holds faces, and this mesh has none; use .msh or .unv.")


def counts(fem, ending):
    """(nodes, faces, lines) of a FemMesh as a file of it has them; of an STL file only the triangles."""
    if ending == ".stl":
        is_curved = len(fem.getElementNodes(fem.Faces[0])) > 4
        return (0, (6 if is_curved else 2) * fem.QuadrangleCount + (4 if is_curved else 1) * fem.TriangleCount, 0)
    return fem.NodeCount, fem.FaceCount, fem.EdgeCount


def counts_in(path, ending):
    """The same of a file."""
    import Fem
    if not os.path.isfile(path) or not os.path.getsize(path):
        return 0, 0, 0
    if ending == ".stl":
        size, (count,) = os.path.getsize(path), np.fromfile(path, "<u4", 1, offset=80)
        return 0, int(count) if size == 84 + 50 * int(count) else 0, 0
    if ending == ".dat":
        with open(path, encoding="ascii", errors="replace") as file:
            nodes, elements = map(int, file.readline().split())
            kinds = [line.split()[1:2] for line in file if line.endswith("\n")][nodes:]
        lines = sum(kind[0].startswith("1") for kind in kinds if kind)
        return (nodes, elements - lines, lines) if len(kinds) == elements else (0, 0, 0)
    with quiet.output():
        fem = Fem.read(path)
    return counts(fem, ending)


def empty():
    import Fem
    return Fem.FemMesh()


def of_mesh(mesh, groups, lines=None):
    """Fem.FemMesh of a StoredMesh, with `groups`, {name: numbers of faces}, besides one for each face, port and vertex that ends
    no edge, and for each of `lines`, {name: rows of nodes}: None: of wires, ports and junctions.

    NoFemMesh for orders that FreeCAD does not have.
    """
    lines = mesh_file.line_groups(mesh, True) if lines is None else lines
    points, quads, triangles, wires, vertices = numbered(mesh, lines)
    blocks = [(VTK_TYPES[kind, mesh.order][0], rows) for kind, rows in (("quad", quads), ("triangle", triangles))
              if len(rows)]
    fem = of_faces(points, blocks) if blocks else of_points(points)
    add_groups(fem, mesh, {**groups, **mesh_file.port_faces(mesh)})
    add_wires(fem, wires, len(quads) + len(triangles) + 1)
    add_elements(fem, {name: [node + 1 for node in nodes] for name, nodes in vertices.items()}, "Node")
    return fem


def of_faces(points, blocks):
    """A FemMesh without groups; blocks as write_vtu takes them."""
    import Fem
    with tempfile.TemporaryDirectory(prefix="paver", dir=memory_folder()) as folder:
        path = os.path.join(folder, "mesh.vtu")
        write_vtu(path, points, blocks)
        return Fem.read(path)


def of_points(points):
    """A FemMesh of nodes without elements."""
    fem = empty()
    for number, point in enumerate(points.tolist(), 1):
        fem.addNode(*point, number)
    return fem
