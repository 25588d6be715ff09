"""Compares shapes again when an App::Part or a link around them is moved, which FreeCAD does not tell the mesh object."""
import FreeCAD
from PySide import QtCore

from paver_wb import core, mesh_object

DELAY = 200  # ms: a part that is dragged moves many times
PLACES = ("Placement", "LinkPlacement")
_waiting = set()  # names of documents


def look():
    names = set(_waiting)
    _waiting.clear()
    if core.problem():
        return
    for name in names & set(FreeCAD.listDocuments()):
        document = FreeCAD.getDocument(name)
        if document.Restoring or document.Transacting or document.Recomputing:
            look_later(document)
            continue
        for obj in mesh_object.meshes_of(document):
            if obj.MeshFile:
                mesh_object.check(obj)


def look_later(document):
    if not _waiting:
        QtCore.QTimer.singleShot(DELAY, look)
    _waiting.add(document.Name)


class Observer:
    """What FreeCAD calls."""

    def slotChangedObject(self, obj, name):
        if name in PLACES and not mesh_object.is_restoring(obj) and mesh_object.meshes_of(obj.Document):
            look_later(obj.Document)

    def slotUndoDocument(self, document):
        if mesh_object.meshes_of(document):
            look_later(document)

    slotRedoDocument = slotUndoDocument


FreeCAD.addDocumentObserver(Observer())
