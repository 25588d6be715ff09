"""What is marked of a mesh: elements, free edges, normals. All lie over the drawing and none is picked."""
import FreeCAD
import numpy as np
from pivy import coin

from paver_wb.gui.display import colour_maps
from paver_wb.gui.display.fields import (colour_node, fill, fill_rows, line_style, node, own_indices, put, separator, unlit,
                                         unpickable)
from paver_wb.gui.display.scene import both_sides, by_index

FREE, CROWDED = (0.95, 0.05, 0.25), (0.60, 0.10, 0.85)  # mesh edges of one element, of more than two
WORST, TRIANGLE = (0.90, 0.05, 0.55), (0.20, 0.35, 0.95)
NORMAL_ROOT, NORMAL_TIP = (0.05, 0.15, 0.55), (0.15, 0.75, 0.95)
NORMAL_LENGTH = 0.6  # of an element's longest edge
VIEW = "User parameter:BaseApp/Preferences/View"


def user_colour(name, otherwise):
    """A colour of FreeCAD's preferences."""
    value = FreeCAD.ParamGet(VIEW).GetUnsigned(name, otherwise)
    return tuple((value >> shift & 255) / 255 for shift in (24, 16, 8))


def selection_colour():
    return user_colour("SelectionColor", 0x1CAD1CFF)


def hover_colour():
    return user_colour("HighlightColor", 0xE1E114FF)


class Mark:
    """Something that is shown or not; Coin draws another frame for every value that is set."""

    count = 0  # of what is shown

    def clear(self):
        if self.count:
            self.empty()


class ElementMark(Mark):
    """Some elements in a colour of their own, with thick outlines; without faces only these. Those that are seen through
    the model have thin outlines where something hides them."""

    def __init__(self, scene, colour, width=3, has_faces=True, is_seen_through=False):
        self.scene, self.face_set, self.lines = scene, coin.SoIndexedFaceSet(), coin.SoIndexedLineSet()
        self.material, self.line_colour, self.elements = coin.SoMaterial(), colour_node(colour), ()
        self.colour = None
        self.root = separator(unpickable(), scene.points)
        if has_faces:
            put(self.root, separator(both_sides(), self.material, scene.normals, by_index(), self.face_set))
        put(self.root, separator(unlit(), self.line_colour, line_style(width), self.lines))
        if is_seen_through:
            put(self.root, put(coin.SoAnnotation(), unlit(), self.line_colour, line_style(1), self.lines))
        self.set_colour(colour)
        self.empty()

    def set_colour(self, colour):
        if colour == self.colour:
            return
        self.colour = colour
        self.material.diffuseColor = colour
        self.material.emissiveColor = tuple(0.35 * x for x in colour)
        self.line_colour.rgb = tuple(0.75 * x for x in colour)

    def show(self, mesh, tessellation, subdivision, elements):
        """elements: numbers in a DrawnMesh; none to show nothing."""
        if not len(elements):
            return self.clear()
        self.elements, self.count = tuple(int(e) for e in elements), len(elements)
        rows = mesh.triangle_rows(self.elements, subdivision)
        fill(self.face_set.coordIndex, tessellation.triangle_indices.reshape(-1, 4)[rows])
        fill(self.lines.coordIndex, mesh.element_outlines(self.elements, subdivision))

    def empty(self):
        self.elements, self.count = (), 0
        for field in (self.face_set.coordIndex, self.lines.coordIndex):
            fill(field, np.zeros(0, np.int32))


class EdgeMark(Mark):
    """Mesh edges in a colour of their own, with points of their own: shrunk elements leave them where they are."""

    def __init__(self, colour):
        self.points, self.lines = coin.SoCoordinate3(), coin.SoIndexedLineSet()
        self.root = separator(unpickable(), unlit(), colour_node(colour), line_style(4), self.points, self.lines)
        self.empty()

    def show(self, points, outlines):
        """outlines: (edges, n + 1) rows of points."""
        self.count = len(outlines)
        used, rows = np.unique(outlines, return_inverse=True)
        fill_rows(self.lines.coordIndex, self.points.point, points[used], rows.reshape(outlines.shape))

    def empty(self):
        self.show(np.zeros((0, 3), np.float32), np.zeros((0, 2), np.int64))


class NodeMark(Mark):
    """The nodes as points."""

    def __init__(self):
        self.points, self.dots, self.style = coin.SoCoordinate3(), coin.SoPointSet(), coin.SoDrawStyle()
        self.colour = colour_node((0, 0, 0))
        self.root = separator(unpickable(), unlit(), self.colour, self.style, self.points, self.dots)
        self.empty()

    def show(self, nodes, colour, size):
        self.count = len(nodes)
        self.colour.rgb, self.style.pointSize = colour, size
        self.dots.numPoints = 0
        fill(self.points.point, nodes)
        self.dots.numPoints = self.count

    def empty(self):
        self.show(np.zeros((0, 3), np.float32), (0, 0, 0), 1)


class NormalMark(Mark):
    """A line along the normal of every element, brighter towards its end."""

    def __init__(self):
        self.vertices = node(coin.SoVertexProperty, materialBinding=coin.SoVertexProperty.PER_VERTEX_INDEXED)
        self.lines = node(coin.SoIndexedLineSet, vertexProperty=self.vertices)
        self.root = separator(unpickable(), unlit(), line_style(2), self.lines)
        self.empty()

    def show(self, mesh, shown=None):
        """shown: (elements,) which ones, None for all."""
        ends = mesh.centres + NORMAL_LENGTH * mesh.longest_edges[:, None] * mesh.normals
        pairs = np.stack([mesh.centres, ends], axis=1)
        self.put(pairs if shown is None else pairs[shown])

    def put(self, pairs):
        self.count = len(pairs)
        fill(self.lines.coordIndex, np.zeros(0, np.int32))
        fill(self.vertices.vertex, pairs.reshape(-1, 3))
        fill(self.vertices.orderedRGBA, np.tile(colour_maps.packed(np.array([NORMAL_ROOT, NORMAL_TIP])), self.count))
        fill(self.lines.coordIndex, own_indices((self.count, 2)))

    def empty(self):
        self.put(np.zeros((0, 2, 3)))
