"""Commands that tell about a mesh."""
import FreeCADGui

from paver_wb.gui.commands.common import QT_TRANSLATE_NOOP, python_name, resources, run, target_mesh


class OnMeshed:
    """A command on the selected mesh object, or the document's only one, once it is meshed."""

    module = ""

    def IsActive(self):
        obj = target_mesh()
        return obj is not None and bool(obj.MeshFile)

    def Activated(self):
        FreeCADGui.addModule(self.module)
        run(f"{self.module}.show({python_name(target_mesh())})")


class Check(OnMeshed):
    module = "paver_wb.gui.check_panel"

    def GetResources(self):
        return resources("Paver_Check", QT_TRANSLATE_NOOP("Paver_Check", "Check mesh"), QT_TRANSLATE_NOOP(
            "Paver_Check", "Looks for folded and poor elements, free edges, triangles, long edges, and says what it "
            "finds"), "Q, K")


class Statistics(OnMeshed):
    module = "paver_wb.gui.statistics_panel"

    def GetResources(self):
        return resources("Paver_Statistics", QT_TRANSLATE_NOOP("Paver_Statistics", "Statistics"), QT_TRANSLATE_NOOP(
            "Paver_Statistics", "Lengths, areas and quality in millimetres and wavelengths, histograms, unknowns and "
            "matrix memory"), "Q, S")
