"""Random B-reps (support/random_brep.cpp) meshed and judged: each run ends, and nothing wrong passes as good.

    random_breps.py FIRST COUNT [--jobs N] [--keep FOLDER]    one line per seed, then a table

A seed chooses the model, its format, the target length (a 5th to a 200th of the diagonal) and the elements. --keep: models
and meshes of the seeds that are not good.
"""
import collections
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
import os
import random
import resource
import shutil
import subprocess
import sys
import tempfile

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "../support"))
import judged  # noqa: E402
import runs  # noqa: E402

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


def mesh_model(outcome, model, out, size, options):
    run = runs.paver(model, out, "--size", size, "--threads", 1, "--max-elements", 1_000_000, *options, limit=MOST_SECONDS)
    outcome.seconds = run.seconds
    if run.code == 0:
        faults = judged.faults_of(run.mesh, out, model, size)
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
            made = subprocess.run([os.path.join(judged.TOOLS, "paver_random_brep"), str(seed), model], capture_output=True, text=True, timeout=MOST_SECONDS)
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
