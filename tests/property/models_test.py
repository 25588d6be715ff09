"""The invariants of a mesh over real CAD models.

    models_test.py MODEL... [--divide 50]   files of cad/ in the shared folder, target length = diagonal / divide

Every model: exit code 0 and the verdict "sound", every face with an area meshed, nothing inverted, conforming, watertight
where the CAD is closed (junctions aside, where parts touch), and the same file bit for bit with one thread and with two.
Faces of a model that the CAD kernel itself calls faulty may fail, with a reason and a place, and parts that cannot be
connected are named; then the verdict says so.
"""
import argparse
import filecmp
import os
import sys
import tempfile

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "../support"))
import runs  # noqa: E402


def is_closed(row):
    """Whether every edge has two faces once what fits is sewn."""
    return float(row["free_edges_sewn"]) == 0 and float(row["nonmanifold_edges"]) == 0


def failures(faces, may_fail):
    """Failed faces that may not fail or do not say why and where, as sentences."""
    return [f"{f['name']} is {f['status']}: {f['reason']}" for f in faces if f["status"] == "failed"
            and not (may_fail and f["reason"] and "where" in f)]


def faults_of(run, closed, may_fail):
    """What is wrong with one run, as sentences."""
    unconnected = bool(run.report and run.report["model"]["unconnected"])
    if run.code not in ((0, 4) if may_fail or unconnected else (0,)):
        return [f"exit code {run.code}: {run.output.strip()[-400:]}"]
    if run.mesh is None or not run.report:
        return ["no mesh or no report"]
    quality, faces = run.report["quality"], run.report["faces"]
    faults = failures(faces, may_fail)
    if (run.report["verdict"], bool(run.report["faults"])) != (("sound", False) if run.code == 0 else ("faulty", True)):
        faults.append(f"exit code {run.code}, but the verdict is {run.report['verdict']}")
    if quality["inverted"] or quality["undecided"]:
        faults.append(f"{quality['inverted']} inverted and {quality['undecided']} undecided elements")
    junctions = run.report["model"]["nonmanifold_edges"] > 0
    if closed and not (quality["border_edges"] == 0 if junctions else quality["watertight"]):
        faults.append("not watertight by the report")
    meshed = {f["name"] for f in faces if f["status"] == "meshed"}
    tagged = len(set(run.mesh.quad_tag) | set(run.mesh.triangle_tag))
    if tagged != len(meshed):
        faults.append(f"{len(meshed)} faces are meshed by the report, {tagged} have elements in the file")
    counted = (len(run.mesh.quads), len(run.mesh.triangles))
    if counted != (quality["quads"], quality["triangles"]):
        faults.append(f"the file has {counted[0]} quads and {counted[1]} triangles, the report says otherwise")
    if run.code == 0 or not may_fail:  # pieces of edges of faces that failed stay in the file, without elements
        faults += runs.conformity(run.mesh, closed, junctions)
    hanging = runs.hanging_nodes(run.mesh)
    if closed and hanging:
        faults.append(f"{hanging} hanging nodes")
    if closed and not junctions and runs.euler(run.mesh) % 2:
        faults.append(f"Euler characteristic {runs.euler(run.mesh)} of a closed mesh is odd")
    return faults


def check(name, row, divide, folder):
    model = runs.need_shared("cad", name)
    size = float(row["diag"]) / divide
    one, two = (os.path.join(folder, f"{t}.msh") for t in (1, 2))
    run = runs.paver(model, one, "--size", size, "--order", 2, "--threads", 1)
    faults = faults_of(run, is_closed(row), row["valid"] != "True")
    if run.mesh:
        runs.paver(model, two, "--size", size, "--order", 2, "--threads", 2)
        if not os.path.exists(two) or not filecmp.cmp(one, two, shallow=False):
            faults.append("one thread and two give different files")
    elements = f"{len(run.mesh.quads)} quads, {len(run.mesh.triangles)} triangles" if run.mesh else "no mesh"
    print(f"{name} at diagonal/{divide:g}: {elements}, {run.seconds:.1f} s: {'; '.join(faults) or 'good'}")
    return faults


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("models", nargs="*")
    parser.add_argument("--divide", type=float, default=50)
    a = parser.parse_args()
    rows = runs.survey()
    faults = []
    with tempfile.TemporaryDirectory() as folder:
        for name in a.models or rows:
            faults += check(name, rows[name], a.divide, folder)
    sys.exit(1 if faults else 0)


if __name__ == "__main__":
    main()
