"""Lengths, areas, frequencies and angles as the user writes and reads them: lengths in the unit that FreeCAD's preferences
choose, a number without a unit in the one that is shown.

FreeCAD's own texts are rounded to two digits, and its own fields give back what they show: 9.375 GHz would become 9.38.
"""
from typing import NamedTuple

import FreeCAD

DIGITS = 7
SHORT = 4  # digits of what is read only
MARKS = {'"': "in", "'": "ft"}  # as FreeCAD shows them, which it reads only in pairs
COMMON_LENGTH = 10.0  # mm, whose unit counts
FEW, MANY = 1e-4, 1e6  # of that unit; between them lengths stay in it, so that a bare number always means the same


class Unit(NamedTuple):
    """name: as it is shown; size: in FreeCAD's own unit, mm, Hz or degrees."""

    name: str
    size: float


# kind: units to show values in, from the largest on; None: those of FreeCAD's preferences
UNITS = {"frequency": tuple(Unit(*unit) for unit in (("THz", 1e12), ("GHz", 1e9), ("MHz", 1e6), ("kHz", 1e3), ("Hz", 1.0))),
         "length": None, "angle": (Unit("°", 1.0),)}
WRITTEN = {"frequency": "GHz", "length": "mm", "angle": "deg"}
COMMON = {"frequency": 1e9, "length": COMMON_LENGTH, "angle": 1.0}
MM = Unit("mm", 1.0)


def unit_of(kind, value=None):
    """The Unit to show a value in; without one, that of a common value."""
    value = abs(value) if value else COMMON[kind]
    if UNITS[kind] is None:
        common = preferred(COMMON[kind])
        return common if FEW <= value / common.size < MANY else preferred(value)
    return next((unit for unit in UNITS[kind] if value >= unit.size), UNITS[kind][-1])


def preferred(length):
    """The Unit that FreeCAD shows a length in."""
    _, size, name = FreeCAD.Units.Quantity(length, FreeCAD.Units.Length).getUserPreferred()
    name = MARKS.get(name, name)
    return Unit(name, size) if name.isalpha() else MM


def number_text(value, digits=DIGITS):
    return f"{value:.{digits}g}"


def with_unit(number, unit):
    return number + ("" if unit.name == "°" else " ") + unit.name


def quantity_text(kind, value, digits=DIGITS):
    """"9.375 GHz" of 9.375e9."""
    if value is None:
        return ""
    unit = unit_of(kind, value)
    return with_unit(number_text(value / unit.size, digits), unit)


def example(kind):
    """A value as a user may write it."""
    return {"frequency": "9 GHz", "angle": "45°"}.get(kind) or f"3 {unit_of('length').name}"


def parsed(kind, text, unit=None):
    """Value of what the user wrote; unit: of a number without one, else that of a common value. ValueError when it is no
    such quantity."""
    try:
        number = float(text.replace(",", "."))
    except ValueError:
        number = None
    if number is not None:
        return number * (unit or unit_of(kind)).size
    quantity = FreeCAD.Units.Quantity(text.replace("°", " deg"))
    if quantity.Unit != FreeCAD.Units.Quantity(f"1 {WRITTEN[kind]}").Unit:
        raise ValueError(text)
    return float(quantity.Value)


def length_text(value):
    """A length in mm that is read only."""
    return quantity_text("length", value, SHORT)


def lengths_text(values, between=", "):
    """Several in one unit, which stands once, after them."""
    values = [float(value) for value in values]
    unit = unit_of("length", max(map(abs, values), default=0))
    return with_unit(between.join(number_text(value / unit.size, SHORT) for value in values), unit)


def area_text(value):
    """An area in mm^2, in the square of the unit that lengths have."""
    unit = unit_of("length", abs(value) ** 0.5)
    return f"{number_text(value / unit.size ** 2, SHORT)} {unit.name}\u00b2"
