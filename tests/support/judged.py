"""What the judge of the shared folder says of meshes of random models, its doubts settled by OpenCASCADE's distances."""
import json
import os
import subprocess

import numpy as np
from scipy.spatial import cKDTree

import runs
import render

TOOLS = os.path.join(os.path.dirname(os.path.dirname(os.path.abspath(runs.PROGRAM))), "tests")
TANGLES = ("hanging_nodes", "duplicate_nodes", "duplicate_elements", "edge_middle_node_mismatch")


def nodes_on(mesh):
    """Those of elements; those of wires are on no face."""
    rows = [elements.ravel() for elements in (mesh.quads, mesh.triangles)]
    return mesh.nodes[np.unique(np.concatenate(rows))]


def points_on(mesh, per_side=9):
    """Points all over a mesh's elements, on their straight or curved sides' surface."""
    u, v = (x.ravel() for x in np.meshgrid(*[np.linspace(0, 1, per_side)] * 2))
    points = [nodes_on(mesh)]
    for rows, weights, inside in ((mesh.quads, render.quad_weights, u >= 0),
                                  (mesh.triangles, render.triangle_weights, u + v <= 1 + 1e-9)):
        if len(rows):
            points.append(np.einsum("wk,ekc->wec", weights(u[inside], v[inside], mesh.order), mesh.nodes[rows]).reshape(-1, 3))
    return np.concatenate(points)


def is_as_model(mesh, model, size):
    """Whether mesh and model lie within a quarter of the target length of each other, by OpenCASCADE."""
    nodes = nodes_on(mesh)
    some = nodes[np.random.default_rng(0).permutation(len(nodes))[:300]]
    done = subprocess.run([os.path.join(TOOLS, "paver_farthest"), model], capture_output=True, text=True,
                          input="\n".join(" ".join(map(repr, map(float, node))) for node in some))
    if done.returncode:
        return False
    first, *lines = done.stdout.splitlines()
    of_model = np.array([line.split() for line in lines], float)
    gap = cKDTree(points_on(mesh)).query(of_model)[0].max()
    return float(first.split()[1]) < 0.25 * size and gap < 0.25 * size


def faults_of(mesh, out, model, size):
    """What the judge finds wrong. It takes points outside of some faces across a seam for points of the model, elements of
    two faces at a sharp angle for one on the other, and knows no junction on a periodic edge: there OpenCASCADE's distances
    and the area tell, which no fold, no gap and no element too many leaves right."""
    done = subprocess.run(["/usr/bin/python3", os.path.join(runs.SHARED, "tools", "quality.py"), out, "--cad", model, "--size",
                           str(size), "--fuse", "--samples", "5000", "--cad-samples", "3000"], capture_output=True, text=True)
    if "{" not in done.stdout:  # its own fuse has left nothing
        return [] if is_as_model(mesh, model, size) else [f"the judge fails: {done.stderr.strip()[-200:]}"]
    said = json.loads(done.stdout[done.stdout.index("{"):])
    if said["verdict"]["good"]:
        return []
    faults = [name for name, value in said["verdict"].items() if value is False and name != "good"]
    tangles = [said["topology"].get(what) for what in TANGLES]
    tangles.append(said["cad"]["border_edges_off_free_boundary"])
    if said["cad"]["manifold"]:
        tangles.append(said["topology"]["edges_on_more"])
    doubted = {"follows_surface", "normals_agree", "euler_matches"} | (set() if any(tangles) else {"conforming"})
    lacking = 1 - said["area"]["ratio"]
    is_covered = -2e-3 < lacking < (0.03 if mesh.order > 1 else 0.15)  # chords of order 1 leave some out
    return [] if set(faults) <= doubted and is_covered and is_as_model(mesh, model, size) else faults
