"""Draws a model_look.Look: target lengths in colours on the faces; the rest over the 3D view, seen through the model."""
import FreeCADGui
import numpy as np
from pivy import coin

from paver_wb.gui.display import colour_maps
from paver_wb.gui.display.fields import colour_node, fill, fill_rows, line_style, node, put, separator, unlit, unpickable
from paver_wb.gui.display.scene import both_sides

NAME = "PaverPreview"
CONTACT, SMALL = (0.05, 0.55, 0.95), (0.95, 0.35, 0.0)
MAP = "Viridis"  # dark: short
LINE_WIDTH, MARK_SIZE, TRANSPARENCY = 3, 9, 0.55


def rows_of(kind, points):
    """(points, a node of the class `kind`) of (n, k, 3) points of each line or face."""
    vertices, made = coin.SoCoordinate3(), kind()
    fill_rows(made.coordIndex, vertices.point, points)
    return vertices, made


def lines_of(points):
    """A node of (n, k, 3) points along each line."""
    return put(coin.SoGroup(), *rows_of(coin.SoIndexedLineSet, points))


def marks_of(points):
    vertices, marks = coin.SoCoordinate3(), coin.SoPointSet()
    fill(vertices.point, points)
    return put(coin.SoGroup(), vertices, marks)


def triangles_of(corners):
    material = node(coin.SoMaterial, diffuseColor=CONTACT, transparency=TRANSPARENCY)
    return separator(both_sides(), material, *rows_of(coin.SoIndexedFaceSet, corners))


def size_colours(lengths, target):
    """(n, 3) colours of lengths: equal factors are equal steps, up to the target length."""
    low = min(float(lengths.min(initial=target)), target * (1 - 1e-6))
    share = np.log(np.maximum(lengths, low) / low) / np.log(target / low)
    return colour_maps.table(MAP)[(np.clip(share, 0, 1) * (colour_maps.SIZE - 1)).astype(int)]


def sizes_of(triangles, lengths, target):
    """A node of the faces in colours of their target lengths, on top of what is drawn there."""
    colours, nearer = coin.SoPackedColor(), node(coin.SoPolygonOffset, factor=-1, units=-1)
    fill(colours.orderedRGBA, colour_maps.packed(size_colours(lengths.ravel(), target)))
    return separator(unpickable(), unlit(), both_sides(), nearer, colours,
                     node(coin.SoMaterialBinding, value=coin.SoMaterialBinding.PER_VERTEX_INDEXED),
                     *rows_of(coin.SoIndexedFaceSet, triangles))


def node_of(look):
    """The Coin node of a Look."""
    made = separator()
    made.setName(NAME)
    if len(look.size_triangles):
        put(made, sizes_of(look.size_triangles, look.size_lengths, look.target))
    return put(made, over_all(look))


def over_all(look):
    """What is seen through the model. Lines and marks come after the faces, which they lie on."""
    made = put(coin.SoAnnotation(), unpickable(), unlit())
    for points, make, colour in ((look.contact_triangles, triangles_of, CONTACT), (look.contact_lines, lines_of, CONTACT),
                                 (look.contact_points, marks_of, CONTACT), (look.small_lines, lines_of, SMALL),
                                 (look.small_places, marks_of, SMALL)):
        if len(points):
            put(made, separator(colour_node(colour), line_style(LINE_WIDTH, pointSize=MARK_SIZE), make(points)))
    return made


class Drawing:
    """What is drawn over the views of a document; nothing at first."""

    def __init__(self, document):
        self.document, self.shown = document, []  # [(scene of a view, node)]

    def show(self, look):
        self.clear()
        for view in FreeCADGui.getDocument(self.document).mdiViewsOfType("Gui::View3DInventor"):
            scene, made = view.getSceneGraph(), node_of(look)
            scene.addChild(made)
            self.shown.append((scene, made))

    def clear(self):
        for scene, made in self.shown:
            if scene.findChild(made) >= 0:
                scene.removeChild(made)
        self.shown = []
