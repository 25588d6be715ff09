"""A surface mesh as a file has it, and how it becomes one of Paver's: order 1 or 2, all elements of one order."""
from typing import NamedTuple

import numpy as np

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
    used = np.unique(np.concatenate([rows[3].ravel(), rows[4].ravel()]))
    number = np.full(len(points), -1, np.int64)
    number[used] = np.arange(len(used))
    return Tables(order, points[used], number[rows[4]].astype(np.int32), number[rows[3]].astype(np.int32),
                  faces[4].astype(np.int32), faces[3].astype(np.int32), names)


class Builder:
    """Adds the nodes that elements lack: middles of sides, shared between neighbours, and of quads."""

    def __init__(self, points, order):
        self.known, self.order, self.added, self.sides = points, order, [], {}

    def points(self):
        return np.concatenate([self.known, np.array(self.added)]) if self.added else self.known

    def point(self, number):
        return self.known[number] if number < len(self.known) else self.added[number - len(self.known)]

    def add(self, point):
        self.added.append(point)
        return len(self.known) + len(self.added) - 1

    def middle(self, a, b):
        key = (a, b) if a < b else (b, a)
        if key not in self.sides:
            self.sides[key] = self.add(0.5 * (self.point(a) + self.point(b)))
        return self.sides[key]

    def full(self, kind, rows):
        """Rows with all nodes of the mesh's order."""
        if self.order == 1 or kind in ("tri6", "quad9"):
            return rows
        if kind in ("tri3", "quad4"):
            corners = CORNERS[kind]
            rows = np.array([[*row, *(self.middle(row[k], row[(k + 1) % corners]) for k in range(corners))]
                             for row in rows.tolist()])
        if kind in ("quad8", "quad4"):
            centres = []
            for row in rows.tolist():
                p = [self.point(n) for n in row]
                centres.append([self.add(0.5 * sum(p[4:8]) - 0.25 * sum(p[:4]))])
            rows = np.concatenate([rows, np.array(centres)], axis=1)
        return rows
