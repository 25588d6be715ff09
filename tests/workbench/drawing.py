"""What is in the 3D view, for the cases that look at it. Imported in FreeCAD, with its Python."""
import ctypes

import numpy as np

from paver_wb.gui.display import colouring, legend


def content(field, kind, columns=1):
    """A copy of what a field holds."""
    count = field.getNum() * columns
    if not count:
        return np.zeros((0, columns) if columns > 1 else 0, kind)
    pointer = field.startEditing()
    address = int(getattr(pointer, "this", pointer))
    made = np.frombuffer(ctypes.string_at(address, count * np.dtype(kind).itemsize), kind)
    field.finishEditing()
    return made.reshape(-1, columns) if columns > 1 else made


def labels(bar):
    """All texts of a colour bar, from top to bottom."""
    if isinstance(bar, colouring.Scale):
        return legend.heading(bar) + [text for _, text in reversed(legend.ticks(bar))] + legend.summary(bar)
    return [bar.title] + [text for row in legend.key_rows(bar) for text in row[:2]]
