"""How a refinement looks in the tree. Documents name this module and RefinementViewProvider."""
from paver_wb.gui.base.view import ChildViewProvider


class RefinementViewProvider(ChildViewProvider):
    icon, panel = "Paver_Refine.svg", ("paver_wb.gui.refinement_panel", "RefinementPanel")
