"""Cone-spheres at many target lengths: from a fifth of their length, where hardly an element fits, on.

    cone_sphere_test.py [SHARE...]      target length = length / SHARE
"""
from concurrent.futures import ThreadPoolExecutor
import os
import sys
import tempfile

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "../support"))
import runs  # noqa: E402

LENGTH = 290.49  # mm
NAMES = ("conesphere_one_face.brep", "conesphere.step", "conesphere_gap.step")


def check(job):
    """(line to print, faults) of one model at one share."""
    name, share, folder = job
    model, out = os.path.join(runs.EXAMPLES, name), os.path.join(folder, f"{name}_{share:g}.msh")
    run = runs.paver(model, out, "--size", LENGTH / share, "--threads", 1)
    label = f"{name} at length/{share:g}"
    if run.code != 0 or run.mesh is None:
        return label, [f"exit code {run.code}: {run.output.strip()[-300:]}"]
    faults = runs.conformity(run.mesh, True)
    if run.report["quality"]["inverted"]:
        faults.append(f"{run.report['quality']['inverted']} inverted elements")
    if runs.euler(run.mesh) != 2:
        faults.append(f"Euler characteristic {runs.euler(run.mesh)}, not 2")
    faults += runs.off_model(runs.independent_figures(model, out, LENGTH / share), LENGTH / share)
    if runs.has_judge():
        verdict = runs.judge(model, out, LENGTH / share)["verdict"]
        # Beside an apex the judge's search ends on the wrong image of some nodes: distances are those of off_model().
        wrong = [k for k, v in verdict.items() if v is False and k not in ("follows_surface", "good")]
        if wrong:
            faults.append(f"quality.py: {wrong}")
    return f"{label}: {len(run.mesh.quads)} quads, {len(run.mesh.triangles)} triangles", faults


def main():
    shares = [float(s) for s in sys.argv[1:]] or [5, 6, 7, 9, 12, 18, 30, 57, 250]
    faults = []
    with tempfile.TemporaryDirectory() as folder, ThreadPoolExecutor(2) as pool:
        for line, found in pool.map(check, [(name, share, folder) for name in NAMES for share in shares]):
            print(f"{line}: {'; '.join(found) or 'good'}")
            faults += found
    sys.exit(1 if faults else 0)


if __name__ == "__main__":
    main()
