"""Commands for the mesh in the 3D view: each sets a property of its view object, as one step of undo."""
import FreeCADGui

from paver_wb.gui.commands.common import QT_TRANSLATE_NOOP, OnMeshed, in_step, python_name, shown_as, target_mesh
from paver_wb.gui.display import colouring

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


class Colours(OnShown):
    """All colours behind one button."""

    resources = shown_as("Paver_Colours", QT_TRANSLATE_NOOP("Paver_Colours", "Colours of the elements"),
                         QT_TRANSLATE_NOOP("Paver_Colours", "What the colours of the elements tell"))

    def GetCommands(self):
        return tuple(COLOURS)

    def GetDefaultCommand(self):
        return 1


class Worst(OnShown):
    resources = shown_as("Paver_ShowWorst", QT_TRANSLATE_NOOP("Paver_ShowWorst", "Worst elements"), QT_TRANSLATE_NOOP(
        "Paver_ShowWorst", "Marks the ten elements with the least scaled Jacobian, or no longer"), "Q, W")

    def Activated(self):
        count = 0 if target_mesh().ViewObject.ShowWorst else WORST
        self.act("Worst elements", f"show_worst({{}}, {count})")


class Toggle(OnShown):
    """Switches a property that is on or off, by a function of display.actions."""

    def __init__(self, property, function, resources):
        self.property, self.function, self.resources = property, function, resources

    def Activated(self):
        is_shown = not getattr(target_mesh().ViewObject, self.property)
        self.act(self.resources["MenuText"], f"{self.function}({{}}, {is_shown})")


class Shrink(OnShown):
    resources = shown_as("Paver_Shrink", QT_TRANSLATE_NOOP("Paver_Shrink", "Shrink elements"), QT_TRANSLATE_NOOP(
        "Paver_Shrink", "Draws every element smaller, so that each is seen alone, or whole again"))

    def Activated(self):
        factor = SHRUNK if target_mesh().ViewObject.ShrinkFactor == 1 else 1
        self.act("Shrink elements", f"shrink({{}}, {factor})")


COMMANDS = {
    "Paver_Colours": Colours(), "Paver_ShowWorst": Worst(),
    "Paver_ShowFreeEdges": Toggle("ShowFreeEdges", "show_free_edges", shown_as(
        "Paver_ShowFreeEdges", QT_TRANSLATE_NOOP("Paver_ShowFreeEdges", "Free edges"), QT_TRANSLATE_NOOP(
            "Paver_ShowFreeEdges", "Marks mesh edges with one element only, and those with more than two, or no longer"))),
    "Paver_ShowTriangles": Toggle("ShowTriangles", "show_triangles", shown_as(
        "Paver_ShowTriangles", QT_TRANSLATE_NOOP("Paver_ShowTriangles", "Triangles"), QT_TRANSLATE_NOOP(
            "Paver_ShowTriangles", "Marks the triangles, or no longer"))),
    "Paver_ShowNormals": Toggle("ShowNormals", "show_normals", shown_as(
        "Paver_ShowNormals", QT_TRANSLATE_NOOP("Paver_ShowNormals", "Normals"), QT_TRANSLATE_NOOP(
            "Paver_ShowNormals", "Shows the outward normal of every element, or no longer"))),
    "Paver_Shrink": Shrink()}


def add_all():
    """Makes the commands known to FreeCAD; their names in the order of the toolbar."""
    for name, command in {**{name: Colour(name) for name in COLOURS}, **COMMANDS}.items():
        FreeCADGui.addCommand(name, command)
    return list(COMMANDS)
