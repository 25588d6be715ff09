"""Draws a model_look.Look: target lengths in colours on the faces; the rest over the 3D view, seen through the model."""
import FreeCADGui
import numpy as np
from pivy import coin

from paver_wb.gui.display import colour_maps
from paver_wb.gui.display.fields import (COLOURS, FLOATS, INTEGERS, colour_node, fill, line_style, put, separator, unlit,
                                         unpickable)
from paver_wb.gui.display.scene import both_sides, rows_as_indices

NAME = "PaverPreview"
CONTACT, SMALL = (0.05, 0.55, 0.95), (0.95, 0.35, 0.0)
MAP = "Viridis"  # dark: short
LINE_WIDTH, MARK_SIZE, TRANSPARENCY = 3, 9, 0.55


def lines_of(points):
    """A node of (n, k, 3) points along each line."""
    vertices, lines = coin.SoCoordinate3(), coin.SoIndexedLineSet()
    fill(vertices.point, points.reshape(-1, 3), FLOATS)
    fill(lines.coordIndex, rows_as_indices(np.arange(points[..., 0].size).reshape(points.shape[:2])), INTEGERS)
    return put(coin.SoGroup(), vertices, lines)


def marks_of(points):
    vertices, marks = coin.SoCoordinate3(), coin.SoPointSet()
    fill(vertices.point, points, FLOATS)
    return put(coin.SoGroup(), vertices, marks)


def triangles_of(corners):
    vertices, faces, material = coin.SoCoordinate3(), coin.SoIndexedFaceSet(), coin.SoMaterial()
    material.diffuseColor = CONTACT
    material.transparency = TRANSPARENCY
    fill(vertices.point, corners.reshape(-1, 3), FLOATS)
    fill(faces.coordIndex, rows_as_indices(np.arange(3 * len(corners)).reshape(-1, 3)), INTEGERS)
    return separator(both_sides(), material, vertices, faces)


def size_colours(lengths, target):
    """(n, 3) colours of lengths: equal factors are equal steps, up to the target length."""
    low = min(float(lengths.min(initial=target)), target * (1 - 1e-6))
    share = np.log(np.maximum(lengths, low) / low) / np.log(target / low)
    return colour_maps.table(MAP)[(np.clip(share, 0, 1) * (colour_maps.SIZE - 1)).astype(int)]


def sizes_of(triangles, lengths, target):
    """A node of the faces in colours of their target lengths, on top of what is drawn there."""
    vertices, colours, binding = coin.SoCoordinate3(), coin.SoPackedColor(), coin.SoMaterialBinding()
    faces, nearer = coin.SoIndexedFaceSet(), coin.SoPolygonOffset()
    nearer.factor, nearer.units = -1, -1
    binding.value = coin.SoMaterialBinding.PER_VERTEX_INDEXED
    fill(vertices.point, triangles.reshape(-1, 3), FLOATS)
    fill(colours.orderedRGBA, colour_maps.packed(size_colours(lengths.ravel(), target)), COLOURS)
    fill(faces.coordIndex, rows_as_indices(np.arange(3 * len(triangles)).reshape(-1, 3)), INTEGERS)
    return separator(unpickable(), unlit(), both_sides(), nearer, colours, binding, vertices, faces)


def node_of(look):
    """The Coin node of a Look."""
    node = coin.SoSeparator()
    node.setName(NAME)
    if len(look.size_triangles):
        put(node, sizes_of(look.size_triangles, look.size_lengths, look.target))
    return put(node, over_all(look))


def over_all(look):
    """What is seen through the model. Lines and marks come after the faces, which they lie on."""
    node = put(coin.SoAnnotation(), unpickable(), unlit())
    for points, make, colour in ((look.contact_triangles, triangles_of, CONTACT), (look.contact_lines, lines_of, CONTACT),
                                 (look.contact_points, marks_of, CONTACT), (look.small_lines, lines_of, SMALL),
                                 (look.small_places, marks_of, SMALL)):
        if len(points):
            put(node, separator(colour_node(colour), line_style(LINE_WIDTH, MARK_SIZE), make(points)))
    return node


class Drawing:
    """What is drawn over the views of a document; nothing at first."""

    def __init__(self, document):
        self.document, self.shown = document, []  # [(scene of a view, node)]

    def show(self, look):
        self.clear()
        for view in FreeCADGui.getDocument(self.document).mdiViewsOfType("Gui::View3DInventor"):
            scene, node = view.getSceneGraph(), node_of(look)
            scene.addChild(node)
            self.shown.append((scene, node))

    def clear(self):
        for scene, node in self.shown:
            if scene.findChild(node) >= 0:
                scene.removeChild(node)
        self.shown = []
