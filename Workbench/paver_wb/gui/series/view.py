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

    def own_children(self):
        """The steps' meshes, each after its own children."""
        for mesh in self.claimChildren():
            yield from (*mesh.ViewObject.Proxy.own_children(), mesh)
