"""The workbench: toolbar, menu, icons."""
import os

import FreeCAD
import FreeCADGui
from FreeCAD import Qt

from paver_wb import core

ICONS = os.path.join(os.path.dirname(os.path.realpath(__file__)), *[os.pardir] * 3, "Resources", "icons")
TRANSLATE = Qt.translate


class PaverWorkbench(FreeCADGui.Workbench):
    """Quad meshes of surfaces, by paving."""

    Icon = os.path.normpath(os.path.join(ICONS, "Paver.svg"))
    MenuText = "Paver"
    ToolTip = TRANSLATE("Paver", "Curved quadrilateral meshes of surfaces for Method-of-Moments solvers")

    def Initialize(self):
        """Called once, when the workbench is first chosen."""
        from paver_wb.gui import commands
        FreeCADGui.addIconPath(os.path.normpath(ICONS))
        names = commands.add_all()
        self.appendToolbar("Paver", names)
        self.appendMenu("&Paver", names)

    def Activated(self):
        problem = core.problem()
        if problem:
            FreeCAD.Console.PrintError(problem + "\n")

    def GetClassName(self):
        return "Gui::PythonWorkbench"
