"""Printed circuits: sheets of metal that lie on a board, touching it and each other but not fused. Lengths in mm."""
import Part
from FreeCAD import Vector


def strip(x0, y0, x1, y1, z):
    """A rectangular sheet."""
    return Part.makePlane(x1 - x0, y1 - y0, Vector(x0, y0, z))


def reflectarray(columns=10, rows=10, pitch=15.0, smallest=6.0, largest=12.0, thickness=1.6):
    """Square patches on a grounded board. Their sides vary over the aperture, as the phases of a reflected beam do."""
    width, height = columns * pitch, rows * pitch
    parts = [Part.makeBox(width, height, thickness), strip(0, 0, width, height, 0)]
    for i in range(columns):
        for j in range(rows):
            x, y = (i + 0.5) * pitch, (j + 0.5) * pitch
            away = ((x / width - 0.5) ** 2 + (y / height - 0.5) ** 2) ** 0.5
            half = 0.5 * (smallest + (largest - smallest) * ((3 * away) % 1))
            parts.append(strip(x - half, y - half, x + half, y + half, thickness))
    return Part.Compound(parts)


def microstrip_filter(length=80.0, width=40.0, thickness=1.5, line=3.0, stubs=(9.0, 12.0, 9.0), via=0.6):
    """A line through a board with open stubs on one side and stubs that end in vias to the ground on the other."""
    middle = width / 2
    parts = [Part.makeBox(length, width, thickness), strip(0, 0, length, width, 0),
             strip(0, middle - line / 2, length, middle + line / 2, thickness)]
    for i, reach in enumerate(stubs):
        x = length * (i + 1) / (len(stubs) + 1)
        parts.append(strip(x - 1, middle + line / 2, x + 1, middle + line / 2 + reach, thickness))
    for i in range(len(stubs) - 1):
        x = length * (i + 1.5) / (len(stubs) + 1)
        end = middle - line / 2 - 8
        parts.append(strip(x - 1.5, end, x + 1.5, middle - line / 2, thickness))
        parts.append(Part.makeCylinder(via, thickness, Vector(x, end + 1.8, 0)))
    return Part.Compound(parts)
