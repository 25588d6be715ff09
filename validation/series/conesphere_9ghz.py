"""The cone-sphere with slot [Woo93] at 9 GHz, 21 wavelengths long, with about 8,000 unknowns against a solution without a mesh.

Five elements per wavelength, as many unknowns as the literature on paving solves; ten would take 32,000. Long: 4 GB of memory,
forty minutes on one thread.
"""
import numpy as np

import meshes
import pictures
from series import body, conesphere

BODY = conesphere.BODY
FREQUENCY = 9e9
SIZE, UNKNOWNS, FINE = 7, 8000, 14500
STEP, MODES = 0.9, 24
LABEL = "angle from the sphere's end"


def case(stored, key, kind, unknowns, share=1.0, tip_at=None, **options):
    """The stored or solved curves of one mesh; share: of the electric field equation in the combined one."""
    def solve():
        mesh, _ = meshes.about(meshes.maker(kind, BODY.model, tip_at=tip_at, **options), unknowns, SIZE * np.sqrt(UNKNOWNS / unknowns))
        return body.solved(mesh, FREQUENCY, BODY.angles, share)

    return stored.get(key, solve)


def compute(stored):
    """{name of a line: case}, and "without mesh"."""
    found = {"without mesh": conesphere.without_mesh(stored, FREQUENCY, STEP, MODES)}
    for kind in meshes.kinds(stored):
        found[kind] = case(stored, f"{kind} about {UNKNOWNS}", kind, UNKNOWNS)
    for kind in meshes.kinds(stored):
        if kind.startswith("gmsh"):
            found[kind + body.GRADED] = case(stored, f"{kind} about {UNKNOWNS} graded", kind, UNKNOWNS, tip_at=BODY.tip)
    found["combined"] = case(stored, f"quads about {UNKNOWNS} combined", "quads", UNKNOWNS, share=0.5)
    found["edges"] = case(stored, f"quads about {UNKNOWNS} edges finer", "quads", UNKNOWNS, grade_edges=2)
    found["fine"] = case(stored, "fine", "quads", FINE)
    return found


def lines(found):
    """(name, look, case) of all meshes."""
    names = {**meshes.KINDS, **{k + body.GRADED: name + body.GRADED for k, name in meshes.KINDS.items()},
             "combined": "Paver, quads, combined equation", "edges": "Paver, quads, edges finer", "fine": "Paver, quads, finer"}
    looks = {"combined": "other", "edges": "quads", "fine": "reference"}
    return [(names[key], looks.get(key, key.replace(body.GRADED, "")), case) for key, case in found.items() if key in names]


def draw(found, folder):
    exact = found["without mesh"]
    figure, (left, middle, right) = pictures.axes(3, height=4)
    names, values, kinds = [], [], []
    for name, look, case_ in lines(found):
        for way, value in zip(("VV", "HH"), body.differences(case_, exact)):
            names.append(f"{name}: {way}")
            values.append(value)
            kinds.append(look)
    pictures.bars(left, names, values, kinds, "{:.2f} dB")
    left.set_xlabel("mean difference, dB")
    left.set_title(f"9 GHz, about {UNKNOWNS:,} unknowns, finer: {found['fine']['unknowns']:,}")
    body.draw_both(middle, right, np.linspace(0, 180, len(BODY.angles)), {"quads": [found["quads"]], "fine": found["fine"]}, 0, LABEL,
                   [("without a mesh", "wrong", exact)])
    right.get_legend().remove()
    middle.legend(loc="lower left", fontsize=7, handlelength=1.2)
    pictures.save(figure, folder, "conesphere_9ghz")


def tables(found):
    return {"conesphere 9 GHz": "\n".join([body.TABLE_HEAD] + [body.row(name, case_, found["without mesh"])
                                                               for name, _, case_ in lines(found)])}
