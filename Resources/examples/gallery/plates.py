"""Flat plates with holes, as single faces. Lengths in mm."""
import math

import Part
from FreeCAD import Vector


def polygon(points):
    """A closed wire through points (x, y) in the plane z = 0."""
    corners = [Vector(x, y, 0) for x, y in points]
    return Part.makePolygon(corners + corners[:1])


def rectangle(width, height):
    x, y = width / 2, height / 2
    return polygon([(-x, -y), (x, -y), (x, y), (-x, y)])


def circle(x, y, radius):
    return Part.Wire(Part.makeCircle(radius, Vector(x, y, 0)))


def plate(outline, holes):
    return Part.Face([outline] + holes, "Part::FaceMakerBullseye") if holes else Part.Face(outline)


def plate_triangular_hole(width=240, height=200, side=110):
    """A rectangular plate with an equilateral hole in its middle."""
    radius = side / math.sqrt(3)
    corners = [(radius * math.sin(a), radius * math.cos(a)) for a in (0, 2 * math.pi / 3, 4 * math.pi / 3)]
    return plate(rectangle(width, height), [polygon(corners)])


def plate_small_holes(width=300, height=200, large=22, small=4, tiny=0.8):
    """A plate whose holes have three very different radii; the tiny ones are far smaller than most target lengths."""
    holes = [circle(x, 0, large) for x in (-80, 80)]
    holes += [circle(x, y, small) for x in (-110, 0, 110) for y in (-65, 65)]
    holes += [circle(x, y, tiny) for x in (-40, 0, 40) for y in (-25, 25)]
    return plate(rectangle(width, height), holes)
