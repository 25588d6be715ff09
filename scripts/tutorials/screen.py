"""FreeCAD's window as a page shows it: of one size, Paver's workbench chosen, without what the steps do not need. Runs in FreeCAD."""
import warnings

import FreeCAD
import FreeCADGui
from PySide import QtGui

import window

HIDDEN_DOCKS = ("Report view", "Python console", "Selection view")
TOOLBARS = ("File", "Workbench", "Paver", "Paver view")
START = 600  # ms
BACKGROUND = 0xe6ebf4ff  # one colour: shades of it would take half of a picture's colours


def make_plain():
    """Gives 3D views one colour."""
    view = FreeCAD.ParamGet("User parameter:BaseApp/Preferences/View")
    view.SetBool("Gradient", False)
    view.SetBool("RadialGradient", False)
    view.SetBool("Simple", True)
    view.SetUnsigned("BackgroundColor", BACKGROUND)


def prepare(width, height):
    warnings.filterwarnings("ignore", "Paver's compiled module is older")  # which is no matter of the pages
    make_plain()
    main = FreeCADGui.getMainWindow()
    FreeCADGui.activateWorkbench("PaverWorkbench")
    window.pause(START)
    for dock in window.all_widgets(QtGui.QDockWidget):
        if dock.objectName() in HIDDEN_DOCKS:
            dock.hide()
    window.tree_dock()
    for bar in window.all_widgets(QtGui.QToolBar):
        if bar.objectName() and bar.objectName() not in TOOLBARS and bar.window() == main:
            bar.hide()
    main.statusBar().show()
    main.showNormal()
    main.setGeometry(0, 0, width, height)
    window.pause(START)
