"""The question before a mesh is exported that is not what its options and shapes ask for."""
import FreeCADGui
from PySide import QtGui

from paver_wb import mesh_object
from paver_wb.gui.base.widgets import named
from paver_wb.gui.commands.common import translate

EXPORT, MESH, CANCEL = "export", "mesh", "cancel"


def may_replace(path):
    """Whether a file that is there already may go. The dialog of files has not asked for it: it did not know the ending."""
    return QtGui.QMessageBox.question(FreeCADGui.getMainWindow(), translate("Paver", "Export mesh"), translate(
        "Paver", "{} is there already. Replace it?").format(path)) == QtGui.QMessageBox.Yes


def ask(obj, fault):
    """EXPORT, MESH or CANCEL. fault: a sentence on what is wrong. A mesh with holes would be the same once more."""
    is_old = mesh_object.state_of(obj) == mesh_object.OUT_OF_DATE
    box = QtGui.QMessageBox(QtGui.QMessageBox.Warning, translate("Paver", "Export mesh"), fault, QtGui.QMessageBox.NoButton,
                            FreeCADGui.getMainWindow())
    named(box, "ExportQuestion")
    made = {MESH: box.addButton(translate("Paver", "Mesh first"), QtGui.QMessageBox.AcceptRole)} if is_old else {}
    made[EXPORT] = box.addButton(translate("Paver", "Export the old mesh") if is_old else translate(
        "Paver", "Export with holes"), QtGui.QMessageBox.DestructiveRole)
    made[CANCEL] = box.addButton(QtGui.QMessageBox.Cancel)
    for name, button in made.items():
        named(button, "Export_" + name)
    box.setDefaultButton(made[MESH if is_old else CANCEL])
    box.exec_()
    chosen = box.clickedButton().objectName() if box.clickedButton() else ""
    box.deleteLater()
    return next((name for name in made if chosen == "Paver_Export_" + name), CANCEL)
