"""Random solids, exploded into loose faces with gaps: they are sewn back to what they were, and meshed watertight.

    random_exploded.py FIRST COUNT [--jobs N] [--keep FOLDER]      seeds FIRST to FIRST + COUNT - 1
"""
from concurrent.futures import ThreadPoolExecutor
import json
import os
import subprocess
import sys
import tempfile

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "../support"))
import repo  # noqa: E402
import runs  # noqa: E402

GENERATOR = os.environ.get("PAVER_EXPLODER") or os.path.join(runs.ROOT, "build", "tests", "paver_random_exploded")
SHARE = 1 / 15  # of the diagonal: the target length


def faults_of(run, made):
    """Sentences; none where the mesh is that of the solid."""
    if run.code != 0 or run.mesh is None:
        return [f"exit code {run.code}: {run.output.strip()[-300:]}"]
    model, quality = run.report["model"], run.report["quality"]
    # Each cut of a face's own edge is a vertex that the neighbour's edge gets, too.
    wanted = {"faces": made["faces"], "edges": made["edges"] + made["cuts"], "free_edges": 0, "nonmanifold_edges": 0}
    faults = [f"{name.replace('_', ' ')}: {model[name]}, not {count}" for name, count in wanted.items()
              if model[name] != count]
    if not quality["watertight"]:
        faults.append(f"{quality['border_edges']} border edges")
    meshed = sum(face["status"] == "meshed" for face in run.report["faces"])
    if meshed != made["faces"]:
        faults.append(f"{meshed} of {made['faces']} faces are meshed")
    return faults + runs.conformity(run.mesh, closed=True)


def check(seed, folder):
    """(line to print, faults) of one seed."""
    ending = "step" if seed % 2 else "brep"
    done = subprocess.run([GENERATOR, str(seed), folder, str(seed % 2)], stdin=subprocess.DEVNULL, capture_output=True, text=True)
    if done.returncode:
        return f"{seed}: no model", [done.stderr.strip()]
    made = json.loads(done.stdout.splitlines()[-1])
    run = runs.paver(os.path.join(folder, f"{seed}_exploded.{ending}"), os.path.join(folder, f"{seed}.msh"),
                     "--size", made["diagonal"] * SHARE, "--threads", 1)
    gap = made["gap"] / made["diagonal"]
    return f"{seed}: {made['faces']} faces, {made['cuts']} cuts, gap {gap:.1e} of the diagonal, {run.seconds:.1f} s", faults_of(run, made)


def main():
    given = runs.seed_arguments(__doc__)
    if not os.path.exists(GENERATOR):
        repo.skip(f"{GENERATOR} is missing: scripts/build paver_random_exploded")
    failed = 0
    with tempfile.TemporaryDirectory() as own, ThreadPoolExecutor(given.jobs) as pool:
        folder = given.keep or own
        for line, faults in pool.map(lambda seed: check(seed, folder), range(given.first, given.first + given.count)):
            failed += bool(faults)
            print(line + "".join(f"\n  {fault}" for fault in faults), flush=True)
    print(f"{given.count - failed} of {given.count} are whole")
    sys.exit(failed > 0)


if __name__ == "__main__":
    main()
