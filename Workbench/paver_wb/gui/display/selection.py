"""Follows FreeCAD's selection: highlights elements, says what lies under the mouse, reports what is clicked."""
import FreeCAD
import FreeCADGui
from PySide import QtCore

from paver_wb import mesh_object
from paver_wb.base import proxies
from paver_wb.children.references import grouped, standing, without_features
from paver_wb.gui.display import mesh_display, report

STATUS_TIME = 8000  # ms


def display_of(obj):
    """The MeshDisplay of a mesh object, None for anything else."""
    return getattr(obj.ViewObject.Proxy, "display", None) if mesh_object.is_mesh(obj) else None


def place_of(document, name, path):
    """(mesh object, element) of what FreeCAD names by an object and a path inside of it; (None, None) otherwise."""
    document = FreeCAD.listDocuments().get(document)
    top = document.getObject(name) if document else None
    if top is None:
        return None, None
    chain = top.getSubObjectList(path) if "." in path else [top]
    last = chain[-1] if chain else top
    if not mesh_object.is_mesh(last):
        return None, None
    return last, report.element_number(path.rsplit(".", 1)[-1])


def selected_elements(document):
    """{mesh object: elements} of FreeCAD's selection in a document."""
    found = {}
    for part in FreeCADGui.Selection.getSelectionEx(document):
        if mesh_object.is_mesh(part.Object):
            numbers = [report.element_number(name.rsplit(".", 1)[-1]) for name in part.SubElementNames]
            found.setdefault(part.Object, []).extend(n for n in numbers if n is not None)
    return found


def selected_places(document=""):
    """[(object, path in it)] of what is selected of models, where it was clicked; in a document, else in the active one."""
    places = [standing(part.Object, path) for part in FreeCADGui.Selection.getSelectionEx(document, 0)
              for path in part.SubElementNames or ("",)]
    return [(thing, path) for thing, path in places if not proxies.is_own(thing)]


def selected_parts():
    """Objects that may be meshed, each once."""
    return list(dict.fromkeys(thing for thing, _ in selected_places()))


def may_refine():
    """Whether anything that refinements refer to is selected."""
    return any(selected_elements(FreeCAD.ActiveDocument.Name).values()) or bool(selected_places())


def selected_references(document=""):
    """[(object, elements)] of the same, without features of Bodies."""
    return grouped([(thing, without_features(thing, path)) for thing, path in selected_places(document)])


def references():
    """[(object, elements)] of what is selected in the 3D view and may be refined; elements of a mesh stand for the faces that
    they lie on. ValueError as from mesh_object.faces_under."""
    found = selected_references()
    for mesh, elements in selected_elements(FreeCAD.ActiveDocument.Name).items():
        found += mesh_object.faces_under(mesh, elements) if elements else []
    return found


class Observer:
    """What FreeCAD calls. The highlight is renewed once, however many elements are selected at a time."""

    def __init__(self):
        self.is_waiting = False

    def later(self):
        if not self.is_waiting:
            self.is_waiting = True
            QtCore.QTimer.singleShot(0, self.renew)

    def renew(self):
        self.is_waiting = False
        for document in FreeCAD.listDocuments().values():
            found = selected_elements(document.Name)
            for obj in mesh_object.meshes_of(document):
                display = display_of(obj)
                elements = tuple(found.get(obj, ()))
                if display and elements != display.selected:
                    display.selected = elements
                    display.changed(mesh_display.CHOSEN)

    def addSelection(self, document, name, path, point):
        self.later()
        obj, element = place_of(document, name, path)
        if element is None or tuple(point) == (0, 0, 0):  # the point of what no mouse has selected
            return
        display = display_of(obj)
        if display and display.mesh and element < display.mesh.count:
            display.report(element)
            lines = report.rows(display.information(element))
            FreeCAD.Console.PrintMessage("".join(f"{name}: {text}\n" if text else f"{obj.Label}, {name}\n"
                                                 for name, text in lines))

    def removeSelection(self, *_):
        self.later()

    setSelection = clearSelection = removeSelection

    def setPreselection(self, document, name, path):
        obj, element = place_of(document, name, path)
        display = display_of(obj) if element is not None else None
        if display is None or display.mesh is None or element >= display.mesh.count:
            return
        self.hover(display, element)
        text = f"{obj.Label}: {report.line(display.information(element))}"
        # FreeCAD writes its own text after this call.
        QtCore.QTimer.singleShot(0, lambda: FreeCADGui.getMainWindow().statusBar().showMessage(text, STATUS_TIME))

    def removePreselection(self, document, name, path):
        obj, _ = place_of(document, name, path)
        if obj is not None and display_of(obj):
            self.hover(display_of(obj), None)

    def hover(self, display, element):
        if display.hovered != element:
            display.hovered = element
            display.changed(mesh_display.CHOSEN)


OBSERVER = Observer()
FreeCADGui.Selection.addObserver(OBSERVER)
