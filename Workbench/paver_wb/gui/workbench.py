"""The workbench: toolbar, menu, icons, preference page, translations."""
import os

import FreeCAD
import FreeCADGui
from PySide import QtCore

from paver_wb import core
from paver_wb.base import proxies
from paver_wb.base.paths import FORMS, ICONS, TRANSLATIONS
from paver_wb.gui.named_view import MediumViewProvider, PortViewProvider, WireViewProvider
from paver_wb.gui.refinement_view import RefinementViewProvider
from paver_wb.gui.series.view import SeriesViewProvider
from paver_wb.gui.view_provider import MeshViewProvider

QT_TRANSLATE_NOOP = FreeCAD.Qt.QT_TRANSLATE_NOOP
VIEW = QT_TRANSLATE_NOOP("Workbench", "Paver view")
EXAMPLES = QT_TRANSLATE_NOOP("Workbench", "Examples")


def register():
    """Called when FreeCAD's window is made: what is there before the workbench is chosen, also for documents."""
    FreeCADGui.addLanguagePath(TRANSLATIONS)
    FreeCADGui.updateLocale()
    FreeCADGui.addIconPath(ICONS)
    FreeCADGui.addPreferencePage(os.path.join(FORMS, "preferences.ui"), "Paver")
    PaverWorkbench.ToolTip = FreeCAD.Qt.translate("Paver", PaverWorkbench.ToolTip)
    FreeCADGui.addWorkbench(PaverWorkbench())
    from paver_wb.gui import moved_parts  # noqa: F401, starts to follow documents
    proxies.views.update({proxies.MESH: MeshViewProvider, proxies.REFINEMENT: RefinementViewProvider,
                          proxies.MEDIUM: MediumViewProvider, proxies.PORT: PortViewProvider, proxies.WIRE: WireViewProvider,
                          proxies.SERIES: SeriesViewProvider})


def load_what_takes_a_moment():
    """Now rather than with the first mesh object."""
    from paver_wb.gui.display import selection  # noqa: F401
    try:
        import FemGui  # noqa: F401
    except ImportError:
        FreeCAD.Console.PrintError(FreeCAD.Qt.translate("Paver", "This FreeCAD is built without its FEM module, which "
                                                                 "mesh objects need; install one that has it.") + "\n")


def set_up():
    from paver_wb.gui.setup import first_use
    first_use.show()


class PaverWorkbench(FreeCADGui.Workbench):
    """Quad meshes of surfaces, by paving."""

    Icon = os.path.join(ICONS, "Paver.svg")
    MenuText = "Paver"
    ToolTip = QT_TRANSLATE_NOOP("Paver", "Curved quadrilateral meshes of surfaces for Method-of-Moments solvers")

    def Initialize(self):
        """Called once, when the workbench is first chosen."""
        from paver_wb.gui import commands
        from paver_wb.gui.commands import view
        examples, views = commands.add_all(), view.add_all()
        load_what_takes_a_moment()
        self.appendToolbar("Paver", commands.TOOLBAR)
        self.appendToolbar(VIEW, views)
        self.appendMenu("&Paver", commands.MENU)
        self.appendMenu(["&Paver", VIEW], views)
        self.appendMenu(["&Paver", EXAMPLES], examples)
        self.appendMenu("&Paver", commands.ABOUT)

    def Activated(self):
        problem = core.problem()
        if problem:
            FreeCAD.Console.PrintError(problem + "\n")
            QtCore.QTimer.singleShot(0, set_up)  # FreeCAD first shows the workbench

    def GetClassName(self):
        return "Gui::PythonWorkbench"
