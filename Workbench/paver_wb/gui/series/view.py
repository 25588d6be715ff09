"""How a series looks in the tree. Documents name this module and SeriesViewProvider."""
from paver_wb.gui.base.view import ViewProvider


class SeriesViewProvider(ViewProvider):
    icon = "Paver_Series.svg"

    def attach(self, vobj):
        self.Object = vobj.Object

    def __init__(self, vobj):
        super().__init__(vobj)
        self.attach(vobj)

    def claimChildren(self):
        return list(self.Object.Meshes) if hasattr(self, "Object") and "Meshes" in self.Object.PropertiesList else []

    def doubleClicked(self, vobj):
        from paver_wb.gui.series import panel
        panel.show(vobj.Object)
        return True

    def setEdit(self, vobj, mode=0):
        return False

    def unsetEdit(self, vobj, mode=0):
        return True

    def onDelete(self, vobj, subelements):
        """Deletes the steps' meshes too, with their children."""
        for mesh in vobj.Object.Meshes:
            for thing in (*mesh.ViewObject.Proxy.own_children(), mesh):
                thing.Document.removeObject(thing.Name)
        return True
