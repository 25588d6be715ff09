"""Commands that make and change mesh objects."""
import FreeCAD
import FreeCADGui

from paver_wb import mesh_object, preferences, refinement, series
from paver_wb.gui.commands.common import (QT_TRANSLATE_NOOP, Command, call_text, do, in_step, python_name, run,
                                          selected_meshes, shown_as, target_mesh, tell, translate)
from paver_wb.gui.base.steps import references_text
from paver_wb.gui.display import selection


class CreateMesh(Command):
    resources = shown_as("Paver_CreateMesh", QT_TRANSLATE_NOOP("Paver_CreateMesh", "Create mesh"), QT_TRANSLATE_NOOP(
        "Paver_CreateMesh", "Makes a mesh object for the selected objects and opens its panel"), "Q, C")

    def IsActive(self):
        return FreeCAD.ActiveDocument is not None and bool(selection.selected_parts())

    def Activated(self):
        things = selection.selected_parts()
        for module in ("paver_wb.mesh_object", "paver_wb.analysis"):
            FreeCADGui.addModule(module)
        parts = ", ".join(python_name(thing) for thing in things)
        making = call_text("paver_wb.mesh_object.add", "FreeCAD.ActiveDocument", f"[{parts}]", **preferences.new_options(things))
        if in_step("Create mesh", "mesh = " + making, "paver_wb.analysis.join_active(mesh)"):
            FreeCADGui.Selection.clearSelection()
            do("FreeCADGui.Selection.addSelection(mesh)")
            do("edit_new(mesh)", "paver_wb.gui.base.edit_panel")


class OnMeshes(Command):
    """A command that works on the selected mesh objects, each in a step of undo of its own."""

    def __init__(self, module, function, resources):
        self.module, self.function, self.resources = module, function, resources

    def IsActive(self):
        return FreeCAD.ActiveDocument is not None and bool(selected_meshes())

    def Activated(self):
        for obj in selected_meshes():
            run(f"{self.function}({python_name(obj)})", self.module)


class Child(Command):
    """Makes a child of a mesh object of what is selected in the 3D view, and opens its panel."""

    def __init__(self, resources):
        self.resources = resources

    def IsActive(self):
        document = FreeCAD.ActiveDocument
        return document is not None and bool(mesh_object.meshes_of(document)) and selection.may_refine()

    def call(self, references):
        """(module, call of a function of it that makes the child). ValueError where no mesh is meant."""
        raise NotImplementedError

    def Activated(self):
        try:
            module, call = self.call(selection.references())
        except Exception as error:
            tell(error)
            return
        FreeCADGui.addModule(module)
        if in_step(self.resources["MenuText"], f"made = {module}.{call}"):
            FreeCADGui.Selection.clearSelection()
            do("FreeCADGui.Selection.addSelection(made)")
            if not FreeCADGui.Control.activeDialog():
                do("edit_new(made)", "paver_wb.gui.base.edit_panel")


class Refine(Child):
    """Of the selected mesh, else of the one that has what is selected."""

    def call(self, references):
        mesh = mesh_with(references)
        if mesh is None:
            raise ValueError(translate("Paver", "No mesh has what is selected. Select its mesh, too, or make one with Create "
                                       "mesh."))
        return "paver_wb.refinement", (f"make({python_name(mesh)}, {references_text(references)}, "
                                       f"{refinement.first_length(mesh)!r})")


class Name(Child):
    """A medium, a port or a wire, of the same; a wire may be of what no mesh has yet."""

    def __init__(self, kind, resources):
        super().__init__(resources)
        self.kind = kind

    def call(self, references):
        mesh = mesh_with(references) or target_mesh()
        if mesh is None:
            raise ValueError(several_meshes())
        return "paver_wb.children.named_parts", f"make_{self.kind}({python_name(mesh)}, {references_text(references)})"


def mesh_with(references):
    """The selected mesh, else the one that has what is selected, no step of a series; None without any, ValueError where several
    have it."""
    document = FreeCAD.ActiveDocument
    steps = series.step_meshes(document)
    found = selected_meshes()[:1] or [mesh for mesh in refinement.meshes_with(document, references) if mesh not in steps]
    if len(found) > 1:
        raise ValueError(several_meshes())
    return next(iter(found), None)


def several_meshes():
    return translate("Paver", "There are several meshes; select the one that it belongs to, too.")


class Series(Command):
    """Opens the dialog of the selected series, else for one of the selected mesh or the document's only one."""

    resources = shown_as("Paver_Series", QT_TRANSLATE_NOOP("Paver_Series", "Series..."), QT_TRANSLATE_NOOP(
        "Paver_Series", "Meshes for several frequencies, elements per wavelength or target lengths, one after the other, "
        "and a table of elements, unknowns, memory and quality"), "Q, L")

    def IsActive(self):
        return series_target() is not None

    def Activated(self):
        run(f"show({python_name(series_target())})", "paver_wb.gui.series.panel")


def series_target():
    """A series, else a mesh object; None where neither is meant."""
    chosen = next(filter(series.is_series, FreeCADGui.Selection.getSelection()), None)
    return chosen or target_mesh()


COMMANDS = {
    "Paver_CreateMesh": CreateMesh(),
    "Paver_Refine": Refine(shown_as("Paver_Refine", QT_TRANSLATE_NOOP("Paver_Refine", "Refine"), QT_TRANSLATE_NOOP(
        "Paver_Refine", "Shorter elements on the selected faces, edges, vertices or solids of what is meshed, or on the "
        "faces under selected elements, and around them; opens a panel for the length"), "Q, R")),
    "Paver_Series": Series(),
    "Paver_Medium": Name("medium", shown_as("Paver_Medium", QT_TRANSLATE_NOOP("Paver_Medium", "Medium"), QT_TRANSLATE_NOOP(
        "Paver_Medium", "Says what the selected solids are made of: sets the target length there, and is written to files"))),
    "Paver_Port": Name("port", shown_as("Paver_Port", QT_TRANSLATE_NOOP("Paver_Port", "Port"), QT_TRANSLATE_NOOP(
        "Paver_Port", "Gives the selected faces, edges and vertices a name in the mesh and its files, for feeds and loads"))),
    "Paver_Wire": Name("wire", shown_as("Paver_Wire", QT_TRANSLATE_NOOP("Paver_Wire", "Wire"), QT_TRANSLATE_NOOP(
        "Paver_Wire", "Meshes the selected edges or sketches as a thin wire, joined to the faces that it ends on"))),
    "Paver_Mesh": OnMeshes("paver_wb.gui.run_control", "start", shown_as(
        "Paver_Mesh", QT_TRANSLATE_NOOP("Paver_Mesh", "Mesh"), QT_TRANSLATE_NOOP(
            "Paver_Mesh", "Meshes the selected mesh objects with their options, while FreeCAD can be used; double click "
            "on one for its panel"), "Q, M")),
    "Paver_FillFemMesh": OnMeshes("paver_wb.meshing", "fill", shown_as(
        "Paver_FillFemMesh", QT_TRANSLATE_NOOP("Paver_FillFemMesh", "Fill FEM mesh"), QT_TRANSLATE_NOOP(
            "Paver_FillFemMesh", "Fills FemMesh of the selected mesh objects, whatever the size, for solvers and exports "
            "of the FEM workbench")))}
