"""The workbench: toolbar, menu, icons."""
import os

import FreeCAD
import FreeCADGui

from paver_wb import core
from paver_wb.gui.paths import ICONS


class PaverWorkbench(FreeCADGui.Workbench):
    """Quad meshes of surfaces, by paving."""

    Icon = os.path.join(ICONS, "Paver.svg")
    MenuText = "Paver"
    ToolTip = FreeCAD.Qt.translate("Paver", "Curved quadrilateral meshes of surfaces for Method-of-Moments solvers")

    def Initialize(self):
        """Called once, when the workbench is first chosen."""
        from paver_wb.gui import commands
        FreeCADGui.addIconPath(ICONS)
        names = commands.add_all()
        self.appendToolbar("Paver", names)
        self.appendMenu("&Paver", names)

    def Activated(self):
        problem = core.problem()
        if problem:
            FreeCAD.Console.PrintError(problem + "\n")

    def GetClassName(self):
        return "Gui::PythonWorkbench"
