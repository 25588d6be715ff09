"""What the view providers share."""
import importlib
import os

from paver_wb.base.paths import ICONS
from paver_wb.base.proxies import Stateless
from paver_wb.gui.base import edit_panel


class ViewProvider(Stateless):
    """Of an object that a panel edits. Nothing of it is stored but its name. icon: name of a file; panel: its module,
    which is loaded when it is needed, and class."""

    icon, panel = "", ("", "")

    def __init__(self, vobj):
        vobj.Proxy = self

    def getIcon(self):
        return os.path.join(ICONS, self.icon)

    def doubleClicked(self, vobj):
        vobj.Document.setEdit(vobj.Object.Name)
        return True

    def setEdit(self, vobj, mode=0):
        module, kind = self.panel
        return edit_panel.set_edit(vobj.Object, getattr(importlib.import_module(module), kind)) if mode == 0 else None

    def unsetEdit(self, vobj, mode=0):
        edit_panel.unset_edit()

    def own_children(self):
        """Objects that are of no use without this one."""
        return []

    def onDelete(self, vobj, subelements):
        """Deletes these too."""
        for child in self.own_children():
            child.Document.removeObject(child.Name)
        return True


class ChildViewProvider(ViewProvider):
    """Of what has no picture in the 3D view."""

    def __init__(self, vobj):
        super().__init__(vobj)
        vobj.Visibility = True  # else the tree greys it out
