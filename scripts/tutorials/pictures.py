"""Pictures of FreeCAD's window, with marks around what was clicked. Runs in FreeCAD."""
import os

from PySide import QtCore, QtGui

import window

MARK, TITLE = QtGui.QColor(235, 85, 0), QtGui.QColor(70, 80, 95)
AROUND, RADIUS = 3, 9  # pixels: of a mark around a widget, of one at a place of the 3D view
BAR = 24  # pixels: a dialog's title, which window managers draw and a bare screen has not


def frame_of(widget):
    return QtCore.QRect(widget.mapToGlobal(QtCore.QPoint(0, 0)), widget.size())


def seen_of(widget):
    """The frame of what is seen of a widget; None where it is scrolled away."""
    region = widget.visibleRegion()
    return None if region.isEmpty() else region.boundingRect().translated(widget.mapToGlobal(QtCore.QPoint(0, 0)))


def is_covered(rect):
    """Whether a dialog lies over a place of the window."""
    return any(dialog.isWindow() and dialog.frameGeometry().intersects(rect) for dialog in window.widgets(QtGui.QDialog))


class Pictures:
    """folder: where they are kept. `marks`: what gives the frame of one when the picture is taken, or None."""

    def __init__(self, folder):
        self.folder, self.marks, self.held = folder, [], None

    def mark(self, widget):
        """It is looked for again: panels scroll, and dialogs go."""
        name, kind, text, over = widget.objectName(), type(widget), text_of(widget), is_covered(frame_of(widget))

        def frame():
            found = next((seen_of(found) for found in window.widgets(kind, name or None) if name or text_of(found) == text), None)
            return found if found is not None and (over or not is_covered(found)) else None
        self.marks.append(frame)

    def mark_if(self, frame):
        """frame(): a rectangle, or None where there is none any longer."""
        self.marks.append(frame)

    def mark_place(self, point):
        self.marks.append(lambda: point)

    def mark_tool(self, command):
        """The button of a command in the toolbars."""
        def frame():
            for button in window.widgets(QtGui.QToolButton):
                action = button.defaultAction()
                if action is not None and action.objectName() == command and not is_covered(frame_of(button)):
                    return frame_of(button)
            return None
        self.marks.append(frame)

    def take(self, number):
        """The file name of a step's picture: the one that is held, else one of now."""
        name = self.held or self.hold(number)
        self.held, self.marks = None, []
        return name

    def hold(self, number):
        """Takes a step's picture before the step is done, where there is none yet."""
        if self.held:
            return self.held
        make_room_for_titles()
        image = QtGui.QApplication.primaryScreen().grabWindow(0)
        painter = QtGui.QPainter(image)
        painter.setRenderHint(QtGui.QPainter.Antialiasing)
        draw_titles(painter)
        self.draw_marks(painter)
        painter.end()
        self.held = f"{number:02d}.png"
        image.save(os.path.join(self.folder, self.held))
        return self.held

    def draw_marks(self, painter):
        painter.setPen(QtGui.QPen(MARK, 2.5))
        painter.setBrush(QtCore.Qt.NoBrush)
        for mark in self.marks:
            place = mark()
            if isinstance(place, QtCore.QPoint):
                painter.drawEllipse(place, RADIUS, RADIUS)
            elif place is not None:
                painter.drawRoundedRect(place.adjusted(-AROUND, -AROUND, AROUND, AROUND), 4, 4)


def text_of(widget):
    return widget.text() if hasattr(widget, "text") else ""


def make_room_for_titles():
    """A window manager would."""
    for dialog in window.widgets(QtGui.QDialog):
        if dialog.isWindow() and dialog.y() < BAR:
            dialog.move(dialog.x(), BAR)
            window.pause(200)


def draw_titles(painter):
    """What a window manager draws about dialogs."""
    for dialog in window.widgets(QtGui.QDialog):
        if not dialog.isWindow():
            continue
        frame = dialog.frameGeometry()
        bar = QtCore.QRect(frame.left(), frame.top() - BAR, frame.width(), BAR)
        painter.setPen(QtGui.QPen(TITLE, 2))
        painter.setBrush(QtCore.Qt.NoBrush)
        painter.drawRect(bar.united(frame))
        painter.fillRect(bar, TITLE)
        painter.setPen(QtCore.Qt.white)
        painter.drawText(bar, QtCore.Qt.AlignCenter, dialog.windowTitle())
