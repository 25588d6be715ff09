"""Coin fields filled from NumPy arrays by one copy of memory, and small nodes."""
import ctypes
import weakref

import numpy as np
from pivy import coin

FLOATS, INTEGERS, COLOURS = np.float32, np.int32, np.uint32


def fill(field, array, kind):
    """Makes the field hold the numbers of `array`, converted to `kind` where they are of another."""
    array = np.ascontiguousarray(array, dtype=kind)
    vectors = kind == FLOATS
    count = len(array) if vectors else array.size
    field.setNum(count)
    if count:
        pointer = field.startEditing()
        ctypes.memmove(int(getattr(pointer, "this", pointer)), array.ctypes.data, array.nbytes)
    field.finishEditing() if count else field.touch()


def put(group, *nodes):
    """Adds nodes to a group; gives the group."""
    for node in nodes:
        group.addChild(node)
    return group


def separator(*nodes):
    return put(coin.SoSeparator(), *nodes)


def callback(owner):
    """A node by which each action that comes past has owner.called(action) called."""
    node, me = coin.SoCallback(), weakref.ref(owner)  # Coin never lets go of what it is to call
    node.setCallback(lambda _, action: me() and me().called(action), None)
    return node


def unpickable():
    style = coin.SoPickStyle()
    style.style = coin.SoPickStyle.UNPICKABLE
    return style


def unlit():
    model = coin.SoLightModel()
    model.model = coin.SoLightModel.BASE_COLOR
    return model


def colour_node(rgb):
    node = coin.SoBaseColor()
    node.rgb = tuple(rgb[:3])
    return node


def line_style(width, point_size=0):
    style = coin.SoDrawStyle()
    style.lineWidth = width
    if point_size:
        style.pointSize = point_size
    return style
