"""A surface mesh as a file has it, and how it becomes one of Paver's: order 1 or 2, all elements of one order."""
from typing import NamedTuple

import numpy as np

from paver_wb.formats import mesh_file

CORNERS = {"tri3": 3, "tri6": 3, "quad4": 4, "quad8": 4, "quad9": 4}


class Damaged(ValueError):
    """A file cannot be read. The text goes on from "NAME cannot be read: "."""


class RawMesh(NamedTuple):
    """points: (n, 3); tags: (n,) numbers of the nodes; blocks: [(kind, rows of node tags, name of the group)], in the
    order of Gmsh and VTK: corners, middles of the sides, middle."""

    points: object
    tags: object
    blocks: list


class Tables(NamedTuple):
    order: int
    nodes: object
    quads: object
    triangles: object
    quad_faces: object
    triangle_faces: object
    names: list


def save(tables, path):
    """For load(), in another process."""
    np.savez(path, **{name: np.array(value) for name, value in tables._asdict().items()})


def load(path):
    made = np.load(path)
    arrays = {name: made[name] for name in Tables._fields}
    return Tables(**{**arrays, "order": int(made["order"]), "names": made["names"].tolist()})


def tables(raw):
    """Tables with only the nodes that elements use. Damaged without surface elements."""
    blocks = [(kind, rows, name) for kind, rows, name in raw.blocks if len(rows)]
    if not blocks:
        raise Damaged("it has no triangles and no quads")
    names = list(dict.fromkeys(name for _, _, name in blocks))
    index = np.full(int(raw.tags.max()) + 1, -1, np.int64)
    index[raw.tags] = np.arange(len(raw.tags))
    for _, rows, _ in blocks:
        if rows.min() < 0 or rows.max() >= len(index) or (index[rows] < 0).any():
            raise Damaged("an element uses a node that is not there")
    order = 2 if any(kind in ("tri6", "quad8", "quad9") for kind, _, _ in blocks) else 1
    builder = Builder(np.asarray(raw.points, float), order)
    parts = {3: [], 4: []}
    for kind, rows, name in blocks:
        parts[CORNERS[kind]].append((builder.full(kind, index[rows]), np.full(len(rows), names.index(name))))
    return packed(order, builder.points(), parts, names)


def packed(order, points, parts, names):
    """Tables without unused nodes."""
    widths = {3: 3 * order, 4: (order + 1) ** 2}
    rows = {n: np.concatenate([r for r, _ in parts[n]] or [np.zeros((0, widths[n]), np.int64)]) for n in (3, 4)}
    faces = {n: np.concatenate([f for _, f in parts[n]] or [np.zeros(0, np.int64)]) for n in (3, 4)}
    is_used = mesh_file.used_nodes(len(points), rows[3], rows[4])
    number = np.cumsum(is_used) - 1
    return Tables(order, points[is_used], number[rows[4]].astype(np.int32), number[rows[3]].astype(np.int32),
                  faces[4].astype(np.int32), faces[3].astype(np.int32), names)


class Builder:
    """Adds the nodes that elements lack: middles of sides, shared between neighbours, and of quads."""

    def __init__(self, points, order):
        self.known, self.order, self.added, self.sides = points, order, [], {}
        self.count = len(points)

    def points(self):
        return np.concatenate([self.known, *self.added])

    def add(self, points):
        """Numbers of new nodes at (n, 3) points."""
        self.added.append(points)
        self.count += len(points)
        return np.arange(self.count - len(points), self.count)

    def middles(self, ends):
        """Nodes in the middles of (n, 2) pairs of corners of the file, those of before where a pair comes again."""
        keys = [(a, b) if a < b else (b, a) for a, b in ends.tolist()]
        new = [key for key in dict.fromkeys(keys) if key not in self.sides]
        if new:
            numbers = self.add(0.5 * self.known[np.array(new)].sum(axis=1))
            self.sides.update(zip(new, numbers.tolist()))
        return np.array([self.sides[key] for key in keys], dtype=np.int64)

    def full(self, kind, rows):
        """Rows with all nodes of the mesh's order."""
        if self.order == 1 or kind in ("tri6", "quad9"):
            return rows
        added, around = [], self.known[rows]
        if kind in ("tri3", "quad4"):
            sides = np.stack([rows, np.roll(rows, -1, axis=1)], axis=2).reshape(-1, 2)
            added.append(self.middles(sides).reshape(rows.shape))
        if kind == "quad4":
            added.append(self.add(around.mean(axis=1))[:, None])
        if kind == "quad8":
            added.append(self.add(0.5 * around[:, 4:].sum(axis=1) - 0.25 * around[:, :4].sum(axis=1))[:, None])
        return np.concatenate([rows, *added], axis=1)
