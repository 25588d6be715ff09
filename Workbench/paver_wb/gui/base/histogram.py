"""A histogram drawn with Qt."""
import numpy as np
from PySide import QtCore, QtGui

BAR, MARK = QtGui.QColor("#729fcf"), QtGui.QColor("#cc0000")
LEFT, RIGHT, TOP, BOTTOM = 44, 14, 26, 44  # room around the bars, pixels
TICKS = 4


def ticks(low, high):
    """About TICKS round numbers from low to high."""
    from math import ceil, floor, log10
    step = (high - low) / TICKS
    if not step > 0:
        return [low]
    base = 10 ** floor(log10(step))
    step = min((m * base for m in (1, 2, 5, 10)), key=lambda candidate: abs(candidate - step))
    return [step * k for k in range(ceil(low / step - 1e-9), floor(high / step + 1e-9) + 1)]


class Histogram(QtGui.QWidget):
    """Values as bars over an axis with its unit; a red line marks one of them. A tooltip tells each bar's share."""

    def __init__(self, name):
        super().__init__()
        self.setObjectName(name)
        self.setMinimumSize(240, 130)
        self.setSizePolicy(QtGui.QSizePolicy.Expanding, QtGui.QSizePolicy.Expanding)
        self.setMouseTracking(True)
        self.show_counts("", np.zeros(1, int), np.array([0.0, 1.0]), "")

    def show_counts(self, title, counts, limits, unit, mark=None):
        """limits: of the bars, one more than counts; unit: below the axis; mark: a value to show, or None."""
        self.title, self.unit, self.mark, self.counts, self.limits = title, unit, mark, counts, limits
        if mark is not None and not self.limits[0] <= mark <= self.limits[-1]:
            self.mark = None
        self.update()

    def area(self):
        return QtCore.QRectF(LEFT, TOP, max(1, self.width() - LEFT - RIGHT), max(1, self.height() - TOP - BOTTOM))

    def x_of(self, value):
        low, high, area = self.limits[0], self.limits[-1], self.area()
        return area.left() + (value - low) / (high - low) * area.width()

    def paintEvent(self, _event):
        painter = QtGui.QPainter(self)
        painter.setRenderHint(QtGui.QPainter.Antialiasing)
        painter.fillRect(self.rect(), self.palette().base())
        ink, area, most = self.palette().color(QtGui.QPalette.Text), self.area(), max(1, self.counts.max())
        bold = QtGui.QFont(self.font())
        bold.setBold(True)
        painter.setFont(bold)
        painter.setPen(ink)
        painter.drawText(QtCore.QRectF(LEFT, 4, area.width(), TOP - 6), QtCore.Qt.AlignLeft | QtCore.Qt.AlignVCenter,
                         self.title)
        painter.setFont(self.font())
        self.paint_counts(painter, area, most, ink)
        painter.setPen(QtCore.Qt.NoPen)
        painter.setBrush(BAR)
        for count, low, high in zip(self.counts, self.limits, self.limits[1:]):
            height = area.height() * float(count) / most
            if count:
                height = max(height, 1.0)
            painter.drawRect(QtCore.QRectF(self.x_of(low) + 0.5, area.bottom() - height,
                                           max(1.0, self.x_of(high) - self.x_of(low) - 1), height))
        self.paint_axis(painter, area, ink)
        if self.mark is not None:
            painter.setPen(QtGui.QPen(MARK, 2))
            painter.drawLine(QtCore.QPointF(self.x_of(self.mark), area.top()),
                             QtCore.QPointF(self.x_of(self.mark), area.bottom()))

    def paint_counts(self, painter, area, most, ink):
        faint = QtGui.QColor(ink)
        faint.setAlpha(50)
        for count in [int(t) for t in ticks(0, most) if t == int(t)]:
            y = area.bottom() - area.height() * count / most
            painter.setPen(faint)
            painter.drawLine(QtCore.QPointF(area.left(), y), QtCore.QPointF(area.right(), y))
            painter.setPen(ink)
            painter.drawText(QtCore.QRectF(0, y - 8, LEFT - 5, 16), QtCore.Qt.AlignRight | QtCore.Qt.AlignVCenter,
                             f"{count:.3g}" if count >= 100000 else str(count))

    def paint_axis(self, painter, area, ink):
        painter.setPen(ink)
        painter.drawLine(area.bottomLeft(), area.bottomRight())
        for value in ticks(self.limits[0], self.limits[-1]):
            x = self.x_of(value)
            painter.drawLine(QtCore.QPointF(x, area.bottom()), QtCore.QPointF(x, area.bottom() + 4))
            painter.drawText(QtCore.QRectF(x - 40, area.bottom() + 5, 80, 16), QtCore.Qt.AlignCenter, f"{value:.4g}")
        painter.drawText(QtCore.QRectF(area.left(), area.bottom() + 21, area.width(), 18), QtCore.Qt.AlignCenter,
                         self.unit)

    def mouseMoveEvent(self, event):
        for count, low, high in zip(self.counts, self.limits, self.limits[1:]):
            if self.x_of(low) <= event.pos().x() < self.x_of(high):
                share = 100 * float(count) / max(1, self.counts.sum())
                self.setToolTip(f"{low:.4g} \u2013 {high:.4g} {self.unit}: {count} ({share:.1f} %)")
                return
        self.setToolTip("")
