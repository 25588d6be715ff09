"""Meshes to compare: Paver's and Gmsh's of a model, of quads and of triangles, at about the same number of unknowns."""
import math
import os
import sys
from typing import NamedTuple

import numpy as np

_ROOT = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
sys.path[:0] = [os.path.join(_ROOT, "bindings"), os.path.dirname(os.path.abspath(__file__))]
import paver  # noqa: E402
import scattering  # noqa: E402

EXAMPLES = os.path.join(_ROOT, "Resources", "examples")
SHARED = os.environ.get("PAVER_SHARED") or os.path.join(_ROOT, "..", "shared")  # models that the project does not ship
KINDS = {"quads": "Paver, quads", "triangles": "Paver, triangles", "gmsh-triangles": "Gmsh, triangles",
         "gmsh-quads": "Gmsh, quads"}
TIP, GROWTH = 32, 0.6  # how Paver grades tips, for Gmsh's to be graded alike
NODES_OF = {2: 3, 3: 4, 9: 6, 10: 9}  # Gmsh's types of elements


class Mesh(NamedTuple):
    nodes: np.ndarray
    quads: np.ndarray
    triangles: np.ndarray


def ours(model, size, order=2, **options):
    found = paver.mesh(model, size=size, order=order, threads=1, **options)
    return Mesh(found.nodes, found.quads, found.triangles)


def has_gmsh():
    try:
        import gmsh  # noqa: F401
    except ImportError:
        return False
    return True


def kinds(stored):
    """The kinds of meshes to compare: without Gmsh's where it is not installed and nothing of it is stored."""
    found = [k for k in KINDS if not k.startswith("gmsh") or has_gmsh() or stored.has(k)]
    if len(found) < len(KINDS):
        print("  the Python module gmsh is missing: its meshes are left out")
    return found


def _grade_tip(gmsh, at, size):
    """Elements of size / TIP about the vertex nearest to `at`, growing from there."""
    points = gmsh.model.getEntities(0)
    tip = min(points, key=lambda p: math.dist(gmsh.model.getValue(*p, []), at))[1]
    field = gmsh.model.mesh.field
    away, sizes = field.add("Distance"), field.add("Threshold")
    field.setNumbers(away, "NodesList", [tip])
    for name, value in (("IField", away), ("LcMin", size / TIP), ("LcMax", size), ("DistMin", 0),
                        ("DistMax", size * (1 - 1 / TIP) / GROWTH)):
        field.setNumber(sizes, name, value)
    field.setAsBackgroundMesh(sizes)


def gmsh_mesh(model, size, order=2, quads=False, tip_at=None):
    """Frontal-Delaunay triangles; quads by pairing them (Blossom). `tip_at`: a place about which elements get smaller."""
    import gmsh
    gmsh.initialize()
    try:
        options = {"General.Terminal": 0, "General.NumThreads": 1, "Mesh.Algorithm": 6, "Mesh.MeshSizeMax": size,
                   "Mesh.RecombineAll": int(quads), "Mesh.RecombinationAlgorithm": 1}
        if tip_at is None:
            options["Mesh.MeshSizeMin"] = size
        for name, value in options.items():
            gmsh.option.setNumber(name, value)
        gmsh.open(model)
        if tip_at is not None:
            _grade_tip(gmsh, tip_at, size)
        gmsh.model.mesh.generate(2)
        gmsh.model.mesh.setOrder(order)
        tags, places, _ = gmsh.model.mesh.getNodes()
        sorting = np.argsort(tags)
        rows = {3: [], 4: [], 6: [], 9: []}
        for kind, _, nodes in zip(*gmsh.model.mesh.getElements(2)):
            rows[NODES_OF[kind]] = sorting[np.searchsorted(tags, nodes, sorter=sorting)].reshape(-1, NODES_OF[kind])
        quad, triangle = (9, 6) if order == 2 else (4, 3)
        return Mesh(places.reshape(-1, 3), *(np.asarray(rows[n]).reshape(-1, n) for n in (quad, triangle)))
    finally:
        gmsh.finalize()


def maker(kind, model, order=2, tip_at=None, **options):
    """A function from target length to Mesh."""
    if kind in ("quads", "triangles"):
        if kind == "triangles":
            options["elements"] = "all-triangle"
        return lambda size: ours(model, size, order, **options)
    return lambda size: gmsh_mesh(model, size, order, kind == "gmsh-quads", tip_at)


def about(make, unknowns, size, tries=7):
    """(mesh, functions) with the number of unknowns nearest to the one asked that a few target lengths give."""
    best = None
    for _ in range(tries):
        mesh = make(size)
        functions = scattering.surface(mesh)
        miss = abs(math.log(functions.unknowns / unknowns))
        if best is None or miss < best[0]:
            best = miss, mesh, functions
        if miss < 0.02:
            break
        size *= math.sqrt(functions.unknowns / unknowns)
    return best[1:]


def scaled(mesh, factor, about_middle=False):
    """Nodes times `factor`; of a body whose middle is to be the origin, about that."""
    middle = (mesh.nodes.max(0) + mesh.nodes.min(0)) / 2 if about_middle else 0
    return mesh._replace(nodes=(mesh.nodes - middle) * factor)
