"""A sphere of 2.01 wave numbers against Mie's series: rms error of the amplitude by unknowns, orders 1 and 2."""
import numpy as np

import meshes
import mie
import pictures
import scattering

KA = 2.01
UNKNOWNS = (100, 200, 400, 800, 1600)
MODEL = f"{meshes.EXAMPLES}/sphere.step"
RADIUS = 100.0


def solved(mesh):
    """Unknowns and error of a mesh of the unit sphere."""
    functions = scattering.surface(mesh)
    along, across = mie.errors(functions, KA, threads=1)
    return {"unknowns": functions.unknowns, "triangles": len(mesh.triangles),
            "rms": float(f"{np.hypot(along, across) / np.sqrt(2):.4g}")}


def unit_sphere(kind, order, unknowns):
    """A mesh of about so many unknowns, of radius one about the origin."""
    make = meshes.maker(kind, MODEL, order)
    mesh, _ = meshes.about(make, unknowns, RADIUS * np.sqrt(8 * np.pi / unknowns))
    return meshes.scaled(mesh, 1 / RADIUS)


def compute(stored, unknowns=UNKNOWNS, kinds=None):
    """{(kind, order): cases from few to many unknowns}."""
    return {(kind, order): [stored.get(f"{kind} order {order} about {n}", lambda: solved(unit_sphere(kind, order, n)))
                            for n in unknowns]
            for order in (1, 2) for kind in kinds or meshes.kinds(stored)}


def power(cases):
    """p of the error h^p that fits best; h falls with the root of the unknowns."""
    return -2 * np.polyfit(np.log([c["unknowns"] for c in cases]), np.log([c["rms"] for c in cases]), 1)[0]


def at(cases, unknowns):
    """The error at so many unknowns, on the line between the cases beside it."""
    return np.exp(np.interp(np.log(unknowns), np.log([c["unknowns"] for c in cases]), np.log([c["rms"] for c in cases])))


def needed(cases, error):
    """Unknowns for an error, on the line that fits best."""
    slope, start = np.polyfit(np.log([c["rms"] for c in cases]), np.log([c["unknowns"] for c in cases]), 1)
    return np.exp(start + slope * np.log(error))


def draw(results, folder):
    figure, both = pictures.axes(2, sharey=True)
    for ax, order, title in zip(both, (1, 2), ("order 1: flat elements", "order 2: curved elements")):
        for (kind, given), cases in results.items():
            if given == order:
                ax.plot([c["unknowns"] for c in cases], [100 * c["rms"] for c in cases], **pictures.look(kind),
                        label=f"{meshes.KINDS[kind]}, $h^{{{power(cases):.1f}}}$")
        pictures.logarithmic(ax, UNKNOWNS)
        ax.set_title(title)
        ax.set_xlabel("unknowns")
        ax.legend()
    both[0].set_ylabel("rms error of the amplitude, %")
    pictures.save(figure, folder, "sphere")


def tables(results):
    lines = ["| mesh | order | error at 400 unknowns | at 1,500 | falls as | unknowns for 1 % |", "|---|---|---|---|---|---|"]
    for (kind, order), cases in results.items():
        lines.append(f"| {meshes.KINDS[kind]} | {order} | {100 * at(cases, 400):.2f} % | {100 * at(cases, 1500):.3f} % | "
                     f"h^{power(cases):.1f} | {needed(cases, 0.01):,.0f} |")
    return {"sphere": "\n".join(lines)}
