"""A satellite and an armoured vehicle. Lengths in mm."""
import Part
from FreeCAD import Vector


def dish(focal=400.0, radius=600.0, place=Vector(0, 0, 0)):
    """A sheet: the paraboloid about z whose vertex is at `place`."""
    curve = Part.BSplineCurve()
    steps = 12
    curve.interpolate([Vector(radius * k / steps, 0, (radius * k / steps) ** 2 / (4 * focal)) for k in range(steps + 1)],
                      InitialTangent=Vector(1, 0, 0), FinalTangent=Vector(1, 0, radius / (2 * focal)))
    sheet = curve.toShape().revolve(Vector(0, 0, 0), Vector(0, 0, 1), 360)
    sheet.translate(place)
    return sheet


def satellite(width=1200.0, height=1500.0, panel=2600.0):
    """A body with two panels on booms, a dish on its mast and a feed before it: sheets and solids that touch."""
    half = width / 2
    parts = [Part.makeBox(width, width, height, Vector(-half, -half, -height))]
    boom, gap = 40.0, 700.0
    for sign in (1, -1):
        parts.append(Part.makeCylinder(boom, gap, Vector(0, sign * half, -height / 2), Vector(0, sign, 0)))
        y = half + gap if sign > 0 else -half - gap - panel
        parts.append(Part.makePlane(width, panel, Vector(-half, y, -height / 2)))
    mast = 300.0
    parts += [Part.makeCylinder(60, mast, Vector(0, 0, 0)), dish(place=Vector(0, 0, mast)),
              Part.makeCylinder(25, 360, Vector(0, 0, mast)), Part.makeCone(25, 90, 120, Vector(0, 0, mast + 360))]
    return Part.Compound(parts)


def prism(corners, width):
    """The solid over a polygon (x, z), `width` wide about the plane y = 0."""
    points = [Vector(x, -width / 2, z) for x, z in corners]
    return Part.Face(Part.makePolygon(points + points[:1])).extrude(Vector(0, width, 0))


def frustum(low, high, z0, z1):
    """A solid between two rectangles (x0, x1, half width) at heights z0 and z1."""
    wires = []
    for (x0, x1, half), z in ((low, z0), (high, z1)):
        corners = [Vector(x0, -half, z), Vector(x1, -half, z), Vector(x1, half, z), Vector(x0, half, z)]
        wires.append(Part.makePolygon(corners + corners[:1]))
    return Part.makeLoft(wires, True, True)


def armoured_vehicle():
    """A wedge-shaped hull on eight wheels with a turret and its gun; the parts run into each other."""
    hull = prism([(0, 1100), (900, 550), (6300, 550), (6900, 1100), (6700, 1900), (2100, 1900)], 2600)
    turret = frustum((2900, 5300, 1050), (3300, 5000, 750), 1850, 2550)
    gun = Part.makeCylinder(70, 3300, Vector(3400, 0, 2200), Vector(-1, 0, 0.02))
    wheels = [Part.makeCylinder(560, 420, Vector(x, y, 560), Vector(0, 1, 0))
              for x in (1250, 2650, 4300, 5700) for y in (-1500, 1080)]
    hatch = Part.makeCylinder(300, 120, Vector(4500, 350, 2520))
    return Part.Compound([hull, turret, gun, hatch] + wheels)
