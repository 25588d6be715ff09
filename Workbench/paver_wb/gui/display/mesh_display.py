"""The drawing of one mesh object. Nothing is built before it is shown, and what has changed is built once, when FreeCAD
is back in its event loop."""
import weakref

import FreeCAD
import FreeCADGui
import numpy as np
from pivy import coin
from PySide import QtCore

from paver_wb import core, mesh_object
from paver_wb.base.waves import wavelength_of
from paver_wb.formats import mesh_file
from paver_wb.gui.base.background import Later, Latest
from paver_wb.gui.display import colour_maps, colouring, drawn_mesh, legend, marks, report, view_properties
from paver_wb.gui.display.emphasis import banner, isolation, labels, rings
from paver_wb.gui.display.fields import put, rows_as_indices
from paver_wb.gui.display.panels import CORNERS, MARGIN, TAKEN, ViewPanel, moved
from paver_wb.gui.display.picking import Picker
from paver_wb.gui.display.scene import DIMMED, Scene

CURVED, CURVED_EDGES, EDGES = MODES = ("Curved", "Curved + edges", "Edges only")
WITH_LEGEND = (CURVED, CURVED_EDGES)
OTHER_CORNER, _, REPORT_CORNER, _ = CORNERS  # of the report of an element
MESH, POINTS, PAINT, MARKED, CHOSEN = LAYERS = ("mesh", "points", "paint", "marks", "chosen")  # each needs those before
LAYER_OF = {"Subdivision": POINTS, "ShrinkFactor": POINTS, "AlwaysAllEdges": POINTS, "Isolate": POINTS,
            "IsolatedElements": POINTS, "HiddenFaces": POINTS, "ColourBy": PAINT,
            "ColourMap": PAINT, "ColourRange": PAINT, "RangeLow": PAINT, "RangeHigh": PAINT, "ColourBar": PAINT,
            "Shaded": PAINT, "EdgeColour": PAINT, "Transparency": PAINT,
            "LineWidth": PAINT, "PointSize": PAINT, "PointColor": MARKED, "ShowNodes": MARKED, "LegendCorner": PAINT,
            "ShapeColor": PAINT, "ShapeAppearance": PAINT, "ShowNormals": MARKED,
            "ShowFreeEdges": MARKED, "ShowTriangles": MARKED, "ShowWorst": MARKED, "ElementReport": CHOSEN}
OUTDATED = (0.74, 0.74, 0.74)  # elements of a mesh that is out of date, whatever they would tell
_displays = weakref.WeakSet()
HEAVY = 10000  # elements from which on a mesh is read and cut into triangles on a thread
MOST_TO_HOVER = 100000  # elements: above, a frame for every element that the mouse passes would be too many


