"""The cone-sphere with slot [Woo93] at 869 MHz: cross-sections over 181 angles against 3,900 unknowns, and those against a
solution without a mesh."""
import os

import numpy as np

import meshes
import revolved
import scattering
from series import body

BODY = body.Body(os.path.join(meshes.SHARED, "tips", "conesphere_slot_20faces.step"), 869e6, body.around(181), 23,
                 (500, 1000, 2000), 3900, 3600, tip=(-605.05, 0, 0))
INCH = 25.4
TIP, RADIUS, MIDDLE, FLOOR, SLOT = (INCH * x for x in (-23.821, 2.947, 0.359, 2.697, 0.25))  # mm; the slot begins at x = 0


def outline(step):
    """Nodes (x, radius) from tip to sphere's end, `step` apart; closer at the tip and in the slot."""
    base = -TIP * np.tan(np.radians(7))
    lengths = np.minimum(step, step / meshes.TIP * 1.3 ** np.arange(1000))
    shares = np.cumsum(lengths) / np.hypot(TIP, base)
    shares = np.r_[0, shares[:np.searchsorted(shares, 1) + 1]]
    shares /= shares[-1]
    start = np.arccos((SLOT - MIDDLE) / RADIUS)
    bends = [(0, base), (0, FLOOR), (SLOT, FLOOR), (SLOT, RADIUS * np.sin(start))]
    parts = [np.c_[TIP * (1 - shares), base * shares][:-1]]
    for a, b in zip(bends, bends[1:]):
        count = int(np.ceil(np.hypot(*np.subtract(b, a)) / min(step, SLOT / 4)))
        parts.append(np.linspace(a, b, count + 1)[:-1])
    angles = np.linspace(start, 0, int(np.ceil(RADIUS * start / step)) + 1)
    parts.append(np.c_[MIDDLE + RADIUS * np.cos(angles), RADIUS * np.sin(angles)])
    nodes = np.concatenate(parts)
    nodes[[0, -1], 1] = 0
    return nodes


def without_mesh(stored, frequency, step, modes):
    """The case by Fourier's series about the axis; VV is across the plane with the axis, HH in it."""
    def solve():
        nodes = outline(step)
        angles = np.linspace(0, np.pi, len(BODY.angles))
        found = revolved.monostatic(nodes, 2 * np.pi * frequency / scattering.LIGHT, angles, modes)
        curves = 10 * np.log10(4 * np.pi * np.abs(found) ** 2 * 1e-6)
        return {"unknowns": 2 * len(nodes) - 3, "modes": modes, "vv": [round(x, 3) for x in curves[:, 1]],
                "hh": [round(x, 3) for x in curves[:, 0]]}

    return stored.get(f"without mesh, {step:g} mm, {modes} modes", solve)


def compute(stored):
    return {**body.compare(stored, BODY), "without mesh": without_mesh(stored, BODY.frequency, 3, 8)}


def draw(found, folder):
    body.draw(found, BODY, folder, "conesphere", "angle from the sphere's end")


def tables(found):
    vv, hh = body.differences(found["without mesh"], found["fine"])
    return {"conesphere": body.table(found) + f"\n| without a mesh | | | {vv:.3f} | {hh:.3f} |"}
