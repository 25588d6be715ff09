"""Target lengths over the faces of a model before it is meshed: triangles with a length at each corner."""
import os
import tempfile

import numpy as np

from paver_wb import core

MOST_TRIANGLES = 40000
PIECES = 50  # of the model's diagonal: how long sides of triangles are at most, or more where they would be too many
CHORD = 0.004  # distance of triangles from their face, of the model's diagonal
MOST_SPLIT = 16  # of a side of one triangle


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


def split(corners, longest):
    """(n, 3, 3) triangles cut into such with sides up to `longest`, each by itself."""
    sides = np.linalg.norm(corners - np.roll(corners, -1, axis=1), axis=2).max(axis=1)
    pieces = np.clip(np.ceil(sides / longest), 1, MOST_SPLIT).astype(int)
    return np.concatenate([grid(corners[pieces == count], count) for count in np.unique(pieces)]) if len(corners) else corners


def grid(corners, count):
    """Each triangle cut into count^2."""
    a, b, c = (corners[:, k] for k in range(3))

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
    points, triangles = face.tessellate(chord)
    points = np.array([tuple(point) for point in points]).reshape(-1, 3)
    return points[np.array(triangles, np.int64).reshape(-1, 3)]


def sizes(model, shape, options):
    """((n, 3, 3) float32 corners of triangles over all faces that will be meshed, (n, 3) float32 target lengths there, mm).
    model: paver.Model of the shape. Errors as in paver.mesh."""
    import FreeCAD
    diagonal = max(shape.BoundBox.DiagonalLength, 1e-9)
    coarse = [tessellated(face, CHORD * diagonal) for face in shape.Faces]
    area = sum(np.linalg.norm(np.cross(t[:, 1] - t[:, 0], t[:, 2] - t[:, 0]), axis=1).sum() / 2 for t in coarse)
    longest = max(diagonal / PIECES, (4 * area / MOST_TRIANGLES) ** 0.5)
    fine = [split(triangles, longest) for triangles in coarse]
    faces, uv, points = [], [], []
    for number, (face, triangles) in enumerate(zip(shape.Faces, fine)):
        surface = face.Surface
        for point in triangles.reshape(-1, 3).tolist():
            u, v = surface.parameter(FreeCAD.Vector(*point))
            faces.append(number)
            uv.append((u, v))
            points.append(tuple(surface.value(u, v)))
    points = np.array(points).reshape(-1, 3)
    lengths = core.load().target_lengths(model, faces, np.array(uv).reshape(-1, 2), points, **options)
    corners, lengths = points.reshape(-1, 3, 3).astype(np.float32), lengths.reshape(-1, 3).astype(np.float32)
    is_meshed = (lengths > 0).all(axis=1)
    return corners[is_meshed], lengths[is_meshed]
