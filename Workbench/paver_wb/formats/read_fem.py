"""Surface elements of the files that FreeCAD's FEM workbench reads."""
import numpy as np

from paver_wb.formats import raw_mesh
from paver_wb.formats.raw_mesh import Damaged

KINDS = {3: "tri3", 4: "quad4", 6: "tri6", 8: "quad8"}


def tables(path):
    """raw_mesh.Tables of a file that FreeCAD reads. Damaged when it does not."""
    import Fem
    try:
        fem = Fem.read(path)
    except Exception as error:
        raise Damaged(str(error).strip().rstrip(".") or "FreeCAD does not read it") from None
    return raw_mesh.tables(of_fem_mesh(fem))


def of_fem_mesh(fem):
    """RawMesh of a Fem.FemMesh; groups of faces that do not share elements name the faces."""
    points = fem.Nodes
    tags = np.fromiter(points, dtype=np.int64, count=len(points))
    name_of = {}
    for group in fem.Groups:
        if fem.getGroupElementType(group) == "Face":
            for element in fem.getGroupElements(group):
                name_of.setdefault(element, fem.getGroupName(group))
    rows = {}
    for element in fem.Faces:
        nodes = fem.getElementNodes(element)
        if len(nodes) in KINDS:
            rows.setdefault((KINDS[len(nodes)], name_of.get(element, "Face1")), []).append(nodes)
    blocks = [(kind, np.array(table, np.int64), name) for (kind, name), table in rows.items()]
    return raw_mesh.RawMesh(np.array([tuple(points[t]) for t in tags.tolist()]).reshape(-1, 3), tags, blocks)
