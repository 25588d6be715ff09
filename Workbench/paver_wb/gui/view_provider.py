"""How a mesh object looks in the tree and in the 3D view. Documents name this module and MeshViewProvider."""
import os

from paver_wb import refinement
from paver_wb.gui.paths import ICONS


class MeshViewProvider:
    """View provider of a mesh object. Nothing of it is stored but its name."""

    def __init__(self, vobj):
        vobj.Proxy = self
        self.attach(vobj)
        vobj.BackfaceCulling = False  # an open surface has two sides
        vobj.MaxFacesShowInner = 1  # FreeCAD's search for faces inside solids takes seconds, and a surface has none

    def getIcon(self):
        return os.path.join(ICONS, "Paver_CreateMesh.svg")

    def doubleClicked(self, vobj):
        vobj.Document.setEdit(vobj.Object.Name)
        return True

    def attach(self, vobj):
        self.Object = vobj.Object

    def claimChildren(self):
        return refinement.of_mesh(self.Object) if hasattr(self, "Object") else []

    def onDelete(self, vobj, subelements):
        """Deletes the refinements too, which are of no use without their mesh."""
        for child in refinement.of_mesh(vobj.Object):
            child.Document.removeObject(child.Name)
        return True

    def setEdit(self, vobj, mode=0):
        from paver_wb.gui import task_panel
        return task_panel.set_edit(vobj.Object) if mode == 0 else None

    def unsetEdit(self, vobj, mode=0):
        from paver_wb.gui import task_panel
        task_panel.unset_edit()

    def dumps(self):
        return None

    def loads(self, state):
        return None

    __getstate__ = dumps
    __setstate__ = loads
