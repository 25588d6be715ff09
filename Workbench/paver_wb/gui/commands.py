"""The commands. Each calls what scripts can call too."""
import FreeCAD
import FreeCADGui

QT_TRANSLATE_NOOP = FreeCAD.Qt.QT_TRANSLATE_NOOP


class About:
    """Versions, for a report of a fault."""

    def GetResources(self):
        return {"MenuText": QT_TRANSLATE_NOOP("Paver_About", "About Paver"),
                "ToolTip": QT_TRANSLATE_NOOP("Paver_About", "Shows versions in the report view, for a report of a fault"),
                "Pixmap": "Paver_About"}

    def IsActive(self):
        return True

    def Activated(self):
        FreeCADGui.addModule("paver_wb.core")
        FreeCADGui.doCommand('FreeCAD.Console.PrintMessage("\\n".join(paver_wb.core.about()) + "\\n")')


COMMANDS = {"Paver_About": About}


def add_all():
    """Makes the commands known to FreeCAD; their names in the order of the toolbar."""
    for name, command in COMMANDS.items():
        FreeCADGui.addCommand(name, command())
    return list(COMMANDS)
