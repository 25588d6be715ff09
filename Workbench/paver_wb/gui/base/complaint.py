"""How an error is told to the user."""
import FreeCAD
import FreeCADGui
from PySide import QtCore, QtGui


def complain(text):
    """Shows an error in a box that does not block, and in the report view."""
    FreeCAD.Console.PrintError(text + "\n")
    box = QtGui.QMessageBox(QtGui.QMessageBox.Warning, "Paver", text, QtGui.QMessageBox.Ok,
                            FreeCADGui.getMainWindow())
    box.setObjectName("Paver_Complaint")
    box.setAttribute(QtCore.Qt.WA_DeleteOnClose)
    box.open()
