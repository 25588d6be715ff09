"""What commands and scripts call to look at a mesh. Each takes a mesh object; what it sets are properties of its view."""
import FreeCAD
import FreeCADGui

from pivy import coin

from paver_wb.gui.display import colouring, mesh_display
from paver_wb.gui.display.report import element_name, element_number
from paver_wb.gui.display.selection import display_of

AWAY, IN_SIGHT = 15, 10  # distance and height of a camera that shows one element, in lengths of its edges


def display(obj):
    """The MeshDisplay of a mesh object, up to date. ValueError when it is not meshed."""
    found = display_of(obj)
    if found is None or not obj.MeshFile:
        raise ValueError(f"'{obj.Label}' is not meshed; mesh it first.")
    show(obj)
    found.update()
    if found.mesh is None:
        raise ValueError(f"The mesh of '{obj.Label}' cannot be read; mesh it again.")
    return found


def show(obj, mode=None):
    """Makes the mesh visible, in `mode` (mesh_display.MODES), or in one of Paver's own if it is in none."""
    if mode is None:
        mode = obj.ViewObject.DisplayMode
        mode = mode if mode in mesh_display.MODES else mesh_display.CURVED_EDGES
    if obj.ViewObject.DisplayMode != mode:
        obj.ViewObject.DisplayMode = mode
    if not obj.ViewObject.Visibility:
        obj.ViewObject.Visibility = True


def colour_by(obj, what=colouring.SJ):
    """One of colouring.CHOICES."""
    show(obj)
    obj.ViewObject.ColourBy = what


def show_worst(obj, count=10):
    """Marks the elements with the least scaled Jacobian; 0: none. Gives their names, worst first."""
    shown = display(obj)
    obj.ViewObject.ShowWorst = count
    return [element_name(e) for e in shown.worst_elements(count)]


def show_free_edges(obj, is_shown=True):
    """Marks mesh edges with other than two elements; gives (edges with one, edges with more)."""
    shown = display(obj)
    obj.ViewObject.ShowFreeEdges = is_shown
    counts = shown.tessellation.outline_elements
    return int((counts == 1).sum()), int((counts > 2).sum())


def show_triangles(obj, is_shown=True):
    """Marks the triangles; gives how many there are."""
    shown = display(obj)
    obj.ViewObject.ShowTriangles = is_shown
    return shown.mesh.triangle_count


def show_normals(obj, is_shown=True):
    show(obj)
    obj.ViewObject.ShowNormals = is_shown


def shrink(obj, factor=0.8):
    """Draws elements smaller; 1: whole."""
    show(obj)
    obj.ViewObject.ShrinkFactor = factor


def element(obj, name):
    """Figures of an element, "Elem17", as a dict. ValueError when there is none of that name."""
    shown, number = display(obj), element_number(name)
    if number is None or number >= shown.mesh.count:
        raise ValueError(f"'{obj.Label}' has no element {name}; it has Elem1 to Elem{shown.mesh.count}.")
    return shown.information(number)


def select(obj, names):
    """Selects elements by name, besides what is selected."""
    for name in names:
        FreeCADGui.Selection.addSelection(obj.Document.Name, obj.Name, name)


def go_to(obj, name):
    """Selects an element alone and shows it from outside in the middle of the view, with some elements around it."""
    info = element(obj, name)
    shown, number = display(obj), element_number(name)
    FreeCADGui.Selection.clearSelection()
    select(obj, [name])
    shown.report(number)
    camera = FreeCADGui.getDocument(obj.Document.Name).ActiveView.getCameraNode()
    point = obj.Placement.multVec(FreeCAD.Vector(*info["centre"]))
    normal = obj.Placement.Rotation.multVec(FreeCAD.Vector(*(float(x) for x in shown.mesh.normals[number])))
    size = max(info["lengths"])
    camera.position = tuple(point + normal * (AWAY * size))
    up = FreeCAD.Vector(0, 0, 1) if abs(normal.z) < 0.9 else FreeCAD.Vector(0, 1, 0)
    camera.pointAt(coin.SbVec3f(*point), coin.SbVec3f(*up))
    camera.focalDistance = AWAY * size
    if hasattr(camera, "height"):
        camera.height = IN_SIGHT * size
