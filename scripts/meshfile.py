"""Reads Gmsh .msh files (4.1 and 2.2, ASCII and binary, Lagrange order 1 and 2) for pictures and tests.

Shares no code with the mesher on purpose: tests read its files with this.
"""
from dataclasses import dataclass, field
import struct

import numpy as np

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
    version: str = ""


class Reader:
    """Cursor over the bytes of a file: words of a text section, or packed numbers of a binary one."""

    def __init__(self, path):
        with open(path, "rb") as f:
            self.data = f.read()
        self.at = 0
        self.words = None

    def line(self):
        end = self.data.find(b"\n", self.at)
        end = len(self.data) if end < 0 else end
        text, self.at = self.data[self.at:end], end + 1
        return text.decode().strip()

    def begin_text(self, section):
        end = self.data.find(b"$End" + section.encode(), self.at)
        if end < 0:
            raise ValueError(f"${section} has no end")
        self.words, self.word, self.at = self.data[self.at:end].split(), 0, end

    def ints(self, n, kind="i"):
        """n integers; `kind` is their type in binary: i (int), q (size_t)."""
        if self.words is None:
            return self.packed(n, kind)
        self.word += n
        return np.array(self.words[self.word - n:self.word], dtype=np.int64)

    def floats(self, n):
        if self.words is None:
            return self.packed(n, "d")
        self.word += n
        return np.array(self.words[self.word - n:self.word], dtype=float)

    def packed(self, n, kind):
        size = struct.calcsize(kind) * n
        if self.at + size > len(self.data):
            raise ValueError("the file ends too early")
        values = np.frombuffer(self.data, dtype="<" + {"i": "i4", "q": "i8", "d": "f8"}[kind], count=n, offset=self.at)
        self.at += size
        return values if kind == "d" else values.astype(np.int64)


def read(path):
    """The mesh in `path`. Raises ValueError when it is not a .msh file this reader knows."""
    try:
        return parsed(Reader(path))
    except (IndexError, OverflowError, struct.error) as error:
        raise ValueError(f"its data are damaged ({error})") from None


def parsed(r):
    mesh = Mesh()
    nodes, blocks, binary = None, [], False
    while r.at < len(r.data):
        section = r.line()
        if not section.startswith("$") or section.startswith("$End"):
            continue
        section = section[1:]
        if section == "MeshFormat":
            mesh.version, mode, _ = r.line().split()
            binary = mode == "1"
            if binary and struct.unpack("<i", r.data[r.at:r.at + 4])[0] != 1:
                raise ValueError("big-endian .msh files are not read")
            if mesh.version not in ("4.1", "2.2"):
                raise ValueError(f"version {mesh.version} of .msh is not read")
            r.at = r.data.find(b"$EndMeshFormat", r.at)
        elif section == "PhysicalNames":
            for _ in range(int(r.line())):
                dimension, number, name = r.line().split(" ", 2)
                mesh.names[int(dimension), int(number)] = name.strip('"')
        elif section in ("Entities", "Nodes", "Elements"):
            v4 = mesh.version == "4.1"
            r.words = None
            count = 0 if v4 else int(r.line())
            if not binary:
                r.begin_text(section)
            if section == "Entities":
                mesh.physical = entities(r)
            elif section == "Nodes":
                nodes = nodes4(r) if v4 else nodes2(r, count, binary)
            else:
                blocks = elements4(r) if v4 else elements2(r, count, binary)
            r.words = None
            r.at = r.data.find(b"$End", r.at)
    if nodes is None:
        raise ValueError("it is no .msh file, it has no $Nodes")
    return assemble(mesh, nodes, blocks)


def nodes_per(kind):
    """Number of nodes of an element of Gmsh's type `kind`."""
    if int(kind) not in TYPES:
        raise ValueError(f"elements of Gmsh's type {kind} are not read, only surfaces of order 1 and 2")
    return TYPES[int(kind)][2]


def entities(r):
    """(dimension, tag): physical number of every entity that has one."""
    physical = {}
    counts = r.ints(4, "q")
    for dimension in range(4):
        for _ in range(counts[dimension]):
            tag = int(r.ints(1)[0])
            r.floats(3 if dimension == 0 else 6)
            numbers = r.ints(int(r.ints(1, "q")[0]))
            if dimension > 0:
                r.ints(int(r.ints(1, "q")[0]))
            if len(numbers):
                physical[dimension, tag] = int(numbers[0])
    return physical


def nodes4(r):
    blocks, total, _, _ = r.ints(4, "q")
    tags, points = [np.zeros(0, np.int64)], [np.zeros((0, 3))]
    for _ in range(blocks):
        _, _, parametric = r.ints(3)
        if parametric:
            raise ValueError("parametric nodes are not read")
        n = int(r.ints(1, "q")[0])
        tags.append(r.ints(n, "q"))
        points.append(r.floats(3 * n).reshape(n, 3))
    if sum(len(t) for t in tags) != total:
        raise ValueError("the number of nodes does not fit")
    return np.concatenate(tags), np.concatenate(points)


def elements4(r):
    """Blocks (element type, entity tag, None, rows of node tags)."""
    blocks = []
    count, total, _, _ = r.ints(4, "q")
    for _ in range(count):
        _, tag, kind = r.ints(3)
        n, width = int(r.ints(1, "q")[0]), nodes_per(kind) + 1
        blocks.append((int(kind), int(tag), None, r.ints(n * width, "q").reshape(n, width)[:, 1:]))
    if sum(len(b[3]) for b in blocks) != total:
        raise ValueError("the number of elements does not fit")
    return blocks


def nodes2(r, count, binary):
    if binary:
        packed = np.frombuffer(r.data, dtype="<i4, <f8, <f8, <f8", count=count, offset=r.at)
        r.at += packed.nbytes
        return packed["f0"].astype(np.int64), np.stack([packed[f] for f in ("f1", "f2", "f3")], 1)
    table = r.floats(4 * count).reshape(count, 4)
    return table[:, 0].astype(np.int64), table[:, 1:]


def elements2(r, count, binary):
    """Blocks (element type, entity tag, physical number, rows of node tags)."""
    rows = {}
    done = 0
    while done < count:
        if binary:
            kind, n, tags = (int(i) for i in r.ints(3))
            table = r.ints(n * (1 + tags + nodes_per(kind))).reshape(n, -1)[:, 1:]
        else:
            _, kind, tags = (int(i) for i in r.ints(3))
            table, n = r.ints(tags + nodes_per(kind)).reshape(1, -1), 1
        for row in table:
            rows.setdefault((kind, int(row[1]), int(row[0])), []).append(row[tags:])
        done += n
    return [(kind, tag, physical, np.array(table)) for (kind, tag, physical), table in rows.items()]


def assemble(mesh, nodes, blocks):
    tags, mesh.nodes = nodes
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
