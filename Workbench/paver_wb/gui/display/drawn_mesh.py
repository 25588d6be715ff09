"""A stored mesh as it is drawn: figures of every element, points, triangles. Elements count from 0, quads first."""
from functools import cached_property

import numpy as np

from paver_wb import statistics
from paver_wb.formats import mesh_file
from paver_wb.gui.base.background import Offer

MOST_TRIANGLES = 1200000  # of the drawing, where FreeCAD's window still turns it at some frames a second in software
MOST_SUBDIVISION = 8
SAG = 0.003  # of an edge length: what a drawn edge may miss of the curved one


def subdivision_for(elements, sag):
    """Pieces per element side: enough for elements whose edges bulge by `sag` (of their length), few enough to draw."""
    wanted = np.ceil(np.sqrt(max(sag, 0) / SAG))
    allowed = np.floor(np.sqrt(MOST_TRIANGLES / 2 / max(elements, 1)))
    return int(max(1, min(wanted, allowed, MOST_SUBDIVISION)))


def of_file(path, subdivision):
    """The DrawnMesh of a mesh's file with all that every drawing needs; subdivision 0: the one that fits."""
    made = DrawnMesh(mesh_file.read(path))
    made.prepare(subdivision)
    return made


offered = Offer()  # by the path of a mesh's file: the display takes it instead of making its own


