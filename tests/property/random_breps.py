"""Random B-reps (support/random_brep.cpp) meshed and judged: each run ends, and nothing wrong passes as good.

    random_breps.py FIRST COUNT [--jobs N] [--keep FOLDER]    one line per seed, then a table

A seed chooses the model, its format, the target length (a 5th to a 200th of the diagonal) and the elements. --keep: models
and meshes of the seeds that are not good.
"""
import collections
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
import json
import os
import random
import resource
import shutil
import subprocess
import sys
import tempfile

import numpy as np
from scipy.spatial import cKDTree

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "../support"))
import runs  # noqa: E402

TOOLS = os.path.join(os.path.dirname(os.path.dirname(os.path.abspath(runs.PROGRAM))), "tests")
MEMORY = 8 << 30
MOST_SECONDS = 60
KINDS = (("--elements", "quad-dominant"),) * 5 + (("--elements", "all-quad"), ("--elements", "all-triangle"), ("--order", "1"))


@dataclass
class Outcome:
    seed: int
    divisions: int
    options: str
    result: str = "no model"
    detail: str = ""
    seconds: float = 0


def points_on(mesh, per_side=9):
    """Points all over a mesh's elements, on their straight or curved sides' surface."""
    t = np.linspace(0, 1, per_side)
    u, v = (x.ravel() for x in np.meshgrid(t, t))
    points = [mesh.nodes]
    for elements, corners in ((mesh.quads, 4), (mesh.triangles, 3)):
        if not len(elements):
            continue
        x = mesh.nodes[elements]
        inside = np.ones_like(u, bool) if corners == 4 else u + v <= 1 + 1e-9
        for a, b in zip(u[inside], v[inside]):
            points.append(np.tensordot(weights(x.shape[1], a, b), x, (0, 1)))
    return np.concatenate(points)


def weights(nodes, u, v):
    """Of the Lagrange nodes of an element at (u, v), in Gmsh's order."""
    if nodes in (4, 9):
        f, g = (([1 - s, s] if nodes == 4 else [(1 - s) * (1 - 2 * s), s * (2 * s - 1), 4 * s * (1 - s)]) for s in (u, v))
        places = [(0, 0), (1, 0), (1, 1), (0, 1), (2, 0), (1, 2), (2, 1), (0, 2), (2, 2)][:nodes]
        return np.array([f[i] * g[j] for i, j in places])
    w = 1 - u - v
    if nodes == 3:
        return np.array([w, u, v])
    return np.array([w * (2 * w - 1), u * (2 * u - 1), v * (2 * v - 1), 4 * w * u, 4 * u * v, 4 * v * w])


def is_as_model(mesh, model, size):
    """Whether mesh and model lie within a quarter of the target length of each other, by OpenCASCADE."""
    some = mesh.nodes[np.random.default_rng(0).permutation(len(mesh.nodes))[:300]]
    done = subprocess.run([os.path.join(TOOLS, "paver_farthest"), model], capture_output=True, text=True,
                          input="\n".join(" ".join(map(repr, map(float, node))) for node in some))
    if done.returncode:
        return False
    first, *lines = done.stdout.splitlines()
    of_model = np.array([line.split() for line in lines], float)
    gap = cKDTree(points_on(mesh)).query(of_model)[0].max()
    return float(first.split()[1]) < 0.25 * size and gap < 0.25 * size


def judged(mesh, out, model, size):
    """What the judge finds wrong. It takes points outside of some faces across a seam for points of the model, and elements
    of two faces at a sharp angle for one on the other: there OpenCASCADE's distances and the area tell, which no fold, no
    gap and no element too many leaves right."""
    done = subprocess.run(["/usr/bin/python3", os.path.join(runs.SHARED, "tools", "quality.py"), out, "--cad", model, "--size",
                           str(size), "--fuse", "--samples", "5000", "--cad-samples", "3000"], capture_output=True, text=True)
    if "{" not in done.stdout:
        return [f"the judge fails: {done.stderr.strip()[-200:]}"]
    said = json.loads(done.stdout[done.stdout.index("{"):])
    if said["verdict"]["good"]:
        return []
    faults = [name for name, value in said["verdict"].items() if value is False and name != "good"]
    tangles = ["hanging_nodes", "duplicate_nodes", "duplicate_elements", "edge_middle_node_mismatch"]
    if said["cad"]["manifold"]:
        tangles.append("edges_on_more")
    is_joined = said["topology"]["overlapping_elements"] and not any(said["topology"].get(what) for what in tangles)
    doubted = {"follows_surface", "normals_agree", "euler_matches"} | ({"conforming"} if is_joined else set())
    lacking = 1 - said["area"]["ratio"]
    is_covered = -2e-3 < lacking < (0.03 if mesh.order > 1 else 0.15)  # chords of order 1 leave some out
    return [] if set(faults) <= doubted and is_covered and is_as_model(mesh, model, size) else faults


def mesh_model(outcome, model, out, size, options):
    run = runs.paver(model, out, "--size", size, "--threads", 1, "--max-elements", 1_000_000, *options, limit=MOST_SECONDS)
    outcome.seconds = run.seconds
    if run.code == 0:
        faults = judged(run.mesh, out, model, size)
        outcome.result, outcome.detail = ("WRONG", " ".join(faults)) if faults else ("good", "")
    elif run.code == 4:
        failed = [f"{face['name']} {face['stage']}: {face['reason']}" for face in run.report["faces"] if face["status"] == "failed"]
        outcome.result, outcome.detail = "named", (failed or [run.output.strip()[-300:]])[0]
    else:
        outcome.result, outcome.detail = str(run.code), run.output.strip()[-300:]


def run(seed, keep=None):
    """Outcome of one seed."""
    dice = random.Random(seed)
    divisions = round(5 * 40 ** dice.random())
    options = dice.choice(KINDS)
    outcome = Outcome(seed, divisions, " ".join(options))
    with tempfile.TemporaryDirectory() as folder:
        model = os.path.join(folder, f"{seed}" + dice.choice((".brep", ".step")))
        try:
            made = subprocess.run([os.path.join(TOOLS, "paver_random_brep"), str(seed), model], capture_output=True, text=True, timeout=MOST_SECONDS)
        except subprocess.TimeoutExpired:
            return outcome
        if made.returncode:
            return outcome
        diagonal = float(next(line for line in made.stdout.splitlines() if line.startswith("diagonal ")).split()[1])
        out = os.path.join(folder, f"{seed}.msh")
        mesh_model(outcome, model, out, diagonal / divisions, options)
        if keep and outcome.result != "good":
            for name in os.listdir(folder):
                shutil.copy(os.path.join(folder, name), keep)
    return outcome


def main():
    given = runs.seed_arguments(__doc__)
    runs.need_shared("tools", "quality.py")
    resource.setrlimit(resource.RLIMIT_AS, (MEMORY, MEMORY))
    table = collections.Counter()
    with ThreadPoolExecutor(given.jobs) as pool:
        for outcome in pool.map(lambda seed: run(seed, given.keep), range(given.first, given.first + given.count)):
            table[outcome.result] += 1
            print(*vars(outcome).values(), sep="\t", flush=True)
    for result, count in sorted(table.items()):
        print(f"| {result} | {count} |")
    return 1 if table["WRONG"] or table["timeout"] else 0


if __name__ == "__main__":
    sys.exit(main())
