"""Conducting sheets that touch: cross-sections of meshes in which they share nodes against meshes in which they do not."""
import math
import os
import tempfile
from typing import NamedTuple

import numpy as np

import meshes
import pictures
from series import body

COUNT = 91
DEGREES = np.linspace(0, 180, COUNT)


class Subject(NamedTuple):
    """name: of the model below; phi: the plane of the waves, degrees; sizes: coarse and fine target length, mm."""
    title: str
    name: str
    frequency: float
    phi: float
    sizes: tuple


SUBJECTS = (Subject("fin on a plate", "fin", 2.5e9, 90, (12, 7)), Subject("strip on a plate", "strip", 1.15e9, 90, (22, 12)),
            Subject("two patches with walls", "patches", 2.9e9, 0, (10, 6)),
            Subject("three patches on posts", "posts", 1.8e9, 0, (9, 5)))
HEIGHTS = (3, 6, 9)  # mm, of the patches on posts


def _sheet(occ, x, y, z, width, height, stands=""):
    """A rectangle; one that stands has its height along z, its width along the axis named."""
    tag = occ.addRectangle(x, y, z, width, height)
    if stands:
        occ.rotate([(2, tag)], x, y, z, 1, 0, 0, math.pi / 2)
    if stands == "y":
        occ.rotate([(2, tag)], x, y, z, 0, 0, 1, math.pi / 2)


def _add_sheets(occ, name):
    if name == "fin":
        _sheet(occ, 0, 0, 0, 100, 100)
        _sheet(occ, 20, 50, 0, 60, 30, "x")
    elif name == "strip":
        _sheet(occ, 0, 0, 0, 200, 200)
        _sheet(occ, 98, 100, 0, 4, 60, "x")
    elif name == "posts":
        _sheet(occ, 0, 0, 0, 150, 60)
        for x, height in zip((15, 63, 111), HEIGHTS):
            _sheet(occ, x, 18, height, 24, 24)
            _sheet(occ, x + 2, 28, 0, 4, height, "y")
    else:
        _sheet(occ, 0, 0, 0, 120, 60)
        for x in (20, 80):
            _sheet(occ, x, 20, 4, 20, 20)
            _sheet(occ, x, 20, 0, 20, 4, "y")


def write_model(name, path):
    """Sheets as drawn: they touch, none is cut or fused."""
    import gmsh
    gmsh.initialize()
    try:
        gmsh.option.setNumber("General.Terminal", 0)
        _add_sheets(gmsh.model.occ, name)
        gmsh.model.occ.synchronize()
        gmsh.write(path)
    finally:
        gmsh.finalize()


def solved(subject, size, connect):
    angles = np.c_[np.radians(DEGREES), np.full(COUNT, np.radians(subject.phi))]
    with tempfile.TemporaryDirectory() as folder:
        path = os.path.join(folder, subject.name + ".brep")
        write_model(subject.name, path)
        mesh = meshes.ours(path, size, connect=connect)
    return body.solved(mesh, subject.frequency, angles)


def compute(stored, subjects=SUBJECTS):
    """{title: {(how, "coarse" | "fine"): case}}."""
    return {s.title: {(how, fineness): stored.get(f"{s.name} {how} {fineness}", lambda: solved(s, size, how))
                      for how in ("imprint", "none") for fineness, size in zip(("coarse", "fine"), s.sizes)}
            for s in subjects}


def draw(results, folder):
    figure, panels = pictures.plt.subplots(2, 2, figsize=(8.8, 6.4), layout="constrained", squeeze=False)
    panels = panels.ravel()
    for ax, (title, found), subject in zip(panels, results.items(), SUBJECTS):
        lines = [("connected", "quads", found["imprint", "fine"]), ("not connected", "wrong", found["none", "fine"])]
        body.draw_curves(ax, DEGREES, lines, 0, "angle from the plate's normal")
        ax.set_title(f"{title}, {subject.frequency / 1e9:g} GHz, VV")
    panels[0].legend()
    pictures.save(figure, folder, "connection")


def tables(results):
    lines = ["| | unknowns | connected, coarser mesh: VV, dB | not connected: VV, dB | the same, coarser mesh: VV, dB |",
             "|---|---|---|---|---|"]
    for title, found in results.items():
        fine = found["imprint", "fine"]
        vv = [body.differences(found[key], fine)[0] for key in (("imprint", "coarse"), ("none", "fine"), ("none", "coarse"))]
        lines.append(f"| {title} | {found['imprint', 'coarse']['unknowns']:,}, {fine['unknowns']:,} | "
                     + " | ".join(f"{x:.2f}" for x in vv) + " |")
    return {"connection": "\n".join(lines)}
