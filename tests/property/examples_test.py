"""Every shipped example at order 1 and 2 keeps the invariants, and the report says what tools/quality.py says.

    examples_test.py [NAME...]      default: all of Resources/examples
"""
from concurrent.futures import ThreadPoolExecutor
import os
import sys
import tempfile

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "../support"))
import runs  # noqa: E402

# Target length in mm, and the Euler characteristic of the whole model; open models have a border.
MODELS = {"plate_rect_hole": (9, 0), "plate_circular_hole": (7, 0), "plate_nine_holes": (5, -8),
          "disk_tiny_hole": (7, 0), "conesphere_one_face": (8, 2), "conesphere": (8, 2), "conesphere_gap": (8, 2),
          "sphere": (12, 2), "torus": (10, 0), "box": (6, 2), "box_cylinder": (8, 2), "pyramid": (7, 2),
          "wavy_patch": (8, 1), "wing": (10, 2), "wind_generator": (120, 2)}
OPEN = ("plate_rect_hole", "plate_circular_hole", "plate_nine_holes", "disk_tiny_hole", "wavy_patch")


def compare(report, verdict):
    """Where the report and tools/quality.py differ, as sentences. Both read the same curved elements."""
    ours, theirs = report["quality"], verdict
    pairs = {
        "quads": (ours["quads"], theirs["counts"]["quads"]),
        "triangles": (ours["triangles"], theirs["counts"]["triangles"]),
        "SJ min": (ours["sj"]["all"]["min"], theirs["shape"]["all"]["scaled_jacobian"]["min"]),
        "SJ mean": (ours["sj"]["all"]["mean"], theirs["shape"]["all"]["scaled_jacobian"]["mean"]),
        "SJ share < 0.3": (ours["sj"]["all"]["below_03"], theirs["shape"]["all"]["fraction_sj_below_0.3"]),
        "irregular share": (ours["irregular_share"], theirs["valence"]["irregular_fraction_face_interior"] or 0),
        "length mean": (ours["length_mean"], theirs["edges"]["chord"]["mean_rel"]),
        "length CV": (ours["length_cv"], theirs["edges"]["chord"]["cov"]),
        "mesh area": (ours["mesh_area"], theirs["area"]["mesh"]),
        "CAD area": (ours["cad_area"], theirs["area"]["cad"]),
        "inverted": (ours["inverted"], theirs["curved"]["invalid"]),
        "border edges": (ours["border_edges"], theirs["topology"]["edges_on_one_element"]),
    }
    return [f"{name}: the report says {a:.7g}, quality.py {b:.7g}" for name, (a, b) in pairs.items()
            if abs(a - b) > 1e-4 * max(abs(a), abs(b)) + 1e-9]


def check(job):
    """(line to print, faults) of one example at one order."""
    model, order, folder = job
    name = os.path.splitext(os.path.basename(model))[0]
    size, euler = MODELS[name]
    out = os.path.join(folder, f"{name}_{order}.msh")
    run = runs.paver(model, out, "--size", size, "--order", order, "--threads", 1)
    if run.code != 0 or run.mesh is None:
        return f"{name} order {order}", [f"exit code {run.code}: {run.output.strip()[-300:]}"]
    faults = runs.conformity(run.mesh, name not in OPEN)
    if runs.euler(run.mesh) != euler:
        faults.append(f"Euler characteristic {runs.euler(run.mesh)}, not {euler}")
    if os.path.isdir(runs.SHARED):
        verdict = runs.judge(model, out, size)
        if not verdict["verdict"]["good"]:
            faults.append(f"quality.py: {[k for k, v in verdict['verdict'].items() if v is False]}")
        if "counts" in verdict:
            faults += compare(run.report, verdict)
    return f"{name} order {order}: {len(run.mesh.quads)} quads, {len(run.mesh.triangles)} triangles", faults


def main():
    chosen = sys.argv[1:]
    models = [m for m in runs.examples() if not chosen or os.path.splitext(os.path.basename(m))[0] in chosen]
    faults = []
    with tempfile.TemporaryDirectory() as folder, ThreadPoolExecutor(os.cpu_count()) as pool:
        for line, found in pool.map(check, [(m, order, folder) for m in models for order in (1, 2)]):
            print(f"{line}: {'; '.join(found) or 'good'}")
            faults += found
    if not os.path.isdir(runs.SHARED):
        print("quality.py is missing: the report was not compared with it")
    sys.exit(1 if faults else 0)


if __name__ == "__main__":
    main()