class MeshDisplay:
    """mesh: the DrawnMesh, None while nothing is shown; shown: what of it is drawn; path: of its file; selected, hovered:
    elements; reported: that of the report; ringed: places with rings."""

    def __init__(self, vobj):
        self.names = vobj.Object.Document.Name, vobj.Object.Name
        self.mesh, self.tessellation, self.subdivision, self.tree = None, None, 1, None
        self.colouring, self.stale, self.is_waiting = colouring.Colouring(None, None), set(LAYERS), False
        self.selected, self.hovered, self.reported, self.ringed = (), None, None, ()
        self.shown, self.path = isolation.ALL, None
        self.legend_size = 0, 0  # pixels from the left side of the view, and of height
        self.loading = Latest(self.take_loaded, self.complain)
        self.scene, self.picker = Scene(), Picker(self.hits)
        self.make_marks()
        self.bar, self.report_panel, self.banner = ViewPanel(), ViewPanel(REPORT_CORNER), banner.Banner()
        self.modes = {}
        _displays.add(self)
        shared = [self.scene.wires, self.marks, self.picker.node, self.report_panel.switch]
        for name, nodes in ((CURVED, [self.scene.faces, self.bar.switch]),
                            (CURVED_EDGES, [self.scene.faces, self.scene.edges, self.bar.switch]),
                            (EDGES, [self.scene.edges_alone])):
            self.modes[name] = put(coin.SoGroup(), *nodes, *shared)

    def make_marks(self):
        self.triangles = marks.ElementMark(self.scene, marks.TRIANGLE, 1)
        self.worst = marks.ElementMark(self.scene, marks.WORST, is_seen_through=True)
        self.selection = marks.ElementMark(self.scene, marks.selection_colour())
        self.hover = marks.ElementMark(self.scene, marks.hover_colour(), has_faces=False)
        self.free, self.crowded = marks.EdgeMark(marks.FREE), marks.EdgeMark(marks.CROWDED)
        self.normals, self.labels, self.rings = marks.NormalMark(), labels.Labels(), rings.Rings()
        self.nodes = marks.NodeMark()
        self.every_mark = (self.triangles, self.worst, self.selection, self.hover, self.free, self.crowded, self.normals,
                           self.nodes)
        self.marks = put(coin.SoGroup(), *[mark.root for mark in (*self.every_mark, self.labels, self.rings)])

    def attach(self, vobj):
        """Makes the modes known to FreeCAD."""
        culling = vobj.RootNode.getField("renderCulling")
        if culling is not None:
            culling.setValue(coin.SoSeparator.OFF)  # the legend stays where a clipping plane takes the whole mesh away
        for name, node in self.modes.items():
            vobj.addDisplayMode(node, name)
        self.banner.attach(vobj)
        banner.renewals.ask(self.names[0])

    @property
    def obj(self):
        """The mesh object. Looked up each time: FreeCAD crashes at a view object whose document is closed.

        ReferenceError when it is deleted.
        """
        document = FreeCAD.listDocuments().get(self.names[0])
        found = document.getObject(self.names[1]) if document else None
        if found is None or found.ViewObject is None or getattr(found.ViewObject.Proxy, "display", None) is not self:
            raise ReferenceError("The mesh object is deleted.")
        return found

    @property
    def vobj(self):
        return self.obj.ViewObject

    def release(self):
        """Lets go of everything: FreeCAD keeps the view providers of documents that it has opened for ever."""
        _displays.discard(self)
        self.clear()
        self.loading.drop()
        self.__dict__ = {"names": self.names, "stale": set(), "is_waiting": True, "mesh": None, "tessellation": None,
                         "loading": self.loading}

    # ---- what changes

    def changed(self, layer):
        """What the layer shows is no longer so; it is renewed with all that need it when the event loop comes to it."""
        self.stale.update(LAYERS[LAYERS.index(layer):])
        if not self.is_waiting:
            self.is_waiting = True
            QtCore.QTimer.singleShot(0, self.update_later)

    def property_changed(self, name):
        if name in LAYER_OF:
            is_shape = name == "ShowWorst" and self.vobj.Isolate == isolation.WORST
            self.changed(POINTS if is_shape else LAYER_OF[name])
        elif name in ("Visibility", "DisplayMode"):
            if self.stale:
                self.changed(CHOSEN)
            arrangements.ask(self.names[0])
        if name == "Visibility":
            self.reason_changed()

    def status_changed(self):
        """The mesh fits what it was made of no longer, or again."""
        self.changed(PAINT)
        self.reason_changed()

    def reason_changed(self):
        """The banner has another text, or another place."""
        banner.renewals.ask(self.names[0])

    def report(self, element):
        """Shows the report of an element, as long as it is selected."""
        self.reported = element
        self.changed(CHOSEN)

    def ring(self, places):
        """Shows rings around points of the mesh, and takes away those that were there."""
        self.ringed = tuple(places)
        self.changed(CHOSEN)

    def is_pending(self):
        """Whether what is to be shown is not drawn yet."""
        return self.is_waiting or self.loading.thread is not None

    def update_later(self):
        self.is_waiting = False
        try:
            self.renew(self.load_soon)
        except ReferenceError:  # the object is deleted
            pass

    def update(self):
        """Renews what is stale, if the drawing is shown; waits for the mesh where that is being read."""
        self.loading.wait()
        self.renew(self.load)

    def renew(self, load):
        """load: what is to be done for the mesh itself. Without one nothing else is renewed."""
        vobj = self.vobj
        if not self.stale or not vobj.Visibility or vobj.DisplayMode not in MODES:
            return
        stale, self.stale = self.stale, set()
        if MESH in stale:
            load()
        if self.mesh is None:
            return
        for layer, renew in ((POINTS, self.draw), (PAINT, self.paint), (MARKED, self.mark), (CHOSEN, self.choose)):
            if layer in stale:
                renew()

    # ---- layers

    def forget(self):
        self.loading.drop()
        self.mesh, self.tessellation, self.tree = None, None, None
        self.hovered, self.reported, self.ringed = None, None, ()
        obj = self.obj
        if self.path not in (None, obj.MeshFile):  # the numbers mean other elements now
            self.deselect()
            if obj.ViewObject.Isolate == isolation.LISTED:
                obj.ViewObject.Isolate = isolation.EVERYTHING
        self.path = obj.MeshFile

    def deselect(self):
        """The whole mesh is selected in place of its elements."""
        if not self.selected:
            return
        elements, self.selected = self.selected, ()
        document, name = self.obj.Document.Name, self.obj.Name
        for element in elements:
            FreeCADGui.Selection.removeSelection(document, name, report.element_name(element))
        FreeCADGui.Selection.addSelection(document, name)

    def load(self):
        """Reads the mesh from the document, or shows nothing."""
        self.forget()
        try:
            if self.obj.MeshFile:
                self.mesh = drawn_mesh.offered.take(self.obj.MeshFile) or drawn_mesh.DrawnMesh(mesh_object.stored(self.obj))
        except (mesh_file.DamagedMesh, core.CoreMissing) as error:
            self.complain(error)
        if self.mesh is None:
            self.clear()

    def load_soon(self):
        """Like load, but a large mesh is read on a thread, and is shown when that is done."""
        obj, subdivision = self.obj, self.vobj.Subdivision
        path = obj.MeshFile
        if obj.Quads + obj.Triangles < HEAVY or not path or drawn_mesh.offered.has(path) or core.problem():
            self.load()
            return
        self.forget()
        self.clear()
        self.loading.ask(lambda _cancel: drawn_mesh.of_file(path, subdivision))

    def take_loaded(self, drawn):
        self.mesh = drawn
        self.changed(POINTS)

    def complain(self, error):
        FreeCAD.Console.PrintError(f"{self.obj.Label}: {error}\n")

    def clear(self):
        empty = np.zeros((0, 3), np.float32)
        for mark in self.every_mark:
            mark.clear()
        self.labels.show([], [])
        self.rings.show([])
        self.scene.set_points(empty, empty)
        self.scene.set_colours(np.zeros(0, np.uint32))
        self.scene.set_wires(np.zeros((0, 2, 3)))
        for panel in (self.bar, self.report_panel):
            panel.show(None)
        self.colouring = colouring.Colouring(None, None)
        arrangements.ask(self.names[0])

    def draw(self):
        mesh, vobj = self.mesh, self.vobj
        self.subdivision = vobj.Subdivision or mesh.fitting_subdivision()
        self.tessellation, self.tree = mesh.tessellation(self.subdivision), None
        drawn, points, outlines = self.tessellation, self.tessellation.points, self.tessellation.outline_indices
        for mark in (self.triangles, self.worst, self.selection, self.hover):
            mark.clear()
        on_model, triangles = drawn.outline_edges >= 0, drawn.triangle_indices
        self.shown = isolation.of_view(mesh, vobj, self.worst_elements)
        elements = self.shown.elements
        if elements is not None:
            triangles = triangles.reshape(-1, 4)[elements[drawn.triangle_elements]].ravel()
            outlines = mesh.element_outlines(np.flatnonzero(elements), self.subdivision)
            on_model &= elements[self.outline_owners()]
        if vobj.ShrinkFactor < 1:
            points = mesh.shrunk(points, vobj.ShrinkFactor, self.subdivision)
            every = np.arange(mesh.count) if elements is None else np.flatnonzero(elements)
            outlines, on_model = mesh.element_outlines(every, self.subdivision), np.zeros_like(on_model)
        self.scene.set_points(points, drawn.normals)
        self.scene.set_indices(triangles, outlines, rows_as_indices(drawn.outlines[on_model]))
        self.scene.set_wires(mesh.wire_lines[:0] if self.shown.is_part else mesh.wire_lines)
        low, high = mesh.extent
        self.scene.edge_density.set_mesh(low, high, 0 if vobj.AlwaysAllEdges else mesh.mean_area)
        for panel in (self.bar, self.report_panel):
            panel.stand_in((low + high) / 2, float(np.linalg.norm(high - low)) or 1.0)

    def outline_owners(self):
        """(outlines,) an element that has each outline of the tessellation."""
        return self.mesh.per_point(np.arange(self.mesh.count), self.subdivision)[self.tessellation.outlines[:, 0]]

    def paint(self):
        vobj = self.vobj
        self.scene.set_shaded(vobj.Shaded)
        is_outdated = self.obj.Status == mesh_object.OUT_OF_DATE
        wish = view_properties.wish(vobj)
        self.colouring = colouring.of_mesh(self.mesh, wish._replace(by=colouring.NONE) if is_outdated else wish)
        colours = self.colouring.colours
        if colours is None:
            colours = colour_maps.packed(np.array([OUTDATED if is_outdated else view_properties.shape_colour(vobj)]))
        if vobj.Shaded:
            colours = colour_maps.dimmed(colours, DIMMED)
        opacity, line_width, point_size = view_properties.look(vobj)
        colours = colour_maps.seen_through(colours, opacity)
        self.scene.set_look(opacity, line_width, point_size)
        self.scene.set_edge_colour(vobj.EdgeColour, colours)
        if self.colouring.colours is None:
            self.scene.set_one_colour(colours[0])
        else:
            self.scene.set_colours(self.mesh.per_point(colours, self.subdivision))
        arrange(self.names[0])

    def has_legend(self):
        """Whether the view shows one."""
        vobj = self.vobj
        is_drawn = self.shown.elements is None or self.shown.elements.any()
        return bool(vobj.ColourBar and self.colouring.legend is not None and self.mesh and self.mesh.count and is_drawn
                    and vobj.Visibility and vobj.DisplayMode in WITH_LEGEND)

    def show_legend(self, label, along):
        """In its corner, at least `along` pixels from the side; label: empty where there is no other. Gives where it ends."""
        image, corner = legend.picture(self.colouring.legend, label), self.vobj.LegendCorner
        along = max(along, TAKEN.get(corner, 0))
        self.bar.stand_at(corner)
        self.bar.show(moved(image, corner, along))
        end = along + image.width() - MARGIN
        self.legend_size = (end, image.height()) if corner.endswith("left") else (0, 0)
        return end

    def mark(self):
        mesh, vobj, drawn = self.mesh, self.vobj, self.tessellation
        worst = self.drawn_of(self.worst_elements(vobj.ShowWorst))
        self.mark_elements(self.worst, worst)
        self.labels.show(mesh.centres[worst] if len(worst) else (), [f"{i + 1}: {mesh.quality.sj[e]:.2f}" for i, e in enumerate(worst)])
        is_marked = vobj.ShowTriangles
        self.mark_elements(self.triangles, np.arange(mesh.quad_count, mesh.count) if is_marked else ())
        is_drawn = True if self.shown.edges is None else self.shown.edges[self.outline_owners()]
        for mark, wanted in ((self.free, drawn.outline_elements == 1), (self.crowded, drawn.outline_elements > 2)):
            if vobj.ShowFreeEdges or vobj.Isolate == isolation.FREE:
                mark.show(drawn.points, drawn.outlines[wanted & is_drawn])
            else:
                mark.clear()
        if vobj.ShowNodes:
            self.nodes.show(np.asarray(mesh.stored.nodes), view_properties.point_colour(vobj), view_properties.look(vobj)[2])
        else:
            self.nodes.clear()
        if vobj.ShowNormals:
            self.normals.show(mesh, self.shown.elements)
        else:
            self.normals.clear()

    def drawn_of(self, elements):
        """Those of some elements that are not hidden."""
        elements = np.asarray(elements, np.int64)
        return elements if self.shown.elements is None else elements[self.shown.elements[elements]]

    def mark_elements(self, mark, elements):
        mark.show(self.mesh, self.tessellation, self.subdivision, self.drawn_of(elements))

    def choose(self):
        """What depends on the selection and the mouse."""
        count = self.mesh.count
        self.selection.set_colour(marks.selection_colour())
        self.mark_elements(self.selection, [e for e in self.selected if e < count])
        self.mark_elements(self.hover, [] if self.hovered is None or count > MOST_TO_HOVER else [self.hovered])
        is_shown = self.vobj.ElementReport and self.reported is not None and self.reported in self.drawn_of(
            [e for e in self.selected if e < count])
        image = legend.picture_of_report(report.rows(self.information(self.reported))) if is_shown else None
        corner = OTHER_CORNER if self.vobj.LegendCorner == REPORT_CORNER else REPORT_CORNER
        self.report_panel.stand_at(corner)
        if image is not None and self.legend_size[1] + image.height() > view_height(self.names[0]):
            image = moved(image, corner, self.legend_size[0])  # beside the legend, as there is no room above or below it
        self.report_panel.show(image)
        self.rings.show(self.ringed)

    # ---- questions

    def worst_elements(self, count):
        """Numbers of the elements with the least scaled Jacobian, worst first."""
        values = self.mesh.quality.sj
        count = min(count, len(values))
        few = np.argpartition(values, count - 1)[:count] if 0 < count < len(values) else np.arange(len(values))[:count]
        return few[np.lexsort((few, values[few]))]

    def hits(self, origin, direction):
        """[(element, point)] under a ray in the coordinates of the mesh, nearest first, of those that are drawn."""
        if self.tessellation is None:
            return []
        if self.tree is None:
            self.tree = core.load().PickTree(self.tessellation)
        elements, shown = self.tessellation.triangle_elements, self.shown.elements
        return [(int(elements[triangle]), [o + along * d for o, d in zip(origin, direction)])
                for triangle, along in self.tree.hits(origin, direction) if shown is None or shown[elements[triangle]]]

    def information(self, element):
        """Figures of an element as a dict."""
        return report.information(self.mesh, element, wavelength_of(self.obj))


