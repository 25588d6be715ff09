"""Large faces meshed on several levels keep the invariants and are more regular than paved ones.

    multilevel_test.py [NAME...]      default: all below

Each example is meshed with one thread and with two on several levels, and directly.
"""
import filecmp
import os
import sys
import tempfile

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "../support"))
import runs  # noqa: E402

# File, target length in mm with which some face is large, ratio, Euler characteristic, whether it is closed.
MODELS = {"plate_circular_hole": (".step", 0.65, "auto", 0, False), "conesphere_gap": (".step", 0.7, 6, 2, True),
          "conesphere_one_face": (".brep", 0.9, 4, 2, True), "wavy_patch": (".step", 0.75, "auto", 1, False),
          "wing": (".step", 1.2, 5, 2, True), "box_cylinder": (".step", 0.5, 4, 2, True),
          "wind_generator": (".brep", 36, "auto", 2, True)}


def faults_of(run, euler, closed):
    if run.code != 0 or run.mesh is None:
        return [f"exit code {run.code}: {run.output.strip()[-300:]}"]
    quality = run.report["quality"]
    faults = runs.conformity(run.mesh, closed)
    if quality["inverted"] or quality["undecided"]:
        faults.append(f"{quality['inverted']} inverted and {quality['undecided']} undecided elements")
    if runs.euler(run.mesh) != euler:
        faults.append(f"Euler characteristic {runs.euler(run.mesh)}, not {euler}")
    return faults


def compare(run, direct):
    """Where the mesh is worse than the one paved directly."""
    ours, theirs = run.report["quality"], direct.report["quality"]
    faults = []
    if ours["irregular_share"] > theirs["irregular_share"] + 1e-4:
        faults.append(f"irregular {ours['irregular_share']:.3%}, paved {theirs['irregular_share']:.3%}")
    if ours["sj"]["all"]["mean"] < theirs["sj"]["all"]["mean"] - 0.005:
        faults.append(f"mean SJ {ours['sj']['all']['mean']:.4f}, paved {theirs['sj']['all']['mean']:.4f}")
    if abs(ours["length_mean"] - 1) > 0.03:
        faults.append(f"edges are {ours['length_mean']:.3f} of the target length on average")
    return faults


def check(name, folder):
    """(line to print, faults, irregular nodes on several levels and paved)."""
    kind, size, ratio, euler, closed = MODELS[name]
    model = os.path.join(runs.EXAMPLES, name + kind)
    one, two, paved = (os.path.join(folder, f"{t}.msh") for t in ("one", "two", "paved"))
    run = runs.paver(model, one, "--size", size, "--threads", 1, "--multilevel", ratio)
    faults = faults_of(run, euler, closed)
    if faults:
        return name, faults, (0, 0)
    runs.paver(model, two, "--size", size, "--threads", 2, "--multilevel", ratio)
    if not os.path.exists(two) or not filecmp.cmp(one, two, shallow=False):
        faults.append("one thread and two give different files")
    direct = runs.paver(model, paved, "--size", size, "--order", 1, "--multilevel", "off")
    faults += compare(run, direct)
    q, theirs = run.report["quality"], direct.report["quality"]
    line = (f"{name}: {q['quads']} quads, {q['triangles']} triangles, {q['irregular_share']:.3%} irregular, "
            f"paved {theirs['irregular_share']:.3%}")
    return line, faults, (q["irregular_nodes"], theirs["irregular_nodes"])


def main():
    faults, irregular = [], [0, 0]
    with tempfile.TemporaryDirectory() as folder:
        for name in sys.argv[1:] or MODELS:
            line, found, nodes = check(name, folder)
            irregular = [sum(pair) for pair in zip(irregular, nodes)]
            print(f"{line}: {'; '.join(found) or 'good'}")
            faults += found
    if irregular[0] > 0.5 * irregular[1]:
        faults.append("irregular nodes")
    print(f"irregular nodes on several levels {irregular[0]}, paved {irregular[1]}")
    sys.exit(1 if faults else 0)


if __name__ == "__main__":
    main()
