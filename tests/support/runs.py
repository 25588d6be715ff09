"""Runs Paver's command line and checks the meshes it writes, for tests and scripts/measure."""
import argparse
import csv
from dataclasses import dataclass
import glob
import json
import os
import subprocess
import sys
import time

import numpy as np

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
sys.path.insert(0, os.path.join(ROOT, "scripts"))
sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import meshfile  # noqa: E402
import repo  # noqa: E402

EXAMPLES = os.path.join(ROOT, "Resources", "examples")
PROGRAM = os.environ.get("PAVER_PROGRAM") or os.path.join(ROOT, "build", "core", "paver")
SHARED = os.environ.get("PAVER_SHARED") or os.path.join(ROOT, "..", "shared")


@dataclass
class Run:
    """What one call of the command line left."""
    code: int
    output: str
    seconds: float
    report: dict
    mesh: meshfile.Mesh


def need_shared(*parts):
    """Path of something in the shared folder; ends the test as skipped when it is not there."""
    path = os.path.join(SHARED, *parts)
    if not os.path.exists(path):
        repo.skip(f"{os.path.join(*parts)} is missing: set PAVER_SHARED to the folder that has it")
    return path


def paver(model, out, *options, limit=300):
    """Meshes `model` into `out` (.msh); the report goes beside it."""
    report = os.path.splitext(out)[0] + ".json"
    for old in (out, report):
        if os.path.exists(old):
            os.remove(old)
    start = time.time()
    try:
        done = subprocess.run([PROGRAM, "mesh", model, "-o", out, "--report", report, *map(str, options)],
                              stdin=subprocess.DEVNULL, capture_output=True, text=True, timeout=limit)
        code, output = done.returncode, done.stdout + done.stderr
    except subprocess.TimeoutExpired:
        code, output = "timeout", f"no end after {limit} s"
    seconds = time.time() - start
    loaded, mesh = {}, None
    if os.path.exists(report):
        with open(report) as f:
            loaded = json.load(f)
    if os.path.exists(out):
        mesh = meshfile.read(out)
    return Run(code, output, seconds, loaded, mesh)


