"""Coin fields filled from NumPy arrays by one copy of memory, and small nodes."""
import ctypes
import weakref

import numpy as np
from pivy import coin

KINDS = {"SoMFVec3f": np.float32, "SoMFInt32": np.int32, "SoMFUInt32": np.uint32}


def fill(field, array):
    """Makes the field hold the numbers of `array`, converted to its own kind where they are of another."""
    kind = KINDS[type(field).__name__]
    array = np.ascontiguousarray(array, dtype=kind)
    count = len(array) if kind == np.float32 else array.size
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


def node(kind, **values):
    """A node of a class of Coin's with these values of its fields."""
    made = kind()
    for name, value in values.items():
        setattr(made, name, value)
    return made


def unpickable():
    return node(coin.SoPickStyle, style=coin.SoPickStyle.UNPICKABLE)


def unlit():
    return node(coin.SoLightModel, model=coin.SoLightModel.BASE_COLOR)


def colour_node(rgb):
    return node(coin.SoBaseColor, rgb=tuple(rgb[:3]))


def line_style(width, **more):
    return node(coin.SoDrawStyle, lineWidth=width, **more)


def own_indices(shape):
    """Indices of points that no two rows of (n, k) share, as Coin wants them."""
    return rows_as_indices(np.arange(shape[0] * shape[1]).reshape(shape[:2]))


def rows_as_indices(rows):
    """(n, k) rows of points as Coin wants them, each ended by -1."""
    made = np.full((len(rows), rows.shape[1] + 1), -1, np.int32)
    made[:, :-1] = rows
    return made.ravel()


def fill_rows(index_field, points_field, points, rows=None):
    """Fills the points of lines or faces and their indices: (n, k) rows of these; without them the points are (n, k, 3), those of
    each row its own. Coin never sees indices of points that are not there."""
    fill(index_field, np.zeros(0, np.int32))
    fill(points_field, points.reshape(-1, 3))
    fill(index_field, own_indices(points.shape) if rows is None else rows_as_indices(rows))
