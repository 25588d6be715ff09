"""The NASA almond [Woo93] at 3.5 and 7 GHz: cross-sections over 91 angles against 3,000 unknowns, and against measurements and
a simulation of others [Kelley20], whose curves are in austin_almond.json."""
import json
import os

import numpy as np

import meshes
import pictures
import scattering
from series import body

BODY = body.Body(os.path.join(meshes.SHARED, "tips", "almond_8faces.step"), 3.5e9, body.around(91), 8.9, (700, 1400), 3000, 3000,
                 tip=(147.22, 0, 0))
DEGREES = np.linspace(0, 180, 91)
FREQUENCIES = {"3.5 GHz": (3.5e9, "fx1"), "7 GHz": (7e9, "fx3")}
OTHERS = {"ref": "simulated [Kelley20]", "meas.m1": "measured, 252 mm", "meas.m2": "measured, twice the size"}
CURVES = os.path.join(os.path.dirname(os.path.dirname(os.path.abspath(__file__))), "docs", "figures", "austin_almond.json")


def published(folder):
    """What austin_almond.json has: {"frequency name": {"vv", "hh": dBsm at DEGREES}}, of the files in `folder`."""
    found = {}
    for title, (_, key) in FREQUENCIES.items():
        for name in OTHERS:
            curve = {}
            for way in "VH":
                table = np.loadtxt(os.path.join(folder, f"{name}_rcs.III.A.s1.{key}.{way}.txt"))
                degrees = np.abs(table[:, 2])
                curve[2 * way.lower()] = [round(float(x), 2) for x in np.interp(DEGREES, degrees, table[:, 3])]
            found[f"{title} {name}"] = curve
    return found


def compute(stored):
    """{frequency: {"fine", kind: cases, name of others: curves}}."""
    with open(CURVES) as f:
        others = json.load(f)["curves"]
    return {title: {**body.compare(stored, BODY, f"{title} ", frequency=frequency),
                    **{name: others[f"{title} {name}"] for name in OTHERS}}
            for title, (frequency, _) in FREQUENCIES.items()}


def draw(results, folder):
    figure, panels = pictures.plt.subplots(2, 3, figsize=(13.2, 6.4), layout="constrained")
    for row, (title, found) in zip(panels, results.items()):
        body.draw_differences(row[0], found, BODY)
        row[0].set_title(f"{title}: against {found['fine']['unknowns']:,} unknowns")
        for ax, column, way in zip(row[1:], (0, 1), ("VV", "HH")):
            lines = [(OTHERS["meas.m1"], "other", found["meas.m1"]), (OTHERS["ref"], "reference", found["ref"]),
                     (f"{found['quads'][-1]['unknowns']:,} unknowns, {meshes.KINDS['quads']}", "quads", found["quads"][-1])]
            body.draw_curves(ax, DEGREES, lines, column, "angle from the tip")
            ax.set_title(f"{title}, {way}")
    panels[0][0].set_ylim(bottom=panels[0][0].get_ylim()[0] / 4)  # room for the legend
    panels[0][0].legend(loc="lower left")
    panels[0][2].legend()
    pictures.save(figure, folder, "almond")


def tables(results):
    lines, others = ["| frequency " + line for line in body.TABLE_HEAD.split("\n")], []
    lines[1] = "|---" + body.TABLE_HEAD.split("\n")[1]
    heads = [f"| frequency | mesh | unknowns | {' | '.join(f'{name}: VV, HH' for name in OTHERS.values())} |",
             "|---" * (3 + len(OTHERS)) + "|"]
    for title, found in results.items():
        lines += [f"| {title} {line}" for line in [*body.rows(found, -1), body.check_row(found)]]
        for name, case in ([(meshes.KINDS[k], found[k][-1]) for k in ("quads", "gmsh-triangles") if k in found]
                           + [("Paver, quads", found["fine"])]):
            cells = ["{:.2f}, {:.2f}".format(*scattering.difference(body.curves(case), body.curves(found[o])))
                     for o in OTHERS]
            others.append(f"| {title} | {name} | {case['unknowns']:,} | {' | '.join(cells)} |")
    return {"almond": "\n".join(lines), "almond published": "\n".join(heads + others)}
