"""Commands that make and change mesh objects."""
import FreeCAD
import FreeCADGui

from paver_wb import mesh_object, preferences, refinement
from paver_wb.gui.commands.common import (QT_TRANSLATE_NOOP, Command, complain, do, in_step, python_name, run,
                                          selected, shown_as, translate)


class CreateMesh(Command):
    resources = shown_as("Paver_CreateMesh", QT_TRANSLATE_NOOP("Paver_CreateMesh", "Create mesh"), QT_TRANSLATE_NOOP(
        "Paver_CreateMesh", "Makes a mesh object for the selected objects and opens its panel"), "Q, C")

    def IsActive(self):
        return FreeCAD.ActiveDocument is not None and bool(parts_selected())

    def Activated(self):
        things = parts_selected()
        FreeCADGui.addModule("paver_wb.mesh_object")
        parts = ", ".join(python_name(thing) for thing in things)
        options = ", ".join(f"{name}={value!r}" for name, value in preferences.new_options(things).items())
        if in_step("Create mesh", f"mesh = paver_wb.mesh_object.add(FreeCAD.ActiveDocument, [{parts}], {options})"):
            FreeCADGui.Selection.clearSelection()
            do("FreeCADGui.Selection.addSelection(mesh)")
            do("edit_new(mesh)", "paver_wb.gui.task_panel")


def parts_selected():
    """Selected objects that may be meshed."""
    return [thing for thing in selected()[1] if not refinement.is_refinement(thing)]


class OnMeshes(Command):
    """A command that works on the selected mesh objects, each in a step of undo of its own."""

    def __init__(self, module, function, resources):
        self.module, self.function, self.resources = module, function, resources

    def IsActive(self):
        return FreeCAD.ActiveDocument is not None and bool(selected()[0])

    def Activated(self):
        for obj in selected()[0]:
            run(f"{self.function}({python_name(obj)})", self.module)


class Refine(Command):
    """A refinement of what is selected in the 3D view: of the selected mesh, else of the one that has it."""

    resources = shown_as("Paver_Refine", QT_TRANSLATE_NOOP("Paver_Refine", "Refine"), QT_TRANSLATE_NOOP(
        "Paver_Refine", "Shorter elements on the selected faces, edges, vertices or solids of what is meshed, and "
        "around them; opens a panel for the length"), "Q, R")

    def IsActive(self):
        document = FreeCAD.ActiveDocument
        return document is not None and bool(mesh_object.meshes_of(document)) and bool(parts_selected())

    def Activated(self):
        references = [(s.Object, list(s.SubElementNames) or [""]) for s in FreeCADGui.Selection.getSelectionEx()
                      if s.Object in parts_selected()]
        meshes = selected()[0] or refinement.meshes_with(FreeCAD.ActiveDocument, references)
        if not meshes:
            complain(translate("Paver", "No mesh has what is selected. Select its mesh, too, or make one with Create "
                               "mesh."))
            return
        FreeCADGui.addModule("paver_wb.refinement")
        listed = ", ".join(f"({python_name(thing)}, {elements!r})" for thing, elements in references)
        if in_step("Refine", f"refinement = paver_wb.refinement.make({python_name(meshes[0])}, [{listed}], "
                             f"{refinement.first_length(meshes[0])!r})"):
            FreeCADGui.Selection.clearSelection()
            do("FreeCADGui.Selection.addSelection(refinement)")
            if not FreeCADGui.Control.activeDialog():
                do("edit_new(refinement)", "paver_wb.gui.refinement_panel")


COMMANDS = {
    "Paver_CreateMesh": CreateMesh(), "Paver_Refine": Refine(),
    "Paver_Mesh": OnMeshes("paver_wb.gui.run_control", "start", shown_as(
        "Paver_Mesh", QT_TRANSLATE_NOOP("Paver_Mesh", "Mesh"), QT_TRANSLATE_NOOP(
            "Paver_Mesh", "Meshes the selected mesh objects with their options, while FreeCAD can be used; double click "
            "on one for its panel"), "Q, M")),
    "Paver_FillFemMesh": OnMeshes("paver_wb.meshing", "fill", shown_as(
        "Paver_FillFemMesh", QT_TRANSLATE_NOOP("Paver_FillFemMesh", "Fill FEM mesh"), QT_TRANSLATE_NOOP(
            "Paver_FillFemMesh", "Fills FemMesh of the selected mesh objects, whatever the size, for solvers and exports "
            "of the FEM workbench")))}
