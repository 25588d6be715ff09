"""Commands for the mesh in the 3D view: each sets a property of its view object, as one step of undo."""
import FreeCADGui

from paver_wb.gui.commands.common import (QT_TRANSLATE_NOOP, OnMeshed, complain, in_step, python_name, shown_as,
                                          target_mesh, tell, translate)
from paver_wb.gui.display import actions, colouring

WORST, SHRUNK = 10, 0.75  # what the buttons choose; the property editor has any number

COLOURS = {
    "Paver_ColourNone": (colouring.NONE, QT_TRANSLATE_NOOP("Paver_ColourNone", "One colour")),
    "Paver_ColourQuality": (colouring.SJ, QT_TRANSLATE_NOOP("Paver_ColourQuality", "Colours by scaled Jacobian")),
    "Paver_ColourLength": (colouring.LENGTH, QT_TRANSLATE_NOOP("Paver_ColourLength", "Colours by edge length / target")),
    "Paver_ColourLocalLength": (colouring.LOCAL_LENGTH, QT_TRANSLATE_NOOP("Paver_ColourLocalLength",
                                                                          "Colours by edge length / local target")),
    "Paver_ColourType": (colouring.KIND, QT_TRANSLATE_NOOP("Paver_ColourType", "Colours by element type")),
    "Paver_ColourFace": (colouring.FACE, QT_TRANSLATE_NOOP("Paver_ColourFace", "Colours by source face")),
    "Paver_ColourCertificate": (colouring.CERTIFICATE, QT_TRANSLATE_NOOP("Paver_ColourCertificate",
                                                                         "Colours by certificate")),
}

# name: (function of display.actions, the one that gives what of the selection it is for, text)
ISOLATES = {
    "Paver_HideFaces": ("hide", "faces_of_selection", QT_TRANSLATE_NOOP("Paver_HideFaces", "Hide faces of the selection")),
    "Paver_OnlyFaces": ("show_only", "faces_of_selection", QT_TRANSLATE_NOOP("Paver_OnlyFaces",
                                                                             "Only faces of the selection")),
    "Paver_OnlySelected": ("isolate", "elements_of_selection", QT_TRANSLATE_NOOP("Paver_OnlySelected",
                                                                                 "Only selected elements")),
    "Paver_OnlyWorst": ("isolate_worst", None, QT_TRANSLATE_NOOP("Paver_OnlyWorst", "Only the worst elements")),
    "Paver_OnlyFreeEdges": ("isolate_free_edges", None, QT_TRANSLATE_NOOP("Paver_OnlyFreeEdges", "Only free edges")),
    "Paver_ShowEverything": ("show_everything", None, QT_TRANSLATE_NOOP("Paver_ShowEverything", "Everything again"))}


class OnShown(OnMeshed):
    def act(self, step, call):
        """Calls a function of display.actions; `call` has {} in place of the mesh object."""
        in_step(step, call.format(python_name(target_mesh())), module="paver_wb.gui.display.actions")


class Colour(OnShown):
    def __init__(self, name):
        self.what, text = COLOURS[name]
        self.resources = shown_as("Paver_Colours", text, text)

    def Activated(self):
        self.act("Colours", f"colour_by({{}}, {self.what!r})")


class Group(OnShown):
    """Several commands behind one button. first: number of the one that it begins with."""

    def __init__(self, names, first, resources):
        self.names, self.first, self.resources = names, first, resources

    def GetCommands(self):
        return tuple(self.names)

    def GetDefaultCommand(self):
        return self.first


class Isolate(OnShown):
    """Shows a part of the mesh alone, by a function of display.actions."""

    def __init__(self, name):
        self.function, self.selected, text = ISOLATES[name]
        self.resources = shown_as("Paver_Isolate", text, text)

    def Activated(self):
        try:
            arguments = "" if self.selected is None else f", {getattr(actions, self.selected)(target_mesh())!r}"
        except Exception as error:
            tell(error)
            return
        if arguments == ", []":
            complain(translate("Paver", "Nothing of the mesh is selected. Click on its elements in the 3D view first, with Ctrl on "
                                        "several."))
            return
        self.act("Isolate", f"{self.function}({{}}{arguments})")


class Toggle(OnShown):
    """Switches a property between two values, by a function of display.actions."""

    def __init__(self, property, function, resources, on=True, off=False):
        self.property, self.function, self.resources, self.on, self.off = property, function, resources, on, off

    def Activated(self):
        value = self.on if getattr(target_mesh().ViewObject, self.property) == self.off else self.off
        self.act(self.resources["MenuText"], f"{self.function}({{}}, {value})")


COMMANDS = {
    "Paver_Colours": Group(COLOURS, 1, shown_as(
        "Paver_Colours", QT_TRANSLATE_NOOP("Paver_Colours", "Colours of the elements"), QT_TRANSLATE_NOOP(
            "Paver_Colours", "What the colours of the elements tell"))),
    "Paver_Isolate": Group(ISOLATES, 0, shown_as(
        "Paver_Isolate", QT_TRANSLATE_NOOP("Paver_Isolate", "Parts of the mesh alone"), QT_TRANSLATE_NOOP(
            "Paver_Isolate", "Hides faces, or shows only some elements; what is hidden is not picked"))),
    "Paver_ShowWorst": Toggle("ShowWorst", "show_worst", shown_as(
        "Paver_ShowWorst", QT_TRANSLATE_NOOP("Paver_ShowWorst", "Worst elements"), QT_TRANSLATE_NOOP(
            "Paver_ShowWorst", "Marks the ten elements with the least scaled Jacobian, or no longer"), "Q, W"), WORST, 0),
    "Paver_ShowFreeEdges": Toggle("ShowFreeEdges", "show_free_edges", shown_as(
        "Paver_ShowFreeEdges", QT_TRANSLATE_NOOP("Paver_ShowFreeEdges", "Free edges"), QT_TRANSLATE_NOOP(
            "Paver_ShowFreeEdges", "Marks mesh edges with one element only, and those with more than two, or no longer"))),
    "Paver_ShowTriangles": Toggle("ShowTriangles", "show_triangles", shown_as(
        "Paver_ShowTriangles", QT_TRANSLATE_NOOP("Paver_ShowTriangles", "Triangles"), QT_TRANSLATE_NOOP(
            "Paver_ShowTriangles", "Marks the triangles, or no longer"))),
    "Paver_ShowNormals": Toggle("ShowNormals", "show_normals", shown_as(
        "Paver_ShowNormals", QT_TRANSLATE_NOOP("Paver_ShowNormals", "Normals"), QT_TRANSLATE_NOOP(
            "Paver_ShowNormals", "Shows the outward normal of every element, or no longer"))),
    "Paver_Shrink": Toggle("ShrinkFactor", "shrink", shown_as(
        "Paver_Shrink", QT_TRANSLATE_NOOP("Paver_Shrink", "Shrink elements"), QT_TRANSLATE_NOOP(
            "Paver_Shrink", "Draws every element smaller, so that each is seen alone, or whole again")), SHRUNK, 1)}


def add_all():
    """Makes the commands known to FreeCAD; their names in the order of the toolbar."""
    for name, command in {**{name: Colour(name) for name in COLOURS},
                          **{name: Isolate(name) for name in ISOLATES}, **COMMANDS}.items():
        FreeCADGui.addCommand(name, command)
    return list(COMMANDS)
