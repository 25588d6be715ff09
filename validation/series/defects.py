"""What faults of a mesh cost: nodes moved, flat elements, a seam that is not sewn, on a sphere; tips and flat elements on the
cone-sphere with slot."""
import numpy as np

import meshes
import pictures
from series import body, conesphere, sphere

UNKNOWNS = 768
SHIFTS = (0.05, 0.1, 0.2, 0.3)  # of nodes, in mean lengths of the elements
TIPS = (1, 4, 32)


def unit(places):
    return places / np.linalg.norm(places, axis=-1, keepdims=True)


def on_sphere(corners, quads):
    """A mesh of curved quads on the unit sphere: nodes of sides and middles halve the arcs between corners."""
    nodes, rows, known = list(unit(corners)), [], {}
    for quad in quads:
        row = list(quad)
        for group in [(quad[i], quad[(i + 1) % 4]) for i in range(4)] + [tuple(quad)]:
            key = tuple(sorted(group))
            if key not in known:
                known[key] = len(nodes)
                nodes.append(unit(sum(nodes[i] for i in group)))
            row.append(known[key])
        rows.append(row)
    return meshes.Mesh(np.array(nodes), np.array(rows), np.zeros((0, 6), int))


def shifted(mesh, share, seed=1):
    """The same quads with every corner moved on the sphere, by at most `share` of the elements' mean length."""
    used, quads = np.unique(mesh.quads[:, :4], return_inverse=True)
    corners = unit(mesh.nodes[used])
    chance = np.random.default_rng(seed)
    step = unit(np.cross(corners, chance.normal(size=corners.shape)))
    reach = share * np.sqrt(4 * np.pi / len(mesh.quads)) * np.sqrt(chance.random((len(corners), 1)))
    return on_sphere(corners + reach * step, quads.reshape(-1, 4))


def grid(n):
    """A cube's six sides with n x n quads each, put on the sphere: every node but eight is regular."""
    line = np.tan(np.pi / 4 * np.linspace(-1, 1, n + 1))
    places, quads = {}, []
    for axis in range(3):
        for side in (-1, 1):
            def node(i, j, axis=axis, side=side):
                place = np.empty(3)
                place[[axis, (axis + 1) % 3, (axis + 2) % 3]] = side, line[i], line[j]
                return places.setdefault(tuple(np.round(place, 9) + 0.0), len(places))
            for i in range(n):
                for j in range(n):
                    quad = [node(i, j), node(i + 1, j), node(i + 1, j + 1), node(i, j + 1)]
                    quads.append(quad if side > 0 else quad[::-1])
    return on_sphere(np.array(list(places)), quads)


def cut(mesh):
    """The same mesh with nodes of its own on either side of a line near the equator."""
    is_upper = mesh.nodes[mesh.quads[:, :4]].mean(1)[:, 2] > 0
    quads = np.where(is_upper[:, None], mesh.quads + len(mesh.nodes), mesh.quads)
    return mesh._replace(nodes=np.r_[mesh.nodes, mesh.nodes], quads=quads)


def compute(stored, unknowns=UNKNOWNS):
    """{"sphere": {name: case}, "cone-sphere": {name: case}, "fine": case}."""
    def paved():
        return sphere.unit_sphere("quads", 2, unknowns)

    makers = {"grid": lambda: grid(round(np.sqrt(unknowns / 12))), "Paver": lambda: shifted(paved(), 0),
              **{f"shift {share:g}": lambda share=share: shifted(paved(), share) for share in SHIFTS},
              "Gmsh": lambda: sphere.unit_sphere("gmsh-quads", 2, unknowns),
              "flat": lambda: sphere.unit_sphere("quads", 1, unknowns), "cut": lambda: cut(paved())}
    if not (meshes.has_gmsh() or stored.has("sphere Gmsh")):
        del makers["Gmsh"]
    round_body = {name: stored.get(f"sphere {name}", lambda: sphere.solved(make())) for name, make in makers.items()}
    fine = stored.beside("conesphere").get("fine", None)
    pointed = {f"tip {tip}": body.case(stored, conesphere.BODY, f"cone-sphere tip {tip}", "quads", 1000, tip=tip)
               for tip in TIPS}
    pointed["flat"] = body.case(stored, conesphere.BODY, "cone-sphere flat", "quads", 1000, order=1)
    return {"sphere": round_body, "cone-sphere": pointed, "fine": fine}


NAMES = {"grid": "grid of a cube", "Paver": "Paver", "Gmsh": "Gmsh, Blossom", "flat": "Paver, flat", "cut": "Paver, seam open",
         **{f"shift {share:g}": f"Paver, nodes moved {share:g} h" for share in SHIFTS}}
POINTED = {**{f"tip {tip}": f"tip h / {tip}" if tip > 1 else "tip h" for tip in TIPS}, "flat": f"tip h / {TIPS[-1]}, flat"}
COLOURS = {"Gmsh": "gmsh-quads", "flat": "wrong", "cut": "wrong", "grid": "other"}


def draw(found, folder):
    figure, (left, right) = pictures.axes(2)
    values = {k: 100 * c["rms"] for k, c in found["sphere"].items()}
    pictures.bars(left, [NAMES[k] for k in values], list(values.values()), [COLOURS.get(k, "quads") for k in values], "{:.2g} %")
    left.set_xlabel("rms error of the amplitude, %")
    left.set_title(f"sphere, ka 2.01, about {UNKNOWNS} unknowns")
    names, values, colours = [], [], []
    for key, case in found["cone-sphere"].items():
        for way, value in zip(("VV", "HH"), body.differences(case, found["fine"])):
            names.append(f"{POINTED[key]}: {way}")
            values.append(value)
            colours.append(COLOURS.get(key, "quads"))
    pictures.bars(right, names, values, colours, "{:.3f} dB")
    right.set_xlabel("mean difference, dB")
    right.set_title("cone-sphere, 869 MHz, about 1,000 unknowns")
    pictures.save(figure, folder, "defects")


def tables(found):
    good = found["sphere"]["Paver"]["rms"]
    lines = ["| sphere, ka 2.01 | unknowns | rms error | by that of Paver's mesh |", "|---|---|---|---|"]
    lines += [f"| {NAMES[k]} | {c['unknowns']} | {100 * c['rms']:.3f} % | {c['rms'] / good:.1f} |"
              for k, c in found["sphere"].items()]
    pointed = [body.TABLE_HEAD.replace("mesh", "cone-sphere with slot", 1)]
    pointed += [body.row(POINTED[k], c, found["fine"]) for k, c in found["cone-sphere"].items()]
    return {"defects sphere": "\n".join(lines), "defects tip": "\n".join(pointed)}
