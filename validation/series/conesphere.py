"""The cone-sphere with slot [Woo93] at 869 MHz: cross-sections over 181 angles against 3,900 unknowns."""
import os

import numpy as np

import meshes
import pictures
from series import body

BODY = body.Body(os.path.join(meshes.SHARED, "tips", "conesphere_slot_20faces.step"), 869e6, body.around(181), 23,
                 (500, 1000, 2000), 3900, 3600, tip=(-605.05, 0, 0))
DEGREES = np.linspace(0, 180, 181)


def compute(stored):
    return body.compare(stored, BODY)


def draw(found, folder):
    figure, (left, middle, right) = pictures.axes(3)
    body.draw_differences(left, found, BODY)
    left.legend()
    body.draw_both(middle, right, DEGREES, found, 0, "angle from the sphere's end")
    pictures.save(figure, folder, "conesphere")


def tables(found):
    return {"conesphere": "\n".join([body.TABLE_HEAD, *body.rows(found, 1), body.check_row(found)])}
