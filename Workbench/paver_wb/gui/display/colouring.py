"""A colour for every element, and what the colour bar tells about it."""
from typing import NamedTuple

import FreeCAD
import numpy as np

from paver_wb.base.units import lengths_text
from paver_wb.gui.display import colour_maps

NONE, SJ, LENGTH, LOCAL_LENGTH, KIND, FACE, CERTIFICATE = CHOICES = (
    "None", "Scaled Jacobian", "Edge length / target", "Edge length / local target", "Element type", "Source face",
    "Certificate")
STANDARD, DATA, MANUAL = RANGES = ("Standard", "Data", "Manual")
OWN_MAP = "Standard"
BINS = 24
MOST_ENTRIES = 14

translate = FreeCAD.Qt.translate


class Scale(NamedTuple):
    """A colour bar. unit: a line of text, may be empty. histogram: (bins,) counts of elements from low to high; those outside are in the first and last."""

    title: str
    unit: str
    low: float
    high: float
    table: object
    histogram: object
    least: float
    mean: float
    most: float


class Key(NamedTuple):
    """A list of colours. entries: (label, (red, green, blue), count of elements)."""

    title: str
    entries: list


class Colouring(NamedTuple):
    """colours: (elements,) as Coin packs them, None for one colour; legend: Scale, Key or None."""

    colours: object
    legend: object


class Wish(NamedTuple):
    """What the user has chosen. limits: (low, high) of the range MANUAL."""

    by: str
    colour_map: str
    range: str
    limits: tuple


def of_mesh(mesh, wish):
    """Colouring of a DrawnMesh."""
    if wish.by == SJ:
        return scaled(mesh.quality.sj, translate("Paver", "Scaled Jacobian"), "", (0, 1), "Quality", wish)
    if wish.by == LENGTH:
        return scaled(mesh.longest_edges / (mesh.target or 1), translate("Paver", "Longest edge / target"),
                      range_text(mesh.target, mesh.target), (0, 2), "Deviation", wish)
    if wish.by == LOCAL_LENGTH:
        targets = mesh.edge_targets
        values = np.fmax.reduce(mesh.edge_lengths / np.maximum(targets, 1e-300), axis=1)
        return scaled(values, translate("Paver", "Longest edge / local target"),
                      range_text(np.nanmin(targets), np.nanmax(targets)) if len(targets) else "", (0, 2), "Deviation", wish)
    if wish.by == KIND:
        return by_kind(mesh)
    if wish.by == FACE:
        return by_face(mesh)
    if wish.by == CERTIFICATE:
        return by_certificate(mesh)
    return Colouring(None, None)


def range_text(low, high):
    """Of lengths in mm."""
    ends = [low] if np.isclose(low, high, rtol=1e-3) else [low, high]
    return translate("Paver", "target {}").format(lengths_text(ends, " \u2013 "))


def limits_of(values, standard, wish):
    low, high = standard
    if wish.range == MANUAL:
        low, high = wish.limits
    elif wish.range == DATA and len(values):
        low, high = float(values.min()), float(values.max())
    return (low, high) if high > low else (low, low + 1e-6 * max(1, abs(low)))


def scaled(values, title, unit, standard, own_map, wish):
    low, high = limits_of(values, standard, wish)
    table = colour_maps.table(own_map if wish.colour_map == OWN_MAP else wish.colour_map)
    share = np.clip((values - low) / (high - low), 0, 1)
    colours = colour_maps.packed(table)[np.minimum((share * colour_maps.SIZE).astype(int), colour_maps.SIZE - 1)]
    histogram = np.bincount(np.minimum((share * BINS).astype(int), BINS - 1), minlength=BINS)
    figures = [float(f()) for f in (values.min, values.mean, values.max)] if len(values) else [0.0] * 3
    return Colouring(colours, Scale(title, unit, low, high, table, histogram, *figures))


def listed(title, numbers, labels, colours):
    """Colouring by numbers 0, 1, ...; entries that no element has are left out."""
    counts = np.bincount(numbers, minlength=len(labels))
    entries = [(label, tuple(colour), int(count)) for label, colour, count in zip(labels, colours, counts) if count]
    return Colouring(colour_maps.packed(np.asarray(colours))[numbers], Key(title, entries))


def by_kind(mesh):
    numbers = np.repeat([0, 1], [mesh.quad_count, mesh.triangle_count])
    labels = [translate("Paver", "Quad"), translate("Paver", "Triangle")]
    return listed(translate("Paver", "Element type"), numbers, labels, [(0.55, 0.70, 0.82), (0.93, 0.45, 0.18)])


def by_face(mesh):
    return listed(translate("Paver", "Source face"), mesh.faces, mesh.face_names, colour_maps.distinct(len(mesh.face_names)))


def by_certificate(mesh):
    labels = [translate("Paver", "Valid, proven"), translate("Paver", "Inverted"), translate("Paver", "Undecided")]
    title = translate("Paver", "Certificate, order {}").format(mesh.order)
    return listed(title, mesh.quality.validity.astype(int), labels,
                  [(0.35, 0.68, 0.52), (0.78, 0.10, 0.14), (0.95, 0.75, 0.20)])
