"""Random assemblies (support/random_assembly.cpp) through the command line, and what an independent judge says of them.

    random_assemblies.py FIRST COUNT [--jobs N] [--keep FOLDER]    one line per seed, then a table

The target length is a twentieth of the diagonal. An assembly is good when the run ends with 0 within a minute, the mesh
has as many pieces as the parts have that touch, no two nodes are in one place, no node hangs in an element's side, and the
judge, where it is there, finds the mesh conforming. --keep: models and meshes of those that are not good.
"""
import collections
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
import os
import resource
import shutil
import subprocess
import sys
import tempfile

import numpy as np

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "../support"))
import judged  # noqa: E402
import runs  # noqa: E402

MEMORY = 6_000_000 << 10
MOST_SECONDS, SLOW = 120, 60
ELEMENTS = 200_000
DIVISIONS = 20
TOGETHER = 1e-6  # mm: nodes nearer than this are in one place
GENERATOR = os.environ.get("PAVER_RANDOM_ASSEMBLY") or os.path.join(judged.TOOLS, "paver_random_assembly")
GOOD, DOUBTFUL, FAILED, UNCONNECTED, WRONG, ENDED = (
    "good", "named gap", "failed faces", "named unconnected", "WRONG with exit 0", "ended by a limit or an error")


@dataclass
class Outcome:
    seed: int
    kind: str
    seconds: float
    parts: int
    why: str = ""


def make(seed, folder):
    """(path, path without wires, parts, components, diagonal) of an assembly: every other one is a BREP file."""
    ending = "step" if seed % 2 else "brep"
    path, faces = (os.path.join(folder, f"{seed}{what}.{ending}") for what in ("", "_faces"))
    done = subprocess.run([GENERATOR, str(seed), path, faces], capture_output=True, text=True, check=True)
    parts, components, diagonal = done.stdout.splitlines()[-1].split()
    return path, faces, int(parts), int(components), float(diagonal)


def pieces(mesh):
    """Number of meshes that share no node; wires are such too."""
    from scipy.sparse import coo_matrix
    from scipy.sparse.csgraph import connected_components
    rows = [r for r in (mesh.quads, mesh.triangles, mesh.lines) if len(r)]
    first = np.concatenate([np.repeat(r[:, 0], r.shape[1]) for r in rows])
    others = np.concatenate([r.ravel() for r in rows])
    links = coo_matrix((np.ones(len(first)), (first, others)), (len(mesh.nodes), len(mesh.nodes)))
    _, piece = connected_components(links, directed=False)
    return len(np.unique(piece[others]))


def faults_of(run, components):
    """What is wrong with a mesh that the program calls sound or doubtful, as sentences, by the mesh alone."""
    from scipy.spatial import cKDTree
    faults = []
    if run.report["verdict"] == "faulty" or run.report["model"]["unconnected"]:
        faults.append("exit code 0 with another verdict")
    found = pieces(run.mesh), len(run.report["components"])
    if found != (components, components):
        faults.append(f"{found[0]} pieces, {found[1]} components by the report, not {components}")
    doubles = len(cKDTree(run.mesh.nodes).query_pairs(TOGETHER))
    if doubles:
        faults.append(f"two nodes in one place, {doubles} times")
    hanging = runs.hanging_nodes(run.mesh)
    if hanging:
        faults.append(f"{hanging} hanging nodes")
    return faults


def outcome_of(run, faces, out, components, size, has_judge):
    """(kind, why) of one run."""
    if run.code == 4 and run.report:
        pairs = run.report["model"]["unconnected"]
        failed = [f"{f['name']}: {f['reason']}" for f in run.report["faces"] if f["status"] == "failed"]
        if pairs:
            return UNCONNECTED, f"{pairs} {failed}"
        return FAILED, "; ".join(failed)
    if run.code != 0 or run.mesh is None:
        return ENDED, f"exit code {run.code}: {run.output.strip()[-300:]}"
    faults = faults_of(run, components)
    if has_judge:  # it knows elements only, and is given the model without its wires
        faults += [f"quality.py: {what}" for what in judged.faults_of(run.mesh, out, faces, size)]
    if faults:
        return WRONG, "; ".join(faults)
    return (DOUBTFUL, "; ".join(run.report["doubts"])) if run.report["verdict"] == "doubtful" else (GOOD, "")


def check(seed, keep=None, has_judge=runs.has_judge()):
    """Outcome of one assembly."""
    with tempfile.TemporaryDirectory() as folder:
        path, faces, parts, components, diagonal = make(seed, folder)
        out, size = os.path.join(folder, f"{seed}.msh"), diagonal / DIVISIONS
        run = runs.paver(path, out, "--size", size, "--max-elements", ELEMENTS, "--threads", 1, limit=MOST_SECONDS)
        kind, why = outcome_of(run, faces, out, components, size, has_judge)
        if keep and kind != GOOD:
            for name in os.listdir(folder):
                shutil.copy(os.path.join(folder, name), keep)
    return Outcome(seed, kind, run.seconds, parts, why)


def main():
    given = runs.seed_arguments(__doc__)
    resource.setrlimit(resource.RLIMIT_AS, (MEMORY, MEMORY))
    table, slow = collections.Counter(), 0
    with ThreadPoolExecutor(given.jobs) as pool:
        for outcome in pool.map(lambda seed: check(seed, given.keep), range(given.first, given.first + given.count)):
            table[outcome.kind] += 1
            slow += outcome.seconds > SLOW
            print(outcome.seed, outcome.kind, f"{outcome.seconds:.1f} s", f"{outcome.parts} parts", outcome.why, sep="\t",
                  flush=True)
    for kind in (GOOD, DOUBTFUL, FAILED, UNCONNECTED, WRONG, ENDED):
        print(f"| {kind} | {table[kind]} |")
    print(f"| longer than {SLOW} s | {slow} |")
    return 1 if table[WRONG] or table[ENDED] or slow else 0


if __name__ == "__main__":
    sys.exit(main())