def seed_arguments(about):
    """first, count, jobs and keep, as scripts that go through many seeds take them; the folder to keep things in is made."""
    parser = argparse.ArgumentParser(description=about, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("first", type=int)
    parser.add_argument("count", type=int)
    parser.add_argument("--jobs", type=int, default=1)
    parser.add_argument("--keep")
    given = parser.parse_args()
    if given.keep:
        os.makedirs(given.keep, exist_ok=True)
    return given


def survey():
    """Rows of cad/survey.csv for the models that Paver reads, numbers as floats."""
    rows = {}
    with open(need_shared("cad", "survey.csv")) as f:
        for row in csv.DictReader(f):
            if row["format"] in ("step", "iges", "brep"):
                rows[row["file"]] = row
    return rows


def planar_regions(count):
    """(path, h) of the first regions of the planar corpus."""
    with open(need_shared("planar", "manifest.csv")) as f:
        return [(need_shared("planar", row["file"]), float(row["h"])) for row in list(csv.DictReader(f))[:count]]


def examples():
    return sorted(p for p in glob.glob(os.path.join(EXAMPLES, "*")) if p.endswith((".step", ".brep")))


def has_judge():
    return os.path.exists(os.path.join(SHARED, "tools", "quality.py"))


def judge(model, mesh, size, *options):
    """What tools/quality.py of the shared folder says of a mesh file."""
    tool = need_shared("tools", "quality.py")
    done = subprocess.run(["/usr/bin/python3", tool, mesh, "--cad", model, "--size", str(size), "--samples", "20000",
                           "--cad-samples", "10000", *options], stdin=subprocess.DEVNULL, capture_output=True, text=True)
    if done.returncode:
        return {"verdict": {"good": False, "error": done.stderr.strip()[-200:]}}
    return json.loads(done.stdout[done.stdout.index("{"):])  # some CAD readers print before it


def independent_figures(model, mesh, size):
    """What figures.py beside this file says of a mesh file; in a process of its own, Gmsh knows one model at a time."""
    tool = os.path.join(os.path.dirname(os.path.abspath(__file__)), "figures.py")
    done = subprocess.run(["/usr/bin/python3", tool, mesh, model, str(size)], stdin=subprocess.DEVNULL,
                          capture_output=True, text=True, check=True)
    return json.loads(done.stdout)


def off_model(figures, size):
    """Where nodes are not on the model or its faces not meshed, as sentences. Middle nodes leave the surface where an
    element would fold on it."""
    faults = [f"{what} up to {figures[what]:.3g} mm"
              for what, share in (("corners off the model", 1e-6), ("nodes off the model", 0.1))
              if figures[what] > share * size]
    if figures["faces without elements"]:
        faults.append(f"{figures['faces without elements']:.0f} faces have no elements")
    return faults


SEW = """
import sys, gmsh
gmsh.initialize()
gmsh.option.setNumber("General.Terminal", 0)
gmsh.option.setNumber("Geometry.OCCSewFaces", 1)
gmsh.option.setNumber("Geometry.Tolerance", float(sys.argv[3]))
gmsh.option.setString("Geometry.OCCTargetUnit", "")
gmsh.model.occ.importShapes(sys.argv[1])
gmsh.model.occ.synchronize()
gmsh.write(sys.argv[2])
"""


def sewn(model, out, tolerance):
    """`model` as a .brep file with the faces sewn, by another program than ours: for models without topology, whose
    faces share no edges as they come."""
    subprocess.run(["/usr/bin/python3", "-c", SEW, model, out, str(tolerance)], stdin=subprocess.DEVNULL, check=True,
                   capture_output=True)
    return out


# Checks of a mesh alone. Each gives sentences, none when all is well.

def directed_sides(mesh):
    """Sides of all elements as rows (start, end[, middle]), and their face tags."""
    sides, elements = meshfile.sides(mesh)
    return sides, np.concatenate([mesh.quad_tag, mesh.triangle_tag])[elements]


def edge_keys(sides):
    """Edges as rows (smaller end, larger end[, middle]): two curved edges may have the same ends."""
    return np.concatenate([np.sort(sides[:, :2], 1), sides[:, 2:]], 1)


def coinciding(mesh, closed):
    """Places with several nodes. Bodies may touch, and the faces of open CAD may meet without a common edge."""
    from scipy.sparse import coo_matrix
    from scipy.sparse.csgraph import connected_components
    _, place, count = np.unique(mesh.nodes, axis=0, return_inverse=True, return_counts=True)
    doubles = np.flatnonzero(count[place] > 1)
    if not len(doubles):
        return 0
    first = np.concatenate([np.repeat(r[:, 0], r.shape[1]) for r in (mesh.quads, mesh.triangles)])
    others = np.concatenate([mesh.quads.ravel(), mesh.triangles.ravel()])
    links = coo_matrix((np.ones(len(first)), (first, others)), (len(mesh.nodes), len(mesh.nodes)))
    _, body = connected_components(links, directed=False)
    on_line = set(mesh.lines.ravel().tolist())
    faces, groups = {}, {}
    for rows, tags in ((mesh.quads, mesh.quad_tag), (mesh.triangles, mesh.triangle_tag)):
        for row, tag in zip(*(a[np.isin(rows, doubles).any(1)].tolist() for a in (rows, tags))):
            for node in row:
                faces.setdefault(node, set()).add(tag)
    for node in doubles.tolist():
        groups.setdefault(place[node], []).append(node)

    def is_fault(group):
        shares_face = len(set().union(*(faces[n] for n in group))) < sum(len(faces[n]) for n in group)
        return shares_face and not on_line.issuperset(group) or closed and len(set(body[group].tolist())) < len(group)

    return sum(is_fault(g) for g in groups.values())


def conformity(mesh, closed, junctions=False):
    """Every edge in two elements with opposite direction, or on a B-rep edge where the CAD is open; no loose nodes.

    junctions: there are B-rep edges where more than two faces meet.
    """
    if not np.isfinite(mesh.nodes).all():
        return ["a coordinate is not a number"]
    faults = []
    sides, tags = directed_sides(mesh)
    if (sides[:, 0] == sides[:, 1]).any():
        faults.append("an edge ends where it starts")
    edges, number, uses = np.unique(edge_keys(sides), axis=0, return_inverse=True, return_counts=True)
    lines = edge_keys(mesh.lines)
    on_line = in_rows(edges, lines)
    is_meeting = junctions & on_line & (uses > 2)
    if closed and ((uses != 2) & ~is_meeting).any():
        faults.append(f"{(uses == 1).sum()} open edges and {(uses > 2).sum()} edges of more than two elements")
    if ((uses != 2) & ~on_line).any():
        faults.append(f"{((uses != 2) & ~on_line).sum()} edges inside faces have not two elements")
    if not in_rows(lines, edges).all():
        faults.append("a piece of a B-rep edge is no edge of an element")
    same = np.concatenate([number[:, None], sides[:, :1], tags[:, None]], 1)[:, :2 if closed else 3]
    same = same[~is_meeting[number.ravel()]]
    if len(np.unique(same, axis=0)) != len(same):
        faults.append("two elements run through one edge in the same direction")
    used = np.unique(np.concatenate([mesh.quads.ravel(), mesh.triangles.ravel()]))
    if len(used) != len(mesh.nodes):
        faults.append(f"{len(mesh.nodes) - len(used)} nodes belong to no element")
    doubles = coinciding(mesh, closed)
    if doubles:
        faults.append(f"two nodes in one place, {doubles} times")
    return faults


def in_rows(rows, table):
    """For each of `rows` whether it is one of `table`'s."""
    both = np.concatenate([table, rows])
    _, number = np.unique(both, axis=0, return_inverse=True)
    return np.isin(number[len(table):], number[:len(table)])


def euler(mesh):
    """V - E + F."""
    sides, _ = directed_sides(mesh)
    edges = np.unique(edge_keys(sides), axis=0)
    return len(np.unique(sides[:, :2])) - len(edges) + len(mesh.quads) + len(mesh.triangles)


def hanging_nodes(mesh):
    """Border nodes that lie inside another border edge (straight sides), closer than 1e-6 of its length."""
    from scipy.spatial import cKDTree
    sides, _ = directed_sides(mesh)
    edges, uses = np.unique(np.sort(sides[:, :2], 1), axis=0, return_counts=True)
    border = edges[uses == 1]
    if not len(border):
        return 0
    nodes = np.unique(border)
    a, b = mesh.nodes[border[:, 0]], mesh.nodes[border[:, 1]]
    length = np.linalg.norm(b - a, axis=1)
    near = cKDTree(mesh.nodes[nodes]).query_ball_point((a + b) / 2, length / 2 * (1 - 1e-6))
    found = 0
    for i, candidates in enumerate(near):
        for node in nodes[candidates]:
            if node not in border[i]:
                offset = mesh.nodes[node] - a[i]
                along = (b[i] - a[i]) / length[i]
                found += np.linalg.norm(offset - offset.dot(along) * along) < 1e-6 * length[i]
    return int(found)
