"""Dialogs that stay beside the window, and those of them that show what is worked out on a thread: large meshes take a second
to read and to measure."""
import FreeCAD
import FreeCADGui
from PySide import QtCore, QtGui

from paver_wb import mesh_object
from paver_wb.gui.base.background import Latest
from paver_wb.gui.base.widgets import button, named, translate

BAR_HEIGHT = 14
_open = {}  # (class, names of document and object): the dialog on screen


class BesideDialog(QtGui.QDialog):
    """Goes with the document of its object."""

    def __init__(self, obj, name, title):
        super().__init__(FreeCADGui.getMainWindow())
        self.document, self.key = obj.Document.Name, (type(self), obj.Document.Name, obj.Name)
        named(self, name)
        self.setAttribute(QtCore.Qt.WA_DeleteOnClose)
        self.setWindowTitle(title)
        self.finished.connect(self.leave)

    def slotDeletedDocument(self, document):
        """FreeCAD calls it."""
        if document.Name == self.document:
            self.close()

    def leave(self, _result):
        FreeCAD.removeDocumentObserver(self)
        _open.pop(self.key, None)


class MeasuringDialog(BesideDialog):
    """Goes with its mesh object. Subclasses have build(), which puts the bar `busy` somewhere, refresh(), which calls measure(), and
    show_measured(result), show_fault(sentence). followed: properties of the mesh object that count."""

    followed, is_told = ("MeshFile",), False

    def __init__(self, obj, name, title):
        super().__init__(obj, name, title)
        self.obj, self.latest = obj, Latest(self.take, self.take_error)
        self.busy = named(QtGui.QProgressBar(minimum=0, maximum=0, textVisible=False), "Measuring", translate(
            "Paver", "The mesh is being measured; the window can be used meanwhile"))
        self.busy.setFixedHeight(BAR_HEIGHT)
        self.busy.hide()
        self.build()
        self.refresh()

    def slotChangedObject(self, obj, name):
        """FreeCAD calls it, like the next."""
        if obj == self.obj and name in self.followed and not self.is_told:
            self.is_told = True
            QtCore.QTimer.singleShot(0, self.refresh_later)

    def refresh_later(self):
        self.is_told = False
        try:
            self.refresh() if self.obj.MeshFile else self.close()
        except (ReferenceError, RuntimeError):  # gone meanwhile
            self.close()

    def slotDeletedObject(self, obj):
        if obj == self.obj:
            self.close()

    def close_button(self):
        made = button("Close", translate("Paver", "Close"), "", self.close)
        made.setDefault(True)
        return made

    def measure(self, work):
        """Calls work() on a thread; what was being worked out before is dropped."""
        self.latest.ask(lambda _cancel: work())
        self.busy.show()

    def leave(self, result):
        super().leave(result)
        self.latest.drop()

    def take(self, result):
        self.busy.hide()
        self.show_measured(result)

    def take_error(self, error):
        self.busy.hide()
        self.show_fault(str(error) or type(error).__name__)


def opened(kind, obj):
    """The dialog of an object that is on screen, or None."""
    return _open.get((kind, obj.Document.Name, obj.Name))


def front(dialog):
    """Brings a dialog to the front, which may be new, and gives it."""
    if dialog.key not in _open:
        _open[dialog.key] = dialog
        FreeCAD.addDocumentObserver(dialog)
    dialog.show()
    dialog.raise_()
    return dialog


def show(kind, obj):
    """Opens the dialog of a mesh object, or brings it up to date and to the front. ValueError when it is not meshed."""
    mesh_object.path_of(obj)
    dialog = opened(kind, obj)
    if dialog:
        dialog.refresh()
    return front(dialog or kind(obj))
