"""A look at a model before it is meshed: where its parts touch, and what is merged as it is small. For a process of
its own: FreeCAD's part of it keeps every other Python waiting, and with it the window."""
import json
import re
from itertools import combinations
from typing import NamedTuple

import numpy as np

from paver_wb import core
from paver_wb.processes import size_look

PIECES = 12  # straight ones that an edge is drawn with
CHORD = 0.01  # distance of drawn triangles from their face, of the model's diagonal
MOST = 5000  # edges, faces or places of a kind


class Look(NamedTuple):
    """contact_triangles: (n, 3, 3) of faces that several parts have; contact_lines: (n, PIECES + 1, 3) of edges that several
    parts or more than two faces have; contact_points: (n, 3) vertices that several parts have, and no edge of these;
    small_lines: of the edges that are merged, and about the faces that are; small_places: (n, 3) a point on each of these.
    size_triangles: (n, 3, 3) over all faces; size_lengths: (n, 3) target lengths at their corners, mm.
    target: the target length, mm; pairs: of parts that touch; short, thin: how many edges and faces are merged.
    """

    contact_triangles: object
    contact_lines: object
    contact_points: object
    small_lines: object
    small_places: object
    size_triangles: object
    size_lengths: object
    target: float
    pairs: int
    short: int
    thin: int


ARRAYS = Look._fields[:7]


class Users:
    """Which things have which sub-shapes, whatever way round."""

    def __init__(self):
        self.by_code, self.entries = {}, []  # code: [number]; [shape, [users]]

    def add(self, shape, user):
        numbers = self.by_code.setdefault(shape.hashCode(), [])
        number = next((n for n in numbers if self.entries[n][0].isSame(shape)), None)
        if number is None:
            number = len(self.entries)
            numbers.append(number)
            self.entries.append((shape, []))
        users = self.entries[number][1]
        if user not in users:
            users.append(user)

    def with_at_least(self, count):
        return [shape for shape, users in self.entries if len(users) >= count]

    def users_of(self, shape):
        return next((self.entries[n][1] for n in self.by_code.get(shape.hashCode(), ()) if self.entries[n][0].isSame(shape)), ())

    def has(self, shape):
        return len(self.users_of(shape)) > 0


class Contacts(NamedTuple):
    """Shapes that several parts have, or edges that more than two faces have; pairs: of parts that touch."""

    faces: list
    edges: list
    vertices: list
    pairs: int


def connected(model, options):
    """(Part.Shape as it is meshed, of which nothing is merged yet; Prediction) of a paver.Model. Errors as in paver.mesh."""
    import Part
    paver = core.load()
    from paver import _run
    prediction = paver.predict(model, **options)
    shape = Part.Shape()
    shape.importBrepFromString(paver._paver.repaired(model._source, _run.given_options(options), None).decode())
    return shape, prediction


def parts_of(shape):
    """What is meshed together, as the core has put it."""
    return shape.SubShapes if shape.ShapeType == "Compound" else [shape]


def contacts(shape):
    """The Contacts of a shape that is connected."""
    users = {kind: Users() for kind in ("Faces", "Edges", "Vertexes")}
    for number, part in enumerate(parts_of(shape)):
        for kind, known in users.items():
            for thing in getattr(part, kind):
                known.add(thing, number)
    junctions, on_edges = Users(), Users()
    for number, face in enumerate(shape.Faces):
        for edge in face.Edges:
            junctions.add(edge, number)
    edges = users["Edges"].with_at_least(2)
    edges += [edge for edge in junctions.with_at_least(3) if len(users["Edges"].users_of(edge)) < 2]
    for edge in edges:
        for vertex in edge.Vertexes:
            on_edges.add(vertex, 0)
    pairs = {pair for known in users.values() for _, numbers in known.entries for pair in combinations(sorted(numbers), 2)}
    return Contacts(users["Faces"].with_at_least(2), edges,
                    [vertex for vertex in users["Vertexes"].with_at_least(2) if not on_edges.has(vertex)], len(pairs))


def small(shape, merges):
    """(edges, faces) of a shape as read that a prediction's merges name; pieces of what was divided have no name there."""
    found = {"edge": (shape.Edges, []), "face": (shape.Faces, [])}
    for merge in merges:
        number = re.fullmatch(r"(?:Edge|Face)(\d+)", merge["name"])
        things, named = found[merge["kind"]]
        if number and int(number.group(1)) <= len(things):
            named.append(things[int(number.group(1)) - 1])
    return found["edge"][1], found["face"][1]


def line(edge):
    return [tuple(point) for point in edge.discretize(PIECES + 1)]


def triangles(faces, chord):
    found = [points[corners] for points, corners in (size_look.tessellated(face, chord) for face in faces)]
    return np.concatenate([np.zeros((0, 3, 3)), *found]).astype(np.float32)


def edges_of(faces):
    known = Users()
    for number, face in enumerate(faces):
        for edge in face.Edges:
            if not edge.Degenerated:
                known.add(edge, number)
    return known.with_at_least(1)


def rows(points, shape):
    return np.array(points[:MOST], np.float32).reshape(-1, *shape)


def look(job):
    """The Look of a mesh_job.Job."""
    model, original = job.model(), size_look.original(job)
    shape, prediction = connected(model, job.options)
    touching = contacts(shape)
    short, thin = small(original, prediction.merges)
    chord = CHORD * shape.BoundBox.DiagonalLength
    lines = [edge for edge in touching.edges if not edge.Degenerated]
    return Look(triangles(touching.faces[:MOST], chord), rows([line(edge) for edge in lines[:MOST]], (PIECES + 1, 3)),
                rows([tuple(vertex.Point) for vertex in touching.vertices], (3,)),
                rows([line(edge) for edge in (short + edges_of(thin[:MOST]))[:MOST]], (PIECES + 1, 3)),
                rows([merge["where"] for merge in prediction.merges], (3,)),
                *size_look.sizes(model, original, job.options), prediction.target_length, touching.pairs, len(short), len(thin))


def save(found, path):
    figures = {name: value for name, value in found._asdict().items() if name not in ARRAYS}
    np.savez(path, figures=np.array(json.dumps(figures)), **{name: getattr(found, name) for name in ARRAYS})


def load(path):
    with np.load(path) as file:
        return Look(**{name: file[name] for name in ARRAYS}, **json.loads(str(file["figures"])))
