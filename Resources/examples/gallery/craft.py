"""Things that fly: bodies and lofted wings, as solids that run into each other. Nose at x = 0, z up, lengths in mm."""
import math

import Part
from FreeCAD import Placement, Rotation, Vector

import bodies


def section(chord, thickness, place, end=0.004):
    """The outline of a symmetric profile (NACA four digits) with an end of finite thickness."""
    shares = [(1 - k / 16) ** 2 for k in range(17)]  # denser at the nose

    def half(s):
        return 5 * thickness * (0.2969 * s**0.5 - 0.126 * s - 0.3516 * s**2 + 0.2843 * s**3 - 0.1036 * s**4) + end / 2 * s

    def edge(points):
        curve = Part.BSplineCurve()
        curve.interpolate([Vector(chord * s, 0, chord * z) + place for s, z in points])
        return curve.toShape()

    upper = edge([(s, half(s)) for s in shares])
    lower = edge([(s, -half(s)) for s in reversed(shares)])
    back = Part.makeLine(lower.Vertexes[-1].Point, upper.Vertexes[0].Point)
    return Part.Wire([upper, lower, back])


def wing(root, tip, thickness, span, sweep, rise=0.0):
    """A solid between two profiles: chords at root and tip, how far the tip lies outwards (y), behind (x), above (z)."""
    sections = [section(root, thickness, Vector(0, 0, 0)), section(tip, thickness, Vector(sweep, span, rise))]
    return Part.makeLoft(sections, True, True)


def placed(shape, x=0.0, y=0.0, z=0.0, roll=0.0):
    """The shape turned about the x axis (degrees) and moved."""
    copy = shape.copy()
    copy.Placement = Placement(Vector(x, y, z), Rotation(Vector(1, 0, 0), roll))
    return copy


def mirrored(shape):
    return shape.mirror(Vector(0, 0, 0), Vector(0, 1, 0))


def fuselage(nose, middle, tail, radius, end):
    """A body of revolution about x: half an ellipsoid, a cylinder, and a tail that narrows to a flat end. The lengths of
    the three, the largest radius, that of the end."""
    back, far = nose + middle, nose + middle + tail
    ellipse = Part.Ellipse(Vector(0, 0, 0), Vector(nose, radius, 0), Vector(nose, 0, 0))
    quarter = Part.Arc(ellipse, 0, math.pi / 2).toShape()
    curve = Part.BezierCurve()
    curve.setPoles([Vector(back, radius, 0), Vector(back + 0.45 * tail, radius, 0), Vector(far, end, 0)])
    return bodies.revolved([quarter, bodies.line((nose, radius), (back, radius)), curve.toShape(),
                            bodies.line((far, end), (far, 0))])


def engine(length=3200.0, radius=900.0, wall=90.0, depth=0.5):
    """A nacelle with an inlet that ends at a wall inside."""
    lip = wall / 2
    points = [(depth * length, 0), (depth * length, radius - wall), (0, radius - wall)]
    return bodies.revolved([bodies.line(points[0], points[1]), bodies.line(points[1], points[2]),
                            bodies.arc(points[2], (-lip, radius - lip), (0, radius)),
                            bodies.line((0, radius), (length, 0.85 * radius)), bodies.line((length, 0.85 * radius), (length, 0))])


def airplane():
    """An airliner: fuselage of 33 m, wings, tail, two engines on pylons."""
    body = fuselage(4500, 17000, 11500, 1975, 250)
    parts = [body, placed(wing(3600, 1500, 0.09, 5800, 3600), 29000, 0, 1000, 90)]
    half_wing = wing(6800, 1700, 0.11, 16500, 7600, 1200)
    half_tail = wing(3000, 1200, 0.09, 6200, 2600, 500)
    nacelle, pylon = engine(), Part.makeBox(2600, 160, 1500)
    for side in (placed(half_wing, 11000, 0, -900), placed(half_tail, 29500, 0, 500), placed(nacelle, 10600, 5600, -1900),
                 placed(pylon, 11400, 5520, -1500)):
        parts += [side, mirrored(side)]
    return Part.Compound(parts)


def drone():
    """A slender drone with long straight wings, an inverted V for a tail and an inlet on its back."""
    body = fuselage(1300, 1800, 5000, 480, 150)
    inlet = placed(engine(1500, 170, 25, 0.5), 5200, 0, 420)
    parts = [body, inlet, Part.makeCylinder(40, 420, Vector(1000, 0, -700))]
    half_wing, half_tail = wing(1050, 620, 0.12, 7400, 260, 180), wing(700, 480, 0.1, 1900, 260)
    for side in (placed(half_wing, 3400, 0, 60), placed(half_tail, 7000, 60, 0, -35)):
        parts += [side, mirrored(side)]
    return Part.Compound(parts)
