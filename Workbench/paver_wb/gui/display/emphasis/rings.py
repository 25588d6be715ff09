"""Rings around places of the model, of one size in the view: what they are about is found however small it is there."""
import numpy as np
from pivy import coin
from PySide import QtCore, QtGui

from paver_wb.gui.base.widgets import canvas
from paver_wb.gui.display.emphasis.on_screen import OnScreen
from paver_wb.gui.display.fields import node, put, separator
from paver_wb.gui.display.panels import image_node

DIAMETER, WIDTH, HALO = 36, 4, 8  # pixels
COLOUR, AROUND = (225, 0, 120), (255, 255, 255, 210)
MOST_RINGS, CELLS = 40, 12  # rings; cells of the model's extent that have one ring each where there would be more


class Rings(OnScreen):
    """Hidden by nothing. `places`: (rings, 3) points they are around."""

    def __init__(self):
        super().__init__()
        self.node = image_node(picture(), coin.SoImage.CENTER, coin.SoImage.HALF)
        self.places = np.zeros((0, 3))

    def show(self, places):
        places = spread(np.asarray(places, float).reshape(-1, 3))
        if np.array_equal(places, self.places):
            return  # Coin would draw another frame
        self.places = places
        self.content.removeAllChildren()
        for place in places:
            at = node(coin.SoTranslation, translation=tuple(float(x) for x in place))
            put(self.content, separator(at, self.node))


def spread(places):
    """Some of many places, so that all of them have one near."""
    if len(places) <= MOST_RINGS:
        return places
    low = places.min(axis=0)
    cell = max(float(np.ptp(places, axis=0).max()) / CELLS, 1e-300)
    _, first = np.unique(np.floor((places - low) / cell), axis=0, return_index=True)
    first = np.sort(first)
    return places[first[np.linspace(0, len(first) - 1, min(len(first), MOST_RINGS)).astype(int)]]


def picture():
    """QImage of a ring with a pale rim, to be seen on everything."""
    image, painter = canvas(DIAMETER + HALO, DIAMETER + HALO)
    inside = QtCore.QRectF(HALO / 2, HALO / 2, DIAMETER, DIAMETER)
    for colour, width in ((AROUND, HALO), (COLOUR, WIDTH)):
        painter.setPen(QtGui.QPen(QtGui.QColor(*colour), width))
        painter.drawEllipse(inside)
    painter.end()
    return image
