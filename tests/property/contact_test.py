"""Models whose parts touch, of the shared folder: one connected mesh, with the junctions and free edges that the model has.

    contact_test.py [NAME...]      default: all of contact/
"""
from concurrent.futures import ThreadPoolExecutor
import glob
import os
import sys
import tempfile

import numpy as np

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "../support"))
import runs  # noqa: E402

# Target length, mm; faces with elements; edges where more than two faces meet; free edges; meshes that hang together.
# None: the folder's README does not say.
MODELS = {"boxes_same_face": (8, 11, 4, 0, 1), "boxes_part_of_face": (8, 12, 4, 0, 1), "boxes_shifted": (8, 13, 4, 0, 1),
          "boxes_edge_only": (8, 12, 1, 0, 1), "boxes_crossing": (8, None, 6, 0, 1), "box_in_box": (6, 12, 0, 0, 2),
          "media_stacked": (8, 11, 4, 0, 1), "monopole_on_plate": (10, 9, 1, 0, 1),
          "monopole_through_plate": (10, None, 2, 0, 1), "fin_on_sheet": (8, 2, 1, 7, 1),
          "fin_on_sheet_fused": (8, 2, 1, 7, 1), "sheets_crossing": (8, None, 1, None, 1),
          "patches_on_board": (2, 8, 0, 0, 1), "reflectarray": (5, 106, 0, 0, 1), "microstrip": (2, None, 0, 0, 1),
          "sheets_1um_apart": (10, 2, 0, 8, 2), "sheets_1um_slit": (10, 2, 0, 8, 2)}
# The yardstick takes sheets that face the same way so near each other for overlapping elements.
NOT_JUDGED = ("sheets_1um_apart",)
# Parts so near each other that they may be meant to touch.
DOUBTFUL = ("sheets_1um_apart", "sheets_1um_slit")
# One closed skin each.
UNIONS = ("boxes_crossing", "box_in_box", "monopole_on_plate", "boxes_same_face")


def components(mesh):
    """Number of meshes that share no node."""
    root = np.arange(len(mesh.nodes))

    def find(i):
        while root[i] != i:
            root[i] = root[root[i]]
            i = root[i]
        return i
    for rows in (mesh.quads, mesh.triangles):
        for row in rows:
            for node in row[1:]:
                root[find(node)] = find(row[0])
    return len({find(i) for rows in (mesh.quads, mesh.triangles) for i in np.unique(rows)})


def check(job):
    """(line to print, faults) of one file."""
    path, folder = job
    name = os.path.splitext(os.path.basename(path))[0]
    size, faces, junctions, free, meshes = MODELS[name]
    out = os.path.join(folder, os.path.basename(path) + ".msh")
    run = runs.paver(path, out, "--size", size, "--threads", 1)
    if run.code != 0 or run.mesh is None:
        return os.path.basename(path), [f"exit code {run.code}: {run.output.strip()[-300:]}"]
    report, faults = run.report, []
    found = {"faces": sum(face["quads"] + face["triangles"] > 0 for face in report["faces"]),
             "junctions": report["model"]["nonmanifold_edges"], "free edges": report["model"]["free_edges"],
             "components": len(report["components"]), "meshes": components(run.mesh)}
    for what, wanted in (("faces", faces), ("junctions", junctions), ("free edges", free), ("components", meshes),
                         ("meshes", meshes)):
        if wanted is not None and found[what] != wanted:
            faults.append(f"{found[what]} {what}, not {wanted}")
    if report["verdict"] != ("doubtful" if name in DOUBTFUL else "sound"):
        faults.append(f"called {report['verdict']}")
    verdict = runs.judge(path, out, size, "--fuse")["verdict"] if runs.has_judge() else {"good": True}
    if not verdict["good"] and name not in NOT_JUDGED:
        faults.append(f"quality.py: {[k for k, v in verdict.items() if v is False]}")
    again = runs.paver(path, out + "2.msh", "--size", size, "--threads", 2)
    if again.report.get("checksum") != report["checksum"]:
        faults.append("another mesh on two threads")
    return f"{os.path.basename(path)}: {found}", faults


def check_union(job):
    """(line to print, faults): the outer skin, closed, in one piece."""
    path, folder = job
    out = os.path.join(folder, os.path.basename(path) + ".union.msh")
    run = runs.paver(path, out, "--size", 8, "--connect", "union", "--threads", 1)
    faults = [] if run.code == 0 else [f"exit code {run.code}: {run.output.strip()[-300:]}"]
    if run.code == 0 and not (run.report["quality"]["watertight"] and components(run.mesh) == 1):
        faults.append("no closed skin")
    return f"{os.path.basename(path)}, union", faults


def check_wires(path, folder):
    """(line to print, faults): wires are lines, and the end of one on a sheet is a node of both."""
    out = os.path.join(folder, os.path.basename(path) + ".msh")
    run = runs.paver(path, out, "--size", 8, "--threads", 1)
    if run.code != 0:
        return os.path.basename(path), [f"exit code {run.code}: {run.output.strip()[-300:]}"]
    faults = [] if run.report["quality"]["wire_lines"] > 0 else ["no lines"]
    if len(run.report["components"]) != 1:
        faults.append(f"{len(run.report['components'])} components")
    return f"{os.path.basename(path)}: {run.report['quality']['wire_lines']} lines", faults


def main():
    folder = runs.need_shared("contact")
    files = sorted(glob.glob(os.path.join(folder, "*.step")) + glob.glob(os.path.join(folder, "*.brep")))
    chosen = [f for f in files if not sys.argv[1:] or os.path.splitext(os.path.basename(f))[0] in sys.argv[1:]]

    def name(path):
        return os.path.splitext(os.path.basename(path))[0]
    faults = []
    with tempfile.TemporaryDirectory() as out, ThreadPoolExecutor(os.cpu_count()) as pool:
        found = [*pool.map(check, [(f, out) for f in chosen if name(f) in MODELS]),
                 *pool.map(check_union, [(f, out) for f in chosen if name(f) in UNIONS]),
                 *(check_wires(f, out) for f in chosen if name(f).startswith("wire"))]
    for line, wrong in found:
        print(f"{line}: {'; '.join(wrong) or 'good'}")
        faults += wrong
    sys.exit(1 if faults else 0)


if __name__ == "__main__":
    main()
