"""The commands. Each calls what scripts can call too, so that the console shows how."""
import FreeCAD
import FreeCADGui

from paver_wb import mesh_object, refinement

QT_TRANSLATE_NOOP = FreeCAD.Qt.QT_TRANSLATE_NOOP
translate = FreeCAD.Qt.translate
FACETS_ALONG = 20  # elements along the diagonal of what is selected, for a first size


def resources(name, text, tooltip):
    return {"MenuText": QT_TRANSLATE_NOOP(name, text), "ToolTip": QT_TRANSLATE_NOOP(name, tooltip), "Pixmap": name}


def selected():
    """(meshes, other objects) of the selection."""
    things = FreeCADGui.Selection.getSelection()
    return [t for t in things if mesh_object.is_mesh(t)], [t for t in things if not mesh_object.is_mesh(t)]


def do(line):
    FreeCADGui.doCommand(line)


def in_step(name, line):
    """Runs a line of Python as one step of undo; an error ends up in the report view and leaves no trace."""
    document = FreeCAD.ActiveDocument
    document.openTransaction(name)
    try:
        do(line)
    except Exception as error:
        document.abortTransaction()
        FreeCAD.Console.PrintError(f"{error}\n")
        return False
    document.commitTransaction()
    return True


def python_name(thing):
    return f'FreeCAD.getDocument("{thing.Document.Name}").getObject("{thing.Name}")'


def first_size(things):
    """Target length for a first mesh, mm, of one digit; 1 for things without an extent."""
    import Part
    diagonals = [Part.getShape(thing).BoundBox.DiagonalLength for thing in things
                 if not Part.getShape(thing).isNull()]
    size = max(diagonals, default=0) / FACETS_ALONG
    return float(f"{size:.0e}") if size > 0 else 1.0


class CreateMesh:
    def GetResources(self):
        return resources("Paver_CreateMesh", "Create mesh", "Makes a mesh object for the selected objects and opens "
                         "its panel")

    def IsActive(self):
        return FreeCAD.ActiveDocument is not None and bool(selected()[1])

    def Activated(self):
        things = selected()[1]
        FreeCADGui.addModule("paver_wb.mesh_object")
        parts = ", ".join(python_name(thing) for thing in things)
        if in_step("Create mesh", f"mesh = paver_wb.mesh_object.add(FreeCAD.ActiveDocument, [{parts}], "
                                  f"size={first_size(things)!r})"):
            FreeCADGui.Selection.clearSelection()
            do("FreeCADGui.Selection.addSelection(mesh)")
            FreeCADGui.addModule("paver_wb.gui.task_panel")
            do("paver_wb.gui.task_panel.edit_new(mesh)")


class OnMeshes:
    """A command that works on the selected mesh objects, each in a step of undo of its own."""

    module, function = "", ""

    def IsActive(self):
        return FreeCAD.ActiveDocument is not None and bool(selected()[0])

    def Activated(self):
        FreeCADGui.addModule(self.module)
        for obj in selected()[0]:
            try:
                do(f"{self.module}.{self.function}({python_name(obj)})")
            except Exception as error:
                FreeCAD.Console.PrintError(f"{obj.Label}: {error}\n")


class Mesh(OnMeshes):
    module, function = "paver_wb.gui.run_control", "start"

    def GetResources(self):
        return resources("Paver_Mesh", "Mesh", "Meshes the selected mesh objects with their options, while "
                         "FreeCAD can be used; double click on one for its panel")


class Refine:
    """A refinement of what is selected in the 3D view: of the selected mesh, else of the one that has it."""

    def GetResources(self):
        return resources("Paver_Refine", "Refine", "Shorter elements on the selected faces, edges, vertices or solids, "
                         "and around them")

    def IsActive(self):
        document = FreeCAD.ActiveDocument
        return document is not None and bool(mesh_object.meshes_of(document)) and bool(selected()[1])

    def Activated(self):
        references = [(s.Object, list(s.SubElementNames) or [""]) for s in FreeCADGui.Selection.getSelectionEx()
                      if not mesh_object.is_mesh(s.Object)]
        meshes = selected()[0] or refinement.meshes_with(FreeCAD.ActiveDocument, references)
        if not meshes:
            FreeCAD.Console.PrintError(translate("Paver", "No mesh has what is selected; select its mesh too, or make "
                                                 "one with Create mesh.") + "\n")
            return
        FreeCADGui.addModule("paver_wb.refinement")
        listed = ", ".join(f"({python_name(thing)}, {elements!r})" for thing, elements in references)
        if in_step("Refine", f"refinement = paver_wb.refinement.make({python_name(meshes[0])}, [{listed}], "
                             f"{refinement.first_length(meshes[0])!r})"):
            FreeCADGui.Selection.clearSelection()
            do("FreeCADGui.Selection.addSelection(refinement)")


class FillFemMesh(OnMeshes):
    module, function = "paver_wb.meshing", "fill"

    def GetResources(self):
        return resources("Paver_FillFemMesh", "Fill FEM mesh", "Fills FemMesh of the selected mesh objects, whatever "
                         "the size, for solvers and exports of the FEM workbench")


class About:
    def GetResources(self):
        return resources("Paver_About", "About Paver", "Shows versions in the report view, for a report of a fault")

    def IsActive(self):
        return True

    def Activated(self):
        FreeCADGui.addModule("paver_wb.core")
        do('FreeCAD.Console.PrintMessage("\\n".join(paver_wb.core.about()) + "\\n")')


COMMANDS = {"Paver_CreateMesh": CreateMesh, "Paver_Refine": Refine, "Paver_Mesh": Mesh, "Paver_FillFemMesh": FillFemMesh,
            "Paver_About": About}


def add_all():
    """Makes the commands known to FreeCAD; their names in the order of the toolbar."""
    for name, command in COMMANDS.items():
        FreeCADGui.addCommand(name, command())
    return list(COMMANDS)
