"""Bodies that radar cross-sections are computed of: those of revolution with their axis along x. Lengths in mm, angles in
degrees."""
import math

import Part
from FreeCAD import Vector


def revolved(edges):
    """The solid that a chain of edges in the half plane z = 0, y >= 0 sweeps about the x axis."""
    shell = Part.Shell(Part.Wire(edges).revolve(Vector(0, 0, 0), Vector(1, 0, 0), 360).Faces)
    return Part.makeSolid(shell)


def pyramid_on_block(width=100.0, block=40.0, height=80.0):
    """A pyramid that stands on a block as wide as its base: nine faces as one solid."""
    half = width / 2
    low, base = ([Vector(x * half, y * half, z) for x, y in ((-1, -1), (1, -1), (1, 1), (-1, 1))] for z in (-block, 0))
    tip = Vector(0, 0, height)
    faces = [low[::-1]] + [[low[i], low[i - 3], base[i - 3], base[i]] for i in range(4)]
    faces += [[base[i], base[i - 3], tip] for i in range(4)]
    return Part.makeSolid(Part.makeShell([Part.Face(Part.makePolygon(points + points[:1])) for points in faces]))


def line(a, b):
    return Part.makeLine(Vector(*a, 0), Vector(*b, 0))


def arc(a, through, b):
    return Part.Arc(Vector(*a, 0), Vector(*through, 0), Vector(*b, 0)).toShape()


def half_sphere(half_angle, radius):
    """(place where the cone touches the sphere about the origin, place on the way, far end of the axis)."""
    turn = math.radians(90 - half_angle)
    touch = (-radius * math.cos(turn), radius * math.sin(turn))
    return touch, (radius * math.cos(math.radians(60)), radius * math.sin(math.radians(60))), (radius, 0)


def truncated_cone_sphere(half_angle=12.0, radius=60.0, end=12.0):
    """A cone that a sphere ends smoothly; at the other end it is cut off where its radius is `end`."""
    touch, through, far = half_sphere(half_angle, radius)
    cut = touch[0] - (touch[1] - end) / math.tan(math.radians(half_angle))
    return revolved([line((cut, 0), (cut, end)), line((cut, end), touch), arc(touch, through, far)])


def conesphere_slot(half_angle=7.0, radius=74.85, slot=6.35):
    """A cone-sphere with a square groove round it where cone and sphere meet. Dimensions of the benchmark target that
    was measured for the Electromagnetic Code Consortium (Woo et al., IEEE Antennas and Propagation Magazine 35, 1993)."""
    touch, through, far = half_sphere(half_angle, radius)
    tip = (touch[0] - touch[1] / math.tan(math.radians(half_angle)), 0)
    begin = math.asin(slot / radius)
    rim = (radius * math.sin(begin), radius * math.cos(begin))
    front, back = (touch[0], touch[1] - slot), (rim[0], touch[1] - slot)
    return revolved([line(tip, touch), line(touch, front), line(front, back), line(back, rim), arc(rim, through, far)])
