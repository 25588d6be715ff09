"""The cone-sphere with slot [Woo93] at 869 MHz: cross-sections over 181 angles against 3,900 unknowns."""
import os

import meshes
from series import body

BODY = body.Body(os.path.join(meshes.SHARED, "tips", "conesphere_slot_20faces.step"), 869e6, body.around(181), 23,
                 (500, 1000, 2000), 3900, 3600, tip=(-605.05, 0, 0))


def compute(stored):
    return body.compare(stored, BODY)


def draw(found, folder):
    body.draw(found, BODY, folder, "conesphere", "angle from the sphere's end")


def tables(found):
    return {"conesphere": body.table(found)}