def view_height(document):
    """Of the view of a document, pixels; endless where it is none that shows meshes."""
    view = FreeCADGui.getDocument(document).ActiveView
    return view.getSize()[1] if hasattr(view, "getSize") else float("inf")


def arrange(document):
    """Puts the legends of a document's meshes side by side, with the names of these where there are several."""
    shown = []
    for display in _displays:
        try:
            if display.names[0] == document and display.mesh is not None:
                if display.has_legend():
                    shown.append((display.obj.ID, display))
                else:
                    display.bar.show(None)
                    display.legend_size = 0, 0
        except ReferenceError:  # deleted
            continue
    ends = {}  # {side of the view: where the next one begins}
    for _, display in sorted(shown, key=lambda entry: entry[0]):
        side, label = display.vobj.LegendCorner.split()[1], display.obj.Label if len(shown) > 1 else ""
        ends[side] = display.show_legend(label, ends.get(side, 0))


arrangements = Later(lambda document: arrange(document.Name))


class Closing:
    """Follows FreeCAD's documents."""

    def slotDeletedObject(self, obj):
        if mesh_object.is_mesh(obj):
            arrangements.ask(obj.Document.Name)
            banner.renewals.ask(obj.Document.Name)  # others move up

    def slotChangedObject(self, obj, name):
        if name == "Label" and mesh_object.is_mesh(obj):
            arrangements.ask(obj.Document.Name)

    def slotDeletedDocument(self, document):
        for display in [one for one in _displays if one.names[0] == document.Name]:
            display.release()


FreeCAD.addDocumentObserver(Closing())
