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
        """Selects what it refers to, so that the 3D view shows it."""
        import FreeCADGui
        FreeCADGui.Selection.clearSelection()
        for thing, elements in vobj.Object.References:
            for element in elements or ("",):
                FreeCADGui.Selection.addSelection(thing, element)
        return True
