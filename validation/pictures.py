"""How the pictures look: one colour and mark per kind of mesh, axes with units, files that differ only where the data do."""
import os

import matplotlib
import numpy as np

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402
from matplotlib.ticker import FixedLocator, LogLocator, NullFormatter, NullLocator  # noqa: E402

LOOKS = {"quads": ("#1f5fa8", "s", "-"), "triangles": ("#d9822b", "^", "-"), "gmsh-triangles": ("#3d8b40", "v", "--"),
         "gmsh-quads": ("#8a4f9e", "D", "--"), "reference": ("#222222", "", "-"), "wrong": ("#c23b3b", "o", "-"),
         "other": ("#777777", "o", ":")}
plt.rcParams.update({"font.size": 9, "axes.grid": True, "grid.color": "#dddddd", "grid.linewidth": 0.6, "lines.linewidth": 1.4,
                     "lines.markersize": 4.5, "legend.fontsize": 8, "legend.frameon": False, "svg.hashsalt": "paver",
                     "axes.spines.top": False, "axes.spines.right": False, "axes.axisbelow": True, "axes.titlesize": 9})


def look(kind):
    """Arguments of plot() for a kind of mesh."""
    colour, mark, line = LOOKS[kind]
    return {"color": colour, "marker": mark, "linestyle": line}


def axes(columns=2, height=3.3, **options):
    """(figure, axes): some beside each other, as wide as a page."""
    return plt.subplots(1, columns, figsize=(4.4 * columns, height), layout="constrained", **options)


def logarithmic(ax, unknowns=()):
    """Both axes; the lower one marked at the given numbers."""
    ax.set_xscale("log")
    ax.set_yscale("log")
    ax.yaxis.set_major_locator(LogLocator(subs=(1, 2, 5)))
    ax.yaxis.set_major_formatter(lambda value, _: f"{value:g}")
    ax.yaxis.set_minor_formatter(NullFormatter())
    if unknowns:
        ax.xaxis.set_major_locator(FixedLocator(list(unknowns)))
        ax.xaxis.set_major_formatter(lambda value, _: f"{value:,.0f}")
        ax.xaxis.set_minor_locator(NullLocator())
        ax.xaxis.set_minor_formatter(NullFormatter())


def angle_axis(ax, label, step=30, most=180):
    ax.set_xlim(0, most)
    ax.set_xticks(range(0, most + 1, step))
    ax.set_xlabel(f"{label}, degrees")


def bars(ax, names, values, kinds, form):
    """Logarithmic bars from top to bottom, each with its value; `kinds`: of LOOKS."""
    places, least = range(len(names))[::-1], min(values) / 2
    ax.barh(places, np.subtract(values, least), left=least, color=[LOOKS[kind][0] for kind in kinds], height=0.6)
    ax.set_yticks(list(places), names)
    ax.set_xscale("log")
    ax.xaxis.set_major_locator(LogLocator(subs=(1, 2, 5) if max(values) < 20 * least else (1,)))
    ax.xaxis.set_major_formatter(lambda value, _: f"{value:g}")
    ax.xaxis.set_minor_formatter(NullFormatter())
    ax.set_xlim(least, max(values) * 4)
    ax.grid(False, axis="y")
    for y, value in zip(places, values):
        ax.text(value * 1.08, y, form.format(value), va="center", fontsize=8)


def save(figure, folder, name):
    figure.savefig(os.path.join(folder, name + ".svg"), metadata={"Date": None})
    plt.close(figure)