class DrawnMesh:
    """Everything is made when it is first asked for."""

    def __init__(self, stored):
        """stored: a StoredMesh."""
        self.stored, self.cut = stored, (0, None)
        self.order, self.face_names = stored.order, mesh_file.labels(stored)
        self.quad_count, self.triangle_count = len(stored.quads), len(stored.triangles)
        self.count = self.quad_count + self.triangle_count
        self.target = float(stored.report.get("target_length") or 0)
        self.core_mesh = statistics.surface_mesh(stored)

    @cached_property
    def faces(self):
        """(elements,): number of the face."""
        return np.concatenate([self.stored.quad_faces, self.stored.triangle_faces])

    @cached_property
    def quality(self):
        """paver.ElementQuality."""
        return self.core_mesh.quality()

    @cached_property
    def corners(self):
        """(elements, 4) rows of nodes; -1 as the fourth of a triangle."""
        made = np.full((self.count, 4), -1, np.int32)
        made[:self.quad_count] = self.stored.quads[:, :4]
        made[self.quad_count:, :3] = self.stored.triangles[:, :3]
        return made

    def following(self, of_corners):
        """What (elements, 4) corners have, at the next corner of each."""
        made = np.roll(of_corners, -1, axis=1)
        made[self.quad_count:, 2] = of_corners[self.quad_count:, 0]
        return made

    @cached_property
    def edge_lengths(self):
        """(elements, 4): chords from corner to corner, mm; NaN as the fourth of a triangle."""
        corners, following, nodes = self.corners, self.following(self.corners), self.stored.nodes
        lengths = np.empty(corners.shape)
        for side in range(4):
            lengths[:, side] = np.linalg.norm(nodes[following[:, side]] - nodes[corners[:, side]], axis=1)
        lengths[self.quad_count:, 3] = np.nan
        return lengths

    @cached_property
    def longest_edges(self):
        """(elements,), mm."""
        return np.fmax.reduce(self.edge_lengths, axis=1) if self.count else np.zeros(0)

    @cached_property
    def edge_targets(self):
        """(elements, 4): target length at each edge, mm, mean of its ends; that of the run where the mesh does not know.
        NaN as the fourth of a triangle."""
        targets = self.stored.node_targets
        if targets is None or not len(targets):
            return np.where(np.isnan(self.edge_lengths), np.nan, self.target)
        ends = targets[self.corners]
        made = (ends + self.following(ends)) / 2
        made[self.quad_count:, 3] = np.nan
        return np.where(made > 0, made, self.target)

    @cached_property
    def centres(self):
        """(elements, 3): means of the corners."""
        nodes, corners = self.stored.nodes, self.corners
        means = np.empty((self.count, 3))
        means[:self.quad_count] = nodes[corners[:self.quad_count]].mean(axis=1)
        means[self.quad_count:] = nodes[corners[self.quad_count:, :3]].mean(axis=1)
        return means

    @cached_property
    def normals(self):
        """(elements, 3): unit vector areas of the corners."""
        nodes, corners = self.stored.nodes, self.corners
        fourth = np.where(corners[:, 3] < 0, corners[:, 0], corners[:, 3])
        made = np.cross(nodes[corners[:, 2]] - nodes[corners[:, 0]], nodes[fourth] - nodes[corners[:, 1]])
        return made / np.maximum(np.linalg.norm(made, axis=1, keepdims=True), 1e-300)

    @cached_property
    def extent(self):
        """(lowest, highest) coordinates of the nodes."""
        nodes = self.stored.nodes
        return (nodes.min(axis=0), nodes.max(axis=0)) if len(nodes) else (np.zeros(3), np.zeros(3))

    @property
    def mean_area(self):
        """Of the elements, mm^2; 0 without any."""
        area = float(self.stored.report.get("quality", {}).get("mesh_area") or self.quality.area.sum())
        return area / self.count if self.count else 0.0

    @cached_property
    def sag(self):
        """How far element edges bulge, of their length: that of all but the worst thousandth."""
        if self.order < 2 or not self.count:
            return 0.0
        inner = (self.order - 1) // 2  # a node about the middle of a side
        nodes, sags = self.stored.nodes, []
        for rows, sides in ((self.stored.quads, 4), (self.stored.triangles, 3)):
            for side in range(sides if len(rows) else 0):
                a, b = nodes[rows[:, side]], nodes[rows[:, (side + 1) % sides]]
                part = (inner + 1) / self.order
                middle = nodes[rows[:, sides + side * (self.order - 1) + inner]]
                length = np.maximum(np.linalg.norm(b - a, axis=1), 1e-300)
                sags.append(np.linalg.norm(middle - (1 - part) * a - part * b, axis=1) / length)
        return float(np.quantile(np.concatenate(sags), 0.999))

    def fitting_subdivision(self):
        """Enough for the curved edges, few enough to draw."""
        return subdivision_for(self.count, self.sag) if subdivision_for(self.count, np.inf) > 1 else 1

    def tessellation(self, subdivision):
        """paver.Tessellation in which no elements share points; the last one is kept."""
        if self.cut[0] != subdivision:
            self.cut = (subdivision, self.core_mesh.tessellate(subdivision, apart=True))
        return self.cut[1]

    @cached_property
    def wire_lines(self):
        """(lines, n + 1, 3): points along each line of a wire, by the polynomial through its nodes."""
        rows = list(mesh_file.line_groups(self.stored).values())
        nodes = self.stored.nodes[np.concatenate(rows)] if rows else np.zeros((0, self.order + 1, 3))
        return np.einsum("sk,lkx->lsx", line_shapes(self.order, MOST_SUBDIVISION if self.order > 1 else 1), nodes)

    def prepare(self, subdivision):
        """Makes what every drawing needs, so that it can be done in a thread; subdivision 0: the one that fits."""
        self.tessellation(subdivision or self.fitting_subdivision())
        return self.quality, self.extent

    def points_per_element(self, subdivision):
        """Of a quad, of a triangle."""
        n = subdivision
        return (n + 1) ** 2, (n + 1) * (n + 2) // 2

    def per_point(self, values, subdivision):
        """One value per element spread to the points of a tessellation."""
        of_quad, of_triangle = self.points_per_element(subdivision)
        return np.concatenate([np.repeat(values[:self.quad_count], of_quad, axis=0),
                               np.repeat(values[self.quad_count:], of_triangle, axis=0)])

    def triangle_rows(self, elements, subdivision):
        """Rows of a tessellation's triangles that elements are cut into."""
        elements, n = np.asarray(elements, np.int64), subdivision
        quads, others = elements[elements < self.quad_count], elements[elements >= self.quad_count]
        of_quads = (quads[:, None] * 2 * n * n + np.arange(2 * n * n)).ravel()
        first = self.quad_count * 2 * n * n
        of_others = (first + (others[:, None] - self.quad_count) * n * n + np.arange(n * n)).ravel()
        return np.concatenate([of_quads, of_others])

    def element_outlines(self, elements, subdivision):
        """Indices of points, one closed line per element ended by -1."""
        elements, n = np.asarray(elements, np.int64), subdivision
        of_quad, of_triangle = self.points_per_element(n)
        quads, others = elements[elements < self.quad_count], elements[elements >= self.quad_count]
        blocks = []
        for numbers, first, size, ring in (
                (quads, 0, of_quad, quad_ring(n)),
                (others - self.quad_count, self.quad_count * of_quad, of_triangle, triangle_ring(n))):
            lines = np.full((len(numbers), len(ring) + 1), -1, np.int64)
            lines[:, :-1] = first + numbers[:, None] * size + ring
            blocks.append(lines.ravel())
        return np.concatenate(blocks).astype(np.int32)

    def shrunk(self, points, factor, subdivision):
        """Points of a tessellation, each element's moved towards their mean."""
        of_quad, of_triangle = self.points_per_element(subdivision)
        made, split = np.array(points), self.quad_count * of_quad
        for block, size in ((made[:split], of_quad), (made[split:], of_triangle)):
            cells = block.reshape(-1, size, 3)
            centres = cells.mean(axis=1, keepdims=True)
            cells[:] = centres + np.float32(factor) * (cells - centres)
        return made


def line_shapes(order, n):
    """(n + 1, order + 1): what each node of a line (ends, then inner ones) weighs at n + 1 even places of it."""
    at = np.concatenate([[0, 1], np.arange(1, order) / order])
    others = at[None, :].repeat(order + 1, axis=0)[~np.eye(order + 1, dtype=bool)].reshape(order + 1, order)
    places = np.linspace(0, 1, n + 1)[:, None, None]
    return np.prod((places - others) / (at[:, None] - others), axis=2)


def quad_ring(n):
    """Points around a quad's lattice of rows of n + 1, closed."""
    w, steps = n + 1, np.arange(n)
    return np.concatenate([steps, n + steps * w, n * w + n - steps, (n - steps) * w, [0]])


def triangle_ring(n):
    """The same of a triangle's lattice with rows of n + 1, n, ..., 1 points."""
    starts = np.concatenate([[0], np.cumsum(np.arange(n + 1, 0, -1))])[:n + 1]
    lengths, steps = np.arange(n + 1, 0, -1), np.arange(n)
    return np.concatenate([steps, (starts + lengths - 1)[:n], starts[::-1][:n], [0]])
