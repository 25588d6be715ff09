"""Paver beside the best value per column that any peer with a valid mesh reaches (peers.csv), as table rows."""
import csv
import json
import math
import os
import sys

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import runs  # noqa: E402

HEAD = ["model", "N asked", "N", "count/ideal", "mean SJ", "min SJ", "irregular %", "length CV", "outside 0.7-1.3 h %",
        "triangles", "verdict", "misses", "s"]
# Example that stands for a peers' model where the names differ: theirs is the one of a single face.
EXAMPLE = {"conesphere": "conesphere_one_face"}


def table():
    """Rows of peers.csv, numbers as floats; None where no peer has a valid mesh."""
    with open(os.path.join(os.path.dirname(os.path.abspath(__file__)), "peers.csv")) as f:
        return [{k: v if k == "model" else float(v) if v else None for k, v in row.items()} for row in csv.DictReader(f)]


def model_and_area(name, areas):
    """The peers' own geometry where the shared folder has it, else the example of that name."""
    geometry = os.path.join(runs.SHARED, "tools", "peers", "geometry")
    manifest = os.path.join(geometry, "manifest.json")
    if os.path.exists(manifest):
        with open(manifest) as f:
            known = json.load(f)
        if name in known:
            return os.path.join(geometry, name + ".step"), known[name]["area_mm2"]
    name = EXAMPLE.get(name, name)
    path = next(p for p in runs.examples() if os.path.basename(p).split(".")[0] == name)
    return path, areas[name]


def figures_of(judged, size):
    """Paver's values of the columns of peers.csv, as the table shows them, and count/ideal."""
    counts, chord = judged["counts"], judged["edges"]["chord"]
    elements = counts["quads"] + 0.5 * counts["triangles"]
    return {"ratio": elements * size * size / judged["area"]["cad"],
            "mean_sj": judged["shape"]["quads"]["scaled_jacobian"]["mean"],
            "min_sj": judged["shape"]["all"]["scaled_jacobian"]["min"],
            "irregular": 100 * (judged["valence"]["irregular_fraction_face_interior"] or 0),
            "cv": chord["cov"], "outside": 100 * chord["fraction_outside_0.7_to_1.3"],
            "triangles": counts["triangles"]}


# Column: decimals, and whether more is better.
COLUMNS = {"mean_sj": (3, True), "min_sj": (2, True), "irregular": (1, False), "cv": (3, False), "outside": (1, False),
           "triangles": (0, False)}


def cells_of(figures, best):
    """Cells "ours (best peer)" per column, and the names of the columns where a peer is better.

    Of shape and valence a little is nothing: 0.01 of mean SJ, 1.5 % irregular nodes."""
    cells, misses = [], []
    for column, (decimals, is_more_better) in COLUMNS.items():
        ours, theirs = round(figures[column], decimals), best[column]
        if theirs is None:
            cells.append(f"{ours:.{decimals}f} (none)")
            continue
        if column == "mean_sj":
            is_miss = ours < theirs - 0.01
        elif column == "irregular":
            is_miss = ours > max(theirs, 1.5)
        else:
            is_miss = ours < theirs if is_more_better else ours > theirs
        cells.append(f"{'**' if is_miss else ''}{ours:.{decimals}f}{'**' if is_miss else ''} ({theirs:.{decimals}f})")
        if is_miss:
            misses.append(column)
    return cells, misses


def row_of(best, areas, order, folder):
    """One row of the table."""
    model, area = model_and_area(best["model"], areas)
    n = int(best["n"])
    size = math.sqrt(area / n)
    out = os.path.join(folder, f"{best['model']}_{n}.msh")
    run = runs.paver(model, out, "--size", repr(size), "--order", order, "--threads", 1, limit=1800)
    if run.mesh is None:
        return [best["model"], str(n), "no mesh"] + [""] * (len(HEAD) - 3)
    judged = runs.judge(model, out, size)
    verdict = judged["verdict"]
    if "counts" not in judged:
        return [best["model"], str(n), "not judged", verdict["error"]] + [""] * (len(HEAD) - 4)
    figures = figures_of(judged, size)
    cells, misses = cells_of(figures, best)
    said = "good" if verdict["good"] else " ".join(k for k, v in verdict.items() if v is False and k != "good")
    return [best["model"], str(n), str(judged["counts"]["elements"]), f"{figures['ratio']:.3f}", *cells, said,
            " ".join(misses) or "-", f"{run.seconds:.2f}"]
