"""Compares shapes again when an App::Part or a link around them is moved, which FreeCAD does not tell the mesh object."""
import FreeCAD

from paver_wb import core, mesh_object
from paver_wb.gui.base.background import Later

DELAY = 200  # ms: a part that is dragged moves many times
PLACES = ("Placement", "LinkPlacement")


def look(document):
    if document.Restoring or document.Transacting or document.Recomputing:
        looks.ask(document.Name)
    elif not core.problem():
        for obj in mesh_object.meshes_of(document):
            if obj.MeshFile:
                mesh_object.check(obj)


looks = Later(look, DELAY)


class Observer:
    """What FreeCAD calls."""

    def slotChangedObject(self, obj, name):
        if name in PLACES and not mesh_object.is_restoring(obj) and mesh_object.meshes_of(obj.Document):
            looks.ask(obj.Document.Name)

    def slotUndoDocument(self, document):
        if mesh_object.meshes_of(document):
            looks.ask(document.Name)

    slotRedoDocument = slotUndoDocument


FreeCAD.addDocumentObserver(Observer())
