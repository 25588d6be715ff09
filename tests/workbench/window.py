"""Cases that run inside FreeCAD's window: waiting, clicking, pictures. Imported in FreeCAD, with its Python."""
import importlib
import os
import time

import FreeCADGui
from PySide import QtCore, QtGui

LIMIT = 120  # seconds
BINDING = QtCore.QObject.__module__.split(".")[0]  # PySide2 or PySide6: what FreeCAD's own PySide stands for
QTest = importlib.import_module(BINDING + ".QtTest").QTest  # FreeCAD's PySide has none


def pause(milliseconds):
    """Lets the window work for a while."""
    loop = QtCore.QEventLoop()
    QtCore.QTimer.singleShot(milliseconds, loop.quit)
    loop.exec_()


def wait(is_done, what=""):
    """Lets the window work until is_done()."""
    end = time.monotonic() + LIMIT
    while not is_done():
        if time.monotonic() > end:
            raise AssertionError(f"waited {LIMIT} s in vain {what}")
        pause(10)


def all_widgets(kind, name=None):
    """Those of a kind. Not by findChildren: what that gives stays known to Python after Qt has deleted it, and ends the
    program where something else comes to lie at its place."""
    return [w for w in QtGui.QApplication.allWidgets() if isinstance(w, kind) and name in (None, w.objectName())]


def widgets(kind, name=None):
    """Visible widgets of a kind."""
    return [w for w in all_widgets(kind, name) if w.isVisible()]


def clear():
    """Hides what FreeCAD 1.0 has over its window while it runs tests, and what keeps the mouse from it."""
    for dialog in widgets(QtGui.QDialog):
        if dialog.metaObject().className() == "TestGui::UnitTestDialog":
            dialog.hide()


def widget(name, kind=QtGui.QWidget):
    """The visible widget of that object name, or None."""
    return next(iter(widgets(kind, name)), None)


def dock(*names):
    """The dock of the first name that FreeCAD's window has, shown: a new user's window may hide it."""
    docks = {d.objectName(): d for d in all_widgets(QtGui.QDockWidget)}
    found = next(docks[name] for name in names if name in docks)
    found.show()
    return found


def task_dock():
    """That of task panels; FreeCAD 0.20 has one for them and the tree."""
    return dock("Combo View", "Tasks")


def tree_dock():
    """That of the tree and the property editor."""
    return dock("Combo View", "Model")


def click(button):
    """Clicks at the left, where a radio button has its circle."""
    if button is None or not button.isEnabled():
        raise AssertionError("the button is not there" if button is None else f"{button.text()} is disabled")
    QTest.mouseClick(button, QtCore.Qt.LeftButton, QtCore.Qt.NoModifier, QtCore.QPoint(8, button.height() // 2))


def double_click(thing):
    """Double click on an object of a document, in the tree."""
    tree_dock()
    for tree in widgets(QtGui.QTreeWidget):
        for item in tree.findItems(thing.Label, QtCore.Qt.MatchExactly | QtCore.Qt.MatchRecursive):
            tree.scrollToItem(item)
            pause(50)
            middle = tree.visualItemRect(item).center()
            QTest.mouseClick(tree.viewport(), QtCore.Qt.LeftButton, QtCore.Qt.NoModifier, middle)
            QTest.mouseDClick(tree.viewport(), QtCore.Qt.LeftButton, QtCore.Qt.NoModifier, middle)
            return
    raise AssertionError(f"{thing.Label} is in no tree that is seen")


def standard_button(which):
    """That of the task panel, a QDialogButtonBox.StandardButton; None where no panel is."""
    # Not what box.button() gives: Python forgets it, or even deletes it, with the box.
    texts = [box.button(which).text() for box in widgets(QtGui.QDialogButtonBox) if box.button(which)]
    return next((button for button in widgets(QtGui.QPushButton) if button.text() in texts), None)


def viewport():
    """The widget that shows the 3D view. Not by the view's viewport(), which Python would delete with the view."""
    return widgets(QtGui.QOpenGLWidget)[0]


def click_standard(which):
    """Clicks a button of the task panel."""
    wait(lambda: standard_button(which), "for the panel's buttons")  # which FreeCAD 1.0 shows a little later
    standard_button(which).click()
    pause(50)


def type_into(field, text):
    """Replaces the text of a field, as from the keyboard."""
    field.setFocus()
    field.selectAll()
    QTest.keyClicks(field, text)
    QTest.keyClick(field, QtCore.Qt.Key_Return)


def picture(name):
    """Keeps a picture of the screen in the build folder."""
    folder = os.path.join(os.environ.get("PAVER_BUILD") or os.getcwd(), "pictures", "panel")
    os.makedirs(folder, exist_ok=True)
    pause(100)
    QtGui.QApplication.primaryScreen().grabWindow(0).save(os.path.join(folder, name + ".png"))
