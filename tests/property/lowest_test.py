"""The lowest frequency: whatever the length, every face is meshed, valid and as it hangs together. Every shipped example
and, of the shared folder, the models of cad/ and tips/.

    lowest_test.py [NAME...]      default: all
"""
from concurrent.futures import ThreadPoolExecutor
import glob
import os
import sys
import tempfile

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "../support"))
import runs  # noqa: E402
from examples_test import MODELS, OPEN  # noqa: E402
from models_test import is_closed  # noqa: E402

FEWEST = {"box": 6, "pyramid": 5, "sphere": 24, "torus": 64}
LEAST_SJ = {"plate_nine_holes": 0.5, "plane_11_loops": 0.15}  # sides are divided as the holes about them ask for
UNCONNECTED = {"airliner_vsp", "uav_vsp"}  # sheets that cross, which no kernel connects


def expected():
    """(path, closed, Euler characteristic or None) of each."""
    models = [(m, name_of(m) not in OPEN, MODELS[name_of(m)][1]) for m in runs.examples()]
    models += [(m, True, 2) for m in sorted(glob.glob(os.path.join(runs.need_shared("tips"), "*.step")))]
    return models + [(runs.need_shared("cad", file), is_closed(row), None) for file, row in runs.survey().items()]


def name_of(model):
    return os.path.splitext(os.path.basename(model))[0]


def check(job):
    (model, closed, euler), folder = job
    name = name_of(model)
    run = runs.paver(model, os.path.join(folder, f"{os.path.basename(model)}.msh"), "--size", "1e6mm", "--threads", 1)
    if run.mesh is None:
        return name, [f"exit code {run.code}: {run.output.strip()[-300:]}"]
    failed = [f["name"] for f in run.report["faces"] if f["status"] == "failed"]
    if failed or run.code != (4 if name in UNCONNECTED else 0):
        return name, [f"exit code {run.code}, {', '.join(failed) or 'no face'} failed: {run.output.strip()[-300:]}"]
    faults = runs.conformity(run.mesh, closed, run.report["model"]["nonmanifold_edges"] > 0)
    count = len(run.mesh.quads) + len(run.mesh.triangles)
    if euler is not None and runs.euler(run.mesh) != euler:
        faults.append(f"Euler characteristic {runs.euler(run.mesh)}, not {euler}")
    if run.report["quality"]["sj"]["all"]["min"] < LEAST_SJ.get(name, 0):
        faults.append(f"scaled Jacobian {run.report['quality']['sj']['all']['min']:.3f}, not {LEAST_SJ[name]}")
    if count != FEWEST.get(name, count):
        faults.append(f"{count} elements, not {FEWEST[name]}")
    return f"{name}: {count} elements", faults


def main():
    chosen = sys.argv[1:]
    models = [m for m in expected() if not chosen or name_of(m[0]) in chosen]
    is_good = True
    with tempfile.TemporaryDirectory() as folder, ThreadPoolExecutor(os.cpu_count()) as pool:
        for line, faults in pool.map(check, [(m, folder) for m in models]):
            print(f"{line}: {'; '.join(faults) or 'good'}")
            is_good = is_good and not faults
    sys.exit(0 if is_good else 1)


if __name__ == "__main__":
    main()
