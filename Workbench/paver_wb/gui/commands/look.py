"""Commands that tell about a mesh."""
from paver_wb.gui.commands.common import QT_TRANSLATE_NOOP, OnMeshed, python_name, run, shown_as, target_mesh


class Look(OnMeshed):
    """Shows the dialog of a module."""

    def __init__(self, module, resources):
        self.module, self.resources = module, resources

    def Activated(self):
        run(f"show({python_name(target_mesh())})", self.module)


COMMANDS = {
    "Paver_Check": Look("paver_wb.gui.check_panel", shown_as(
        "Paver_Check", QT_TRANSLATE_NOOP("Paver_Check", "Check mesh"), QT_TRANSLATE_NOOP(
            "Paver_Check", "Looks for faces that failed, folded and poor elements, free edges, triangles, long and "
            "short edges, says what it finds, and goes there"), "Q, K")),
    "Paver_Statistics": Look("paver_wb.gui.statistics_panel", shown_as(
        "Paver_Statistics", QT_TRANSLATE_NOOP("Paver_Statistics", "Statistics"), QT_TRANSLATE_NOOP(
            "Paver_Statistics", "Lengths, areas and quality in millimetres and wavelengths, histograms, unknowns and "
            "matrix memory"), "Q, S"))}
