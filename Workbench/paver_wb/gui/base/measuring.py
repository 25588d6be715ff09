"""Dialogs that stay beside the window and show what is worked out on a thread: large meshes take a second to read and to
measure."""
import FreeCAD
import FreeCADGui
from PySide import QtCore, QtGui

from paver_wb import mesh_object
from paver_wb.gui.base.background import Latest
from paver_wb.gui.base.widgets import button, named

translate = FreeCAD.Qt.translate
BAR_HEIGHT = 14
_open = {}  # (class, names of document and mesh object): the dialog on screen


class MeasuringDialog(QtGui.QDialog):
    """Goes with its mesh object. Subclasses have build(), which puts the bar `busy` somewhere, refresh(), which calls measure(), and
    show_measured(result), show_fault(sentence). followed: properties of the mesh object that count."""

    followed, is_told = ("MeshFile",), False

    def __init__(self, obj, name, title):
        super().__init__(FreeCADGui.getMainWindow())
        self.obj, self.latest = obj, Latest(self.take, self.take_error)
        self.key = (type(self), obj.Document.Name, obj.Name)
        self.setObjectName(name)
        self.setAttribute(QtCore.Qt.WA_DeleteOnClose)
        self.setWindowTitle(title)
        self.busy = named(QtGui.QProgressBar(), "Measuring", translate(
            "Paver", "The mesh is being measured; the window can be used meanwhile"))
        self.busy.setRange(0, 0)
        self.busy.setTextVisible(False)
        self.busy.setFixedHeight(BAR_HEIGHT)
        self.busy.hide()
        self.finished.connect(self.leave)
        self.build()
        self.refresh()
        FreeCAD.addDocumentObserver(self)

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

    def slotDeletedDocument(self, document):
        if document.Name == self.key[1]:
            self.close()

    def close_button(self):
        made = button("Close", translate("Paver", "Close"), "", self.close)
        made.setDefault(True)
        return made

    def measure(self, work):
        """Calls work() on a thread; what was being worked out before is dropped."""
        self.latest.ask(lambda _cancel: work())
        self.busy.show()

    def leave(self, _result):
        FreeCAD.removeDocumentObserver(self)
        self.latest.drop()
        _open.pop(self.key, None)

    def take(self, result):
        self.busy.hide()
        self.show_measured(result)

    def take_error(self, error):
        self.busy.hide()
        self.show_fault(str(error) or type(error).__name__)


def is_open(kind, obj):
    return (kind, obj.Document.Name, obj.Name) in _open


def show(kind, obj):
    """Opens the dialog of a mesh object, or brings it up to date and to the front. ValueError when it is not meshed."""
    mesh_object.path_of(obj)
    key = (kind, obj.Document.Name, obj.Name)
    if key in _open:
        _open[key].refresh()
    else:
        _open[key] = kind(obj)
    _open[key].show()
    _open[key].raise_()
    return _open[key]
