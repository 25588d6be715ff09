"""How a refinement looks in the tree. Documents name this module and RefinementViewProvider."""
import os

from paver_wb.gui.paths import ICONS
from paver_wb.stateless import Stateless


class RefinementViewProvider(Stateless):
    """View provider of a refinement. Nothing of it is stored but its name."""

    def __init__(self, vobj):
        vobj.Proxy = self

    def getIcon(self):
        return os.path.join(ICONS, "Paver_Refine.svg")

    def doubleClicked(self, vobj):
        vobj.Document.setEdit(vobj.Object.Name)
        return True

    def setEdit(self, vobj, mode=0):
        from paver_wb.gui import refinement_panel
        return refinement_panel.set_edit(vobj.Object) if mode == 0 else None

    def unsetEdit(self, vobj, mode=0):
        from paver_wb.gui import refinement_panel
        refinement_panel.unset_edit()
