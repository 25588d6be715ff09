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



def is_on_model(nodes, model, size):
    """Whether OpenCASCADE finds some nodes on the model's faces, to a twentieth of the target length: sides that were
    straightened are off by less."""
    some = nodes[np.random.default_rng(0).permutation(len(nodes))[:300]]
    done = subprocess.run([os.path.join(TOOLS, "paver_farthest"), model], capture_output=True, text=True,
                          input="\n".join(" ".join(map(repr, map(float, node))) for node in some))
    return done.returncode == 0 and float(done.stdout.split()[1]) < 0.05 * size


def judged(mesh, out, model, size):
    """What the judge finds wrong. It takes points outside of some faces across a seam for points of the model, and elements
    of two faces at a sharp angle for one on the other: there nodes on the model and the area tell, which no fold, no gap
    and no element too many leaves right."""
    done = subprocess.run(["/usr/bin/python3", os.path.join(runs.SHARED, "tools", "quality.py"), out, "--cad", model, "--size",
                           str(size), "--fuse", "--samples", "5000", "--cad-samples", "3000"], capture_output=True, text=True)
    if "{" not in done.stdout:
        return [f"the judge fails: {done.stderr.strip()[-200:]}"]
    said = json.loads(done.stdout[done.stdout.index("{"):])
    if said["verdict"]["good"]:
        return []
    faults = [name for name, value in said["verdict"].items() if value is False and name != "good"]
    tangles = ("hanging_nodes", "duplicate_nodes", "duplicate_elements", "edge_middle_node_mismatch", "edges_on_more")
    is_joined = said["topology"]["overlapping_elements"] and not any(said["topology"].get(what) for what in tangles)
    doubted = {"follows_surface", "normals_agree", "euler_matches"} | ({"conforming"} if is_joined else set())
    lacking = 1 - said["area"]["ratio"]
    is_covered = -2e-3 < lacking < (2e-3 if mesh.order > 1 else 0.05)  # chords of order 1 leave some out
    return [] if set(faults) <= doubted and is_covered and is_on_model(mesh.nodes, model, size) else faults


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
