"""Gmsh .msh files (4.1 and 2.2, ASCII and binary, Lagrange order 1 and 2) for pictures and tests, by the workbench's reader.

Shares no code with the mesher on purpose: tests read its files with this.
"""
from dataclasses import dataclass, field
import os
import sys

import numpy as np

sys.path.append(os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "Workbench"))
from paver_wb.formats import read_msh  # noqa: E402

# Gmsh element type: (kind, order, nodes). Order 2 quads have 9 nodes, triangles 6, lines 3.
TYPES = {1: ("line", 1, 2), 2: ("triangle", 1, 3), 3: ("quad", 1, 4), 8: ("line", 2, 3), 9: ("triangle", 2, 6),
         10: ("quad", 2, 9), 15: ("point", 1, 1)}


@dataclass
class Mesh:
    """Nodes (n x 3, mm) and elements as 0-based node indices, Gmsh's node order; `*_tag` is the face or edge number."""
    order: int = 1
    nodes: np.ndarray = None
    quads: np.ndarray = None
    quad_tag: np.ndarray = None
    triangles: np.ndarray = None
    triangle_tag: np.ndarray = None
    lines: np.ndarray = None
    line_tag: np.ndarray = None
    names: dict = field(default_factory=dict)  # (dimension, physical number): name
    physical: dict = field(default_factory=dict)  # (dimension, tag): physical number


def read(path):
    """The mesh in `path`. Raises ValueError when it is not a .msh file this reader knows."""
    with open(path, "rb") as file:
        data = file.read()
    try:
        found = read_msh.sections(data, {kind: nodes for kind, (_, _, nodes) in TYPES.items()})
        return assemble(found)
    except (IndexError, OverflowError) as error:
        raise ValueError(f"its data are damaged ({error})") from None


def assemble(sections):
    if sections.nodes is None:
        raise ValueError("it is no .msh file, it has no $Nodes")
    (tags, points), blocks = sections.nodes, sections.blocks
    if len(tags) != sections.totals["$Nodes"]:
        raise ValueError("the number of nodes does not fit")
    if sum(len(rows) for *_, rows in blocks) != sections.totals.get("$Elements", 0):
        raise ValueError("the number of elements does not fit")
    mesh = Mesh(nodes=points, names=sections.names, physical=sections.physical)
    index = np.full(int(tags.max()) + 1 if len(tags) else 1, -1, np.int64)
    index[tags] = np.arange(len(tags))
    found = {"quad": [], "triangle": [], "line": []}
    mesh.order = max([TYPES[kind][1] for kind, *_ in blocks], default=1)
    for kind, tag, number, table in blocks:
        name = TYPES[kind][0]
        if number:
            mesh.physical[{"line": 1, "triangle": 2, "quad": 2}.get(name, 0), tag] = number
        if name in found:
            rows = index[table]
            if (rows < 0).any():
                raise ValueError("an element uses a node that is not there")
            found[name].append((rows, np.full(len(rows), tag)))
    widths = {"quad": (mesh.order + 1)**2, "triangle": (mesh.order + 1) * (mesh.order + 2) // 2, "line": mesh.order + 1}
    for name, plural in (("quad", "quads"), ("triangle", "triangles"), ("line", "lines")):
        rows = [r for r, _ in found[name]] or [np.zeros((0, widths[name]), np.int64)]
        setattr(mesh, plural, np.concatenate(rows))
        setattr(mesh, name + "_tag", np.concatenate([t for _, t in found[name]] or [np.zeros(0, np.int64)]))
    return mesh


def sides(mesh):
    """Every element side as a row (start, end[, middle]), and its element's number, quads first."""
    found, number, first = [], [], 0
    for rows, corners in ((mesh.quads, 4), (mesh.triangles, 3)):
        for k in range(corners):
            columns = [k, (k + 1) % corners] + ([corners + k] if mesh.order == 2 else [])
            found.append(rows[:, columns])
            number.append(first + np.arange(len(rows)))
        first += len(rows)
    return np.concatenate(found), np.concatenate(number)


def scaled_jacobian(mesh):
    """Straight-sided scaled Jacobian of every quad and of every triangle (definition: core/docs/quality.md)."""
    values = []
    for corners, rows, scale in ((4, mesh.quads, 1.0), (3, mesh.triangles, 2 / np.sqrt(3))):
        p = mesh.nodes[rows[:, :corners]]
        side = np.roll(p, -1, 1) - p
        back = np.roll(p, 1, 1) - p
        normal = np.cross(p[:, 1:-1] - p[:, :1], p[:, 2:] - p[:, :1]).sum(1)
        normal /= np.maximum(np.linalg.norm(normal, axis=1, keepdims=True), 1e-300)
        lengths = np.linalg.norm(side, axis=2) * np.linalg.norm(back, axis=2)
        sj = np.einsum("eci,ei->ec", np.cross(side, back), normal) / np.maximum(lengths, 1e-300)
        values.append(scale * sj.min(1) if len(rows) else np.zeros(0))
    return values
