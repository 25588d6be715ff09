"""What commands and scripts call to look at a mesh. Each takes a mesh object; what it sets are properties of its view."""
import FreeCAD
import FreeCADGui
import numpy as np
from pivy import coin

from paver_wb import mesh_object
from paver_wb.gui.display import colouring, mesh_display
from paver_wb.gui.display.emphasis import isolation
from paver_wb.gui.display.report import element_name, element_number
from paver_wb.gui.display.selection import display_of, selected_elements, selected_references

AWAY, IN_SIGHT = 15, 10  # distance and height of a camera that shows one element, in lengths of its edges
AROUND = 3  # height of a camera that shows several elements, in radii of the sphere about them
ONE_WAY = 0.5  # length of the mean of their normals from which on they face one way


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
    shown = display(obj)
    return shown.information(*numbers_of(obj, shown, [name]))


def select(obj, names):
    """Selects elements by name, besides what is selected."""
    for name in names:
        FreeCADGui.Selection.addSelection(obj.Document.Name, obj.Name, name)


def go_to(obj, name):
    """Selects an element alone, with a ring, and shows it from outside in the middle of the view, with some elements around."""
    shown = display(obj)
    number, = numbers_of(obj, shown, [name])
    FreeCADGui.Selection.clearSelection()
    select(obj, [name])
    shown.report(number)
    look_at(obj, [name])
    shown.ring(shown.mesh.centres[[number]])


def look_at(obj, names):
    """Moves the camera to elements: from outside where they face one way, else from where it is. Hidden ones are shown."""
    shown = display(obj)
    numbers = np.array(numbers_of(obj, shown, names))
    if shown.shown.elements is not None and not shown.shown.elements[numbers].all():
        show_everything(obj)
    mesh = shown.mesh
    corners = mesh.corners[numbers]
    points = mesh.stored.nodes[np.unique(corners[corners >= 0])]
    centre = (points.min(axis=0) + points.max(axis=0)) / 2
    radius = float(np.linalg.norm(points - centre, axis=1).max())
    mean = mesh.normals[numbers].mean(axis=0)
    if len(numbers) == 1:
        centre = mesh.centres[numbers[0]]
    size = max(float(mesh.longest_edges[numbers].max()), AROUND * radius / IN_SIGHT if len(numbers) > 1 else 0.0)
    aim(obj, centre, size, mean if np.linalg.norm(mean) > ONE_WAY else None)


def look_at_place(obj, place):
    """Moves the camera to a point of the mesh, and puts a ring there; some elements around it are in sight."""
    shown = display(obj)
    mesh = shown.mesh
    size = float(np.mean(mesh.longest_edges)) if mesh.count else 1.0
    aim(obj, place, size)
    shown.ring([place])


def aim(obj, centre, size, normal=None):
    """Points the camera at a place of the mesh; size: of a typical element there. normal: of the side it is seen from; None:
    from where the camera looks now."""
    camera = FreeCADGui.getDocument(obj.Document.Name).ActiveView.getCameraNode()
    point = FreeCAD.Vector(*(float(x) for x in centre))
    if normal is None:
        direction = camera.orientation.getValue().multVec(coin.SbVec3f(0, 0, 1)).getValue()
        camera.position = tuple(point + FreeCAD.Vector(*direction) * (AWAY * size))
    else:
        normal = FreeCAD.Vector(*(float(x) for x in normal)).normalize()
        camera.position = tuple(point + normal * (AWAY * size))
        up = FreeCAD.Vector(0, 0, 1) if abs(normal.z) < 0.9 else FreeCAD.Vector(0, 1, 0)
        camera.pointAt(coin.SbVec3f(*point), coin.SbVec3f(*up))
    camera.focalDistance = AWAY * size
    if hasattr(camera, "height"):
        camera.height = IN_SIGHT * size


def numbers_of(obj, shown, names):
    """Numbers from 0 of elements by name. ValueError for one that is not there."""
    found = [element_number(name) for name in names]
    for name, number in zip(names, found):
        if number is None or number >= shown.mesh.count:
            raise ValueError(f"'{obj.Label}' has no element {name}; it has Elem1 to Elem{shown.mesh.count}.")
    return found


def ring(obj, names=()):
    """Puts rings around elements; without any, takes all away."""
    shown = display(obj)
    shown.ring(shown.mesh.centres[numbers_of(obj, shown, names)] if names else ())


# ---- parts of the mesh alone


def isolate(obj, names):
    """Shows only these elements, "Elem17"."""
    obj.ViewObject.IsolatedElements = [number + 1 for number in numbers_of(obj, display(obj), names)]
    obj.ViewObject.Isolate = isolation.LISTED


def isolate_worst(obj, count=isolation.FEW_WORST):
    """Shows only the elements with the least scaled Jacobian, marked; gives their names, worst first."""
    names = show_worst(obj, count)
    obj.ViewObject.Isolate = isolation.WORST
    return names


def isolate_free_edges(obj):
    """Shows only the mesh edges with other than two elements. ValueError where there are none."""
    if not (display(obj).tessellation.outline_elements != 2).any():
        raise ValueError(f"The mesh of '{obj.Label}' has no free edges, and none with more than two elements.")
    obj.ViewObject.Isolate = isolation.FREE


def hide(obj, names):
    """Hides the elements of faces and objects, besides those that are hidden: "Face3", "Box/Face3", "Box"."""
    known(obj, names)
    obj.ViewObject.HiddenFaces = sorted({*obj.ViewObject.HiddenFaces, *names})


def show_only(obj, names):
    """Shows only the elements of these faces and objects."""
    labels, mesh = known(obj, names), display(obj).mesh
    with_elements = [labels[number] for number in np.unique(mesh.faces)]
    obj.ViewObject.HiddenFaces = [label for label in with_elements if not isolation.is_named(label, set(names))]
    obj.ViewObject.Isolate = isolation.EVERYTHING


def known(obj, names):
    """Names of all faces of a mesh. ValueError where none has one of `names`."""
    labels = display(obj).mesh.face_names
    for name in names:
        if not any(isolation.is_of(label, name) for label in labels):
            raise ValueError(f"The mesh of '{obj.Label}' has no face or object {name}; its first face is {labels[0]}.")
    return labels


def show_everything(obj):
    """Hides nothing any longer."""
    display(obj)
    obj.ViewObject.Isolate, obj.ViewObject.HiddenFaces = isolation.EVERYTHING, []
    display(obj)


def faces_of_selection(obj):
    """Names of the faces and objects of a mesh that are selected: by its elements, or in the objects it was made of."""
    shown, names, things = display(obj), [], mesh_object.sources(obj)
    names += [shown.mesh.face_names[shown.mesh.faces[n]] for n in selected_elements(obj.Document.Name).get(obj, ())
              if n < shown.mesh.count]
    for thing, elements in selected_references(obj.Document.Name):
        faces = [element for element in elements if element.startswith("Face")]
        if thing in things and len(things) == 1:
            names += faces
        elif thing in things:
            names += [f"{thing.Label}/{face}" for face in faces] or [thing.Label]
    return list(dict.fromkeys(names))


def elements_of_selection(obj):
    """Names of the elements of a mesh that are selected."""
    return [element_name(number) for number in selected_elements(obj.Document.Name).get(obj, ())]
