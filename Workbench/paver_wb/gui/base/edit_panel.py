"""What task panels of objects share: how one is opened, and taken away with its object."""
import FreeCAD
import FreeCADGui
from PySide import QtCore, QtGui

from paver_wb import core

translate = FreeCAD.Qt.translate
_open = None  # the panel on screen
_new = None  # the object that the next panel is made for


class EditPanel:
    """What FreeCAD calls. Subclasses have `form`, accept() and reject(). is_new: the object was made for this panel."""

    buttons = QtGui.QDialogButtonBox.Ok | QtGui.QDialogButtonBox.Cancel

    def __init__(self, obj, is_new):
        self.obj, self.is_new, self.is_closed = obj, is_new, False
        self.document, self.document_name, self.steps = obj.Document, obj.Document.Name, obj.Document.UndoCount

    @staticmethod
    def without_core():
        """Called in place of opening it."""

    def shown(self):
        """Called when it is on screen."""

    def getStandardButtons(self):
        return getattr(self.buttons, "value", None) or int(self.buttons)

    def isAllowedAlterSelection(self):
        return True

    isAllowedAlterView = isAllowedAlterDocument = isAllowedAlterSelection

    def close(self):
        """Leaves FreeCAD's edit mode, which takes the panel away."""
        self.forget()
        FreeCADGui.getDocument(self.document_name).resetEdit()
        FreeCADGui.Control.closeDialog()

    def is_unused(self, own_steps=0):
        """Whether nothing was done to an object that was made for this panel but in `own_steps` steps of the panel's own."""
        return self.is_new and (not self.document.UndoMode or self.document.UndoCount == self.steps + own_steps)

    def take_back(self, own_steps=0):
        """Undoes the making of the object, and steps after that; deletes it where the document undoes nothing."""
        if self.document.UndoMode:
            for _ in range(1 + own_steps):
                self.document.undo()
            return
        for thing in (*self.obj.ViewObject.Proxy.own_children(), self.obj):
            self.document.removeObject(thing.Name)

    def forget(self):
        """Lets go of everything that calls back. False when that was done before."""
        global _open
        if self.is_closed:
            return False
        self.is_closed = True
        FreeCAD.removeDocumentObserver(self)
        if _open is self:
            _open = None
        return True

    def slotDeletedObject(self, obj):
        if obj == self.obj:
            self.vanish()

    def slotDeletedDocument(self, document):
        if document.Name == self.document_name:
            self.vanish()

    def widgets_gone(self, _widget=None):
        """FreeCAD has taken the panel away by itself, as scripts can ask it to."""
        try:
            self.forget()
        except RuntimeError:  # of what its parts are no more
            pass

    def vanish(self):
        """What it is about goes away."""
        self.forget()
        QtCore.QTimer.singleShot(0, lambda: FreeCADGui.Control.closeDialog())


def edit_new(obj):
    """Opens the panel of an object that was made for it: Cancel takes the object back.

    Opens it when the command that calls this has ended: FreeCAD would keep its step of undo open for the whole panel.
    """
    global _new
    _new, document, name = obj, obj.Document.Name, obj.Name

    def edit():
        if document in FreeCAD.listDocuments() and FreeCAD.getDocument(document).getObject(name):  # not closed or undone since
            FreeCADGui.getDocument(document).setEdit(name)
    QtCore.QTimer.singleShot(0, edit)


def set_edit(obj, kind):
    """What the view provider does when the object is to be edited, by a panel of the class `kind`."""
    global _open, _new
    is_new, _new = _new == obj, None
    fault = core.problem()
    if fault:
        FreeCAD.Console.PrintError(f"{obj.Label}: {fault}\n")
        kind.without_core()
        return False
    if FreeCADGui.Control.activeDialog():
        FreeCAD.Console.PrintError(f"{obj.Label}: " + translate("Paver", "Another task panel is open; close it first.") + "\n")
        return False
    _open = kind(obj, is_new)
    FreeCAD.addDocumentObserver(_open)
    FreeCADGui.Control.showDialog(_open)
    _open.form[0].destroyed.connect(_open.widgets_gone)
    _open.shown()
    return True


def unset_edit():
    """What it does at the end, whoever asked for that."""
    if _open is not None:
        _open.forget()
        FreeCADGui.Control.closeDialog()
