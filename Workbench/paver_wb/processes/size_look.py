"""Target lengths over the faces of a model before it is meshed: triangles with a length at each corner."""
import os
import tempfile

import numpy as np

from paver_wb import core

MOST_TRIANGLES = 40000
PIECES = 50  # of the model's diagonal: how long sides of triangles are at most, or more where they would be too many
CHORD = 0.004  # distance of triangles from their face, of the model's diagonal
MOST_SPLIT = 16  # of a side of one triangle
POLE = 1e-6  # mm: size of what is one point
SAME = 1e-8  # of the model's diagonal: nearer places are one


def original(job):
    """The Part.Shape of a mesh_job.Job, as FreeCAD has it."""
    import Part
    shape = Part.Shape()
    with tempfile.TemporaryDirectory(prefix="paver") as folder:
        path = os.path.join(folder, "shape.bin")
        with open(path, "wb") as file:
            file.write(job.shape)
        shape.importBinary(path)
    return shape


def split(corners, values, longest):
    """What (n, 3, 3) triangles have at their corners, (n, 3, k), on such with sides up to `longest`: each cut by itself."""
    sides = np.linalg.norm(corners - np.roll(corners, -1, axis=1), axis=2).max(axis=1)
    pieces = np.clip(np.ceil(sides / longest), 1, MOST_SPLIT).astype(int)
    return np.concatenate([grid(values[pieces == count], count) for count in np.unique(pieces)]) if len(corners) else values


def grid(values, count):
    """Each triangle cut into count^2, what it has at its corners linear over it."""
    a, b, c = (values[:, k] for k in range(3))

    def at(i, j):
        return a + (i / count) * (b - a) + (j / count) * (c - a)
    made = []
    for i in range(count):
        for j in range(count - i):
            made.append(np.stack([at(i, j), at(i + 1, j), at(i, j + 1)], axis=1))
            if i + j < count - 1:
                made.append(np.stack([at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)], axis=1))
    return np.concatenate(made)


def tessellated(face, chord):
    """(n, 3) points and (m, 3) numbers of them, triangles."""
    points, triangles = face.tessellate(chord)
    return np.array([tuple(point) for point in points]).reshape(-1, 3), np.array(triangles, np.int64).reshape(-1, 3)


class Axis:
    """One of the two parameters of a surface: what the parameters of a triangle's corners are beside each other.
    A point on the seam of a surface that closes has two of them, a pole all."""

    def __init__(self, surface, axis):
        low, high = surface.bounds()[2 * axis:2 * axis + 2]
        self.surface, self.axis, self.low, self.high = surface, axis, low, high
        self.is_periodic = surface.isVPeriodic() if axis else surface.isUPeriodic()
        self.is_closed = self.is_periodic or (surface.isVClosed() if axis else surface.isUClosed())

    def poles(self, uv):
        """Which of the (n, 2) parameters are where the surface shrinks to a point along this axis."""
        if not self.is_closed:
            return np.zeros(len(uv), bool)
        across = 1 - self.axis
        at_pole = {}
        for value in np.unique(uv[:, across]):
            places = [(along, value) if across else (value, along) for along in np.linspace(self.low, self.high, 4)[:3]]
            points = np.array([tuple(self.surface.value(*place)) for place in places])
            at_pole[value] = np.ptp(points, axis=0).max() < POLE
        return np.array([at_pole[value] for value in uv[:, across]], bool)

    def joined(self, corners, poles):
        """(m, 3) parameters of triangles' corners and whether these are poles: the same beside each other."""
        if not self.is_closed:
            return corners
        period, rows = self.high - self.low, np.arange(len(corners))
        off_middle = np.abs((corners - self.low) % period - period / 2) + np.where(poles, period, 0)
        middle = corners[rows, off_middle.argmin(axis=1)][:, None]
        corners = corners + period * np.round((middle - corners) / period)
        if not self.is_periodic:
            corners = np.clip(corners, self.low, self.high)
        others = np.where(poles, 0, corners).sum(axis=1) / np.maximum(3 - poles.sum(axis=1), 1)
        return np.where(poles, others[:, None], corners)

    def within(self, values):
        """The same parameters within the bounds."""
        return self.low + (values - self.low) % (self.high - self.low) if self.is_periodic else values


def keys(points, diagonal):
    """What places that are one have in common."""
    return [tuple(key) for key in np.round(np.reshape(points, (-1, 3)) / (SAME * diagonal))]


def nodes(face, diagonal):
    """(u, v) of the nodes of a tessellated face by the keys of their places."""
    uv = face.getUVNodes()
    return dict(zip(keys([tuple(face.Surface.value(*node)) for node in uv], diagonal), uv))


def parameters(face, points, triangles, longest, diagonal):
    """(n, 2) of the corners of triangles on a tessellated face, split to `longest`. They are searched for, which takes
    long on splines, only where no node of the tessellation lies at its own parameters, as one on an edge may not."""
    import FreeCAD
    surface, known = face.Surface, nodes(face, diagonal)
    uv = np.array([known.get(key) or surface.parameter(FreeCAD.Vector(*point))
                   for key, point in zip(keys(points, diagonal), points.tolist())]).reshape(-1, 2)
    axes = Axis(surface, 0), Axis(surface, 1)
    joined = np.stack([axis.joined(uv[triangles, axis.axis], axis.poles(uv)[triangles]) for axis in axes], axis=2)
    fine = split(points[triangles], joined, longest).reshape(-1, 2)
    return np.stack([axis.within(fine[:, axis.axis]) for axis in axes], axis=1)


def sizes(model, shape, options):
    """((n, 3, 3) float32 corners of triangles over all faces that will be meshed, (n, 3) float32 target lengths there, mm).
    model: paver.Model of the shape. Errors as in paver.mesh."""
    diagonal = max(shape.BoundBox.DiagonalLength, 1e-9)
    coarse = [tessellated(face, CHORD * diagonal) for face in shape.Faces]
    corners = [points[triangles] for points, triangles in coarse]
    area = sum(np.linalg.norm(np.cross(t[:, 1] - t[:, 0], t[:, 2] - t[:, 0]), axis=1).sum() / 2 for t in corners)
    longest = max(diagonal / PIECES, (4 * area / MOST_TRIANGLES) ** 0.5)
    faces, uv, points = [], [], []
    for number, (face, (at, triangles)) in enumerate(zip(shape.Faces, coarse)):
        surface = face.Surface
        fine = parameters(face, at, triangles, longest, diagonal).tolist()
        faces += [number] * len(fine)
        uv += fine
        points += [tuple(surface.value(u, v)) for u, v in fine]
    points = np.array(points).reshape(-1, 3)
    lengths = core.load().target_lengths(model, faces, np.array(uv).reshape(-1, 2), points, **options)
    corners, lengths = points.reshape(-1, 3, 3).astype(np.float32), lengths.reshape(-1, 3).astype(np.float32)
    is_meshed = (lengths > 0).all(axis=1)
    return corners[is_meshed], lengths[is_meshed]
