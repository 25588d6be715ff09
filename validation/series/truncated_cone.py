"""A cone-sphere with its tip cut off, at 10 GHz: cross-sections over 91 angles against 3,800 unknowns.

The gallery's model at a third of its size: half angle 12 degrees, sphere of radius 20 mm, end of radius 4 mm.
"""
import os

from series import body

SCALE = 1 / 3
BODY = body.Body(os.path.join(body.meshes.EXAMPLES, "gallery", "truncated_cone_sphere.step"), 10e9, body.around(91), 12,
                 (600, 1200, 2000), 3800, 3600, scale=SCALE)


def compute(stored):
    return body.compare(stored, BODY)


def draw(found, folder):
    body.draw(found, BODY, folder, "truncated_cone", "angle from the sphere's end")


def tables(found):
    return {"truncated cone": body.table(found)}
