"""Commands that tell about a mesh."""
import FreeCADGui

from paver_wb.gui.commands.common import QT_TRANSLATE_NOOP, OnMeshed, python_name, run, shown_as, target_mesh


class Look(OnMeshed):
    """Shows a dialog."""

    module = ""

    def Activated(self):
        FreeCADGui.addModule(self.module)
        run(f"{self.module}.show({python_name(target_mesh())})")


class Check(Look):
    module = "paver_wb.gui.check_panel"
    resources = shown_as("Paver_Check", QT_TRANSLATE_NOOP("Paver_Check", "Check mesh"), QT_TRANSLATE_NOOP(
        "Paver_Check", "Looks for folded and poor elements, free edges, triangles, long edges, and says what it "
        "finds"), "Q, K")


class Statistics(Look):
    module = "paver_wb.gui.statistics_panel"
    resources = shown_as("Paver_Statistics", QT_TRANSLATE_NOOP("Paver_Statistics", "Statistics"), QT_TRANSLATE_NOOP(
        "Paver_Statistics", "Lengths, areas and quality in millimetres and wavelengths, histograms, unknowns and "
        "matrix memory"), "Q, S")
