"""What the commands share."""
import FreeCAD
import FreeCADGui
from PySide import QtCore, QtGui

from paver_wb import core, mesh_object
from paver_wb.gui.base.steps import call_text, do, python_name  # noqa: F401, for the commands
from paver_wb.gui.base.widgets import complain
from paver_wb.gui.setup import first_use

QT_TRANSLATE_NOOP = FreeCAD.Qt.QT_TRANSLATE_NOOP
translate = FreeCAD.Qt.translate


def shown_as(name, text, tooltip, keys=""):
    """Command.resources; text and tooltip are marked for translation by the caller."""
    made = {"MenuText": text, "ToolTip": tooltip, "Pixmap": name}
    return {**made, "Accel": keys} if keys else made


class Command:
    """What FreeCAD calls; subclasses have `resources` and Activated()."""

    def GetResources(self):
        return self.resources

    def IsActive(self):
        return True


class OnMeshed(Command):
    """A command on the selected mesh object, or the document's only one, once it is meshed."""

    def IsActive(self):
        obj = target_mesh()
        return obj is not None and bool(obj.MeshFile)


def selected_meshes():
    return [thing for thing in FreeCADGui.Selection.getSelection() if mesh_object.is_mesh(thing)]


def target_mesh():
    """The mesh object a command is meant for: the first selected one, else the document's only one; or None."""
    meshes = selected_meshes()
    if not meshes and FreeCAD.ActiveDocument is not None:
        every = mesh_object.meshes_of(FreeCAD.ActiveDocument)
        meshes = every if len(every) == 1 else []
    return meshes[0] if meshes else None


def run(line, module=""):
    """do(); whether it went well. What goes wrong is told."""
    QtGui.QApplication.setOverrideCursor(QtCore.Qt.WaitCursor)  # large meshes take a second
    try:
        do(line, module)
    except Exception as error:
        tell(error)
        return False
    finally:
        QtGui.QApplication.restoreOverrideCursor()
    return True


def tell(error):
    """Shows an error; where the core is missing, how to get it."""
    if core.problem():
        FreeCAD.Console.PrintError(str(error) + "\n")
        first_use.show()
    else:
        complain(str(error))


def in_step(name, *lines, module=""):
    """run() of each as one step of undo; an error leaves no trace."""
    document = FreeCAD.ActiveDocument
    document.openTransaction(name)
    is_done = all(run(line, module) for line in lines)
    document.commitTransaction() if is_done else document.abortTransaction()
    return is_done
