"""How a mesh object looks in the tree and in the 3D view. Documents name this module and MeshViewProvider."""
import os

from paver_wb import mesh_object, refinement
from paver_wb.base.paths import ICONS
from paver_wb.base.proxies import is_mesh
from paver_wb.children import named_parts
from paver_wb.gui.base.view import ViewProvider

FIRST = {"BackfaceCulling": False,  # an open surface has two sides
         "MaxFacesShowInner": 1,  # FreeCAD's search for faces inside solids takes seconds, and a surface has none
         "SelectionStyle": "BoundBox"}  # FreeCAD would paint over colours that tell something
STATE_ICONS = {mesh_object.NOT_MESHED: "Paver_StateNotMeshed.svg", mesh_object.UP_TO_DATE: "Paver_StateUpToDate.svg",
               mesh_object.OUT_OF_DATE: "Paver_StateOutOfDate.svg",
               mesh_object.FACES_FAILED: "Paver_StateFacesFailed.svg"}
OF_STATE = ("Status", "FailedFaces")  # properties


class MeshViewProvider(ViewProvider):
    icon, panel = "Paver_CreateMesh.svg", ("paver_wb.gui.task_panel", "TaskPanel")

    def __init__(self, vobj):
        super().__init__(vobj)
        self.attach(vobj)
        for name, value in FIRST.items():
            if name in vobj.PropertiesList:  # of this version of FreeCAD
                setattr(vobj, name, value)
        self.add_modes(vobj)
        vobj.Visibility = True  # FreeCAD hides what was made without a window

    def attach(self, vobj):
        """Called by FreeCAD with a new object and when a document is opened, but not where a document was saved without
        a window."""
        from paver_wb.gui.display import selection, view_properties  # noqa: F401, selection starts to follow FreeCAD's
        from paver_wb.gui.display.mesh_display import MeshDisplay
        self.Object = vobj.Object
        if getattr(self, "display", None) is None:
            view_properties.add_to(vobj)
            self.display = MeshDisplay(vobj)
            self.display.attach(vobj)

    def look_later(self):
        """After opening a file that keeps no view."""
        from paver_wb.gui.base import first_view
        first_view.look_later(self.Object.Document)

    def add_modes(self, vobj):
        from paver_wb.gui.display.mesh_display import CURVED_EDGES
        if CURVED_EDGES not in vobj.getEnumerationsOfProperty("DisplayMode"):
            vobj.DisplayMode = vobj.listDisplayModes()
        vobj.DisplayMode = CURVED_EDGES

    def getDisplayModes(self, vobj):
        from paver_wb.gui.display.mesh_display import MODES
        return list(MODES)

    def getDefaultDisplayMode(self):
        from paver_wb.gui.display.mesh_display import CURVED_EDGES
        return CURVED_EDGES

    def setDisplayMode(self, mode):
        return mode

    def getIcon(self):
        """Tells the state of the mesh."""
        obj = getattr(self, "Object", None)
        is_known = obj is not None and "FailedFaces" in obj.PropertiesList
        return os.path.join(ICONS, STATE_ICONS[mesh_object.state_of(obj)] if is_known else self.icon)

    def updateData(self, obj, name):
        if name in OF_STATE and getattr(self, "Object", None) is not None and "FailedFaces" in obj.PropertiesList:
            obj.ViewObject.signalChangeIcon()
        if getattr(self, "display", None) and name == "Status":
            self.display.status_changed()
        elif getattr(self, "display", None) and obj.Status == mesh_object.OUT_OF_DATE:
            self.display.reason_changed()
        if name == "MeshFile" and getattr(self, "display", None):
            from paver_wb.gui.display.mesh_display import MESH
            self.display.changed(MESH)

    def onChanged(self, vobj, name):
        if getattr(self, "display", None):
            self.display.property_changed(name)

    def getElementPicked(self, picked):
        return self.display.picker.element_picked(picked)

    def claimChildren(self):
        return [*named_parts.of_mesh(self.Object), *refinement.of_mesh(self.Object)] if hasattr(self, "Object") else []

    def own_children(self):
        """Those that no other mesh has: a copy may have the children of its original."""
        return [child for child in self.claimChildren()
                if not any(is_mesh(other) and other != self.Object for other in child.InList)]
