"""The commands. Each calls what scripts can call too, so that the console shows how."""
import FreeCADGui

from paver_wb.gui.commands import about, files, look, mesh

COMMANDS = {**mesh.COMMANDS, **look.COMMANDS, "Paver_Export": files.Export(), "Paver_Import": files.Import(),
            "Paver_Preferences": about.Preferences(), "Paver_Help": about.Help(), "Paver_About": about.About()}
SEPARATOR = "Separator"
TOOLBAR = ["Paver_CreateMesh", "Paver_Refine", "Paver_Medium", "Paver_Port", "Paver_Wire", "Paver_Mesh", "Paver_Series", SEPARATOR,
           "Paver_Check", "Paver_Statistics", SEPARATOR,
           "Paver_FillFemMesh", "Paver_Export", "Paver_Import", SEPARATOR, "Paver_Help"]
MENU = TOOLBAR[:-2] + [SEPARATOR, "Paver_Preferences"]
ABOUT = [SEPARATOR, "Paver_Help", "Paver_About"]


def add_all():
    """Makes the commands known to FreeCAD; the names of those that open examples."""
    examples = files.example_commands()
    for name, command in {**COMMANDS, **examples}.items():
        FreeCADGui.addCommand(name, command)
    return list(examples)
