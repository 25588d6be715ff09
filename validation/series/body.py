"""What the series of one body have in common: curves of several meshes of it against those of a fine one."""
from dataclasses import dataclass, field

import numpy as np

import meshes
import pictures
import scattering

TABLE_HEAD = "| mesh | unknowns | triangles of its elements | VV, dB | HH, dB |\n|---|---|---|---|---|"
GRADED = ", tip graded"


@dataclass
class Body:
    """A conducting body, a frequency, and the meshes of it that are compared.

    angles: (n, 2) theta and phi, radians. size: target length in mm that makes about `first` unknowns. fine: unknowns of
    the mesh of quads that all are compared with; check: those of one of triangles, to see how far it can be trusted. scale: of
    the nodes. tip: where it is, for a mesh of Gmsh's to be graded there like Paver's.
    """
    model: str
    frequency: float
    angles: np.ndarray
    size: float
    unknowns: tuple
    fine: int
    check: int
    first: int = 1000
    scale: float = 1.0
    tip: tuple = None
    options: dict = field(default_factory=dict)


def around(count, theta=90.0, most=180.0):
    """Directions in the plane z = 0 from the x axis."""
    phi = np.radians(np.linspace(0, most, count))
    return np.c_[np.full(count, np.radians(theta)), phi]


def solved(mesh, frequency, angles, share=1.0):
    """share: of the electric field equation in the combined one."""
    functions = scattering.surface(mesh)
    equation = scattering.scatterer(functions, frequency, share, threads=1)
    curves = scattering.monostatic(equation, angles)
    return {"unknowns": functions.unknowns, "elements": len(mesh.quads) + len(mesh.triangles),
            "triangles": len(mesh.triangles), "vv": [round(x, 3) for x in curves[:, 0]],
            "hh": [round(x, 3) for x in curves[:, 1]]}


def curves(case):
    return np.c_[case["vv"], case["hh"]]


def case(stored, body, key, kind, unknowns, order=2, tip_at=None, frequency=None, **options):
    """The stored or solved curves of one mesh."""
    frequency = frequency or body.frequency

    def solve():
        make = meshes.maker(kind, body.model, order, tip_at, **body.options, **options)
        mesh, _ = meshes.about(make, unknowns, body.size * np.sqrt(body.first / unknowns))
        return solved(meshes.scaled(mesh, body.scale), frequency, body.angles)

    return stored.get(key, solve)


def differences(found, fine):
    """(VV, HH): mean differences in dB."""
    return scattering.difference(curves(found), curves(fine))


def compare(stored, body, name="", frequency=None):
    """{"fine": case, "check": fine triangles, to judge the fine quads by, kind: cases}."""
    found = {"fine": case(stored, body, f"{name}fine", "quads", body.fine, frequency=frequency),
             "check": case(stored, body, f"{name}check: fine triangles", "triangles", body.check, frequency=frequency)}
    for kind in meshes.kinds(stored):
        found[kind] = [case(stored, body, f"{name}{kind} about {n}", kind, n, frequency=frequency) for n in body.unknowns]
        if body.tip and kind.startswith("gmsh"):
            n = body.unknowns[1]
            found[kind + GRADED] = case(stored, body, f"{name}{kind} about {n} graded", kind, n, tip_at=body.tip,
                                        frequency=frequency)
    return found


def draw_differences(ax, found, body):
    """Mean of VV's and HH's difference by unknowns."""
    for kind in meshes.KINDS:
        if kind in found:
            ax.plot([c["unknowns"] for c in found[kind]], [differences(c, found["fine"]).mean() for c in found[kind]],
                    **pictures.look(kind), label=meshes.KINDS[kind])
        if kind + GRADED in found:
            graded = found[kind + GRADED]
            ax.plot(graded["unknowns"], differences(graded, found["fine"]).mean(), label=meshes.KINDS[kind] + GRADED,
                    **{**pictures.look(kind), "markerfacecolor": "white", "linestyle": ""})
    pictures.logarithmic(ax, body.unknowns)
    ax.set_xlabel("unknowns")
    ax.set_ylabel("mean difference of VV and HH, dB")


def draw_curves(ax, degrees, lines, column, label):
    """Cross-sections by angle; `lines`: (name, look, case)."""
    for name, kind, found in lines:
        ax.plot(degrees, curves(found)[:, column], **{**pictures.look(kind), "marker": ""}, label=name)
    pictures.angle_axis(ax, label, most=int(round(degrees[-1])))
    ax.set_ylabel("cross-section, dBsm")


def draw_both(vv, hh, degrees, found, number, label, more=()):
    """VV and HH of the fine mesh and of mesh `number` of Paver's quads and of Gmsh's triangles; `more` lines first."""
    lines = [*more, (f"{found['fine']['unknowns']:,} unknowns, {meshes.KINDS['quads']}", "reference", found["fine"])]
    lines += [(f"{found[k][number]['unknowns']:,} unknowns, {meshes.KINDS[k]}", k, found[k][number])
              for k in ("quads", "gmsh-triangles") if k in found]
    for ax, column, title in ((vv, 0, "VV"), (hh, 1, "HH")):
        draw_curves(ax, degrees, lines, column, label)
        ax.set_title(title)
    hh.legend()


def draw(found, body, folder, name, label):
    """Differences, and cross-sections over the angles of a half circle; label: of the angles."""
    figure, (left, middle, right) = pictures.axes(3)
    draw_differences(left, found, body)
    left.set_title(f"{body.frequency / 1e9:g} GHz: against {found['fine']['unknowns']:,} unknowns")
    left.legend()
    draw_both(middle, right, np.linspace(0, 180, len(body.angles)), found, 0, label)
    pictures.save(figure, folder, name)


def table(found):
    return "\n".join([TABLE_HEAD, *rows(found, 1), check_row(found)])


def row(name, found, fine):
    vv, hh = differences(found, fine)
    return f"| {name} | {found['unknowns']:,} | {found['triangles']} of {found['elements']} | {vv:.3f} | {hh:.3f} |"


def rows(found, at):
    """Lines of a table: mesh `at` of each kind, from few to many unknowns, and those with graded tips."""
    lines = [row(meshes.KINDS[kind], found[kind][at], found["fine"]) for kind in meshes.KINDS if kind in found]
    return lines + [row(meshes.KINDS[kind] + GRADED, found[kind + GRADED], found["fine"]) for kind in meshes.KINDS
                    if kind + GRADED in found]


def check_row(found):
    """The line of the fine triangles: what the fine quads that all are compared with are known to."""
    return row("Paver, fine triangles", found["check"], found["fine"])
