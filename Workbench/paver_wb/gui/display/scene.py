"""Coin nodes of a mesh: faces with true normals and a colour per element, element edges, edges of the model, wires."""
import numpy as np
from pivy import coin

from paver_wb.gui.display.edge_density import EdgeDensity
from paver_wb.gui.display.fields import colour_node, fill, fill_rows, node, put, separator, unlit, unpickable

# Of FreeCAD's LineWidth: edges of elements, of the model, wires; of its PointSize: ends of lines of wires.
EDGE_WIDTH, MODEL_EDGE_WIDTH, WIRE_WIDTH, WIRE_NODE = 0.5, 1, 1.5, 1.4
DIMMED = 0.85  # colours where they are lit, as all lights together are brighter than one
FILL_DIRECTIONS, FILL_INTENSITY = ((0.3, 0.2, -1), (-0.3, -0.2, 1), (1, -0.6, 0), (-1, 0.6, 0)), 0.16
FAINT = 0.55  # of the elements' colour in edges that lie close together


class Scene:
    """`faces`, `edges`, or `edges_alone`, which do not fade, and `wires` are the groups to put into display modes; `points`
    and `normals` serve the marks too.

    Coin sends arrays straight to the graphics card only where points, normals and colours have the same indices: so
    elements share no points, and each point has the colour of its element.
    """

    def __init__(self):
        self.points, self.normals, self.packed = coin.SoCoordinate3(), coin.SoNormal(), coin.SoPackedColor()
        self.light, self.binding, self.face_set = coin.SoLightModel(), coin.SoMaterialBinding(), coin.SoIndexedFaceSet()
        self.faces = separator(unpickable(), *fill_lights(), both_sides(), self.light, soft_material(), self.packed,
                               self.binding, coin.SoPolygonOffset(), self.points, self.normals, by_index(), self.face_set)
        self.edge_colour, self.faint_colour = colour_node((0, 0, 0)), colour_node((0.5, 0.5, 0.5))
        self.lines, self.model_lines = coin.SoIndexedLineSet(), coin.SoIndexedLineSet()
        self.edge_density = EdgeDensity(put(coin.SoGroup(), self.edge_colour, self.lines),
                                        put(coin.SoGroup(), self.faint_colour, self.lines))
        self.edge_style, self.model_edge_style, self.wire_style = (coin.SoDrawStyle() for _ in range(3))
        self.veil = coin.SoMaterial()  # of edges that have no faces between them
        self.edges = separator(unpickable(), unlit(), self.edge_colour, self.points,
                               separator(self.edge_style, *self.edge_density.nodes),
                               self.model_edge_style, self.model_lines)
        self.edges_alone = separator(unpickable(), unlit(), self.veil, self.edge_colour, self.points,
                                     separator(self.edge_style, self.lines), self.model_edge_style, self.model_lines)

        self.wire_points, self.wire_nodes = coin.SoCoordinate3(), coin.SoCoordinate3()
        self.wire_lines, self.wire_dots = coin.SoIndexedLineSet(), coin.SoPointSet()
        self.wires = separator(unpickable(), unlit(), self.edge_colour, self.wire_style, self.wire_points,
                               self.wire_lines, self.wire_nodes, self.wire_dots)
        self.set_wires(np.zeros((0, 2, 3)))

    def set_look(self, opacity, line_width, point_size):
        """Of the edges, as view_properties.look() has it."""
        self.veil.transparency = 1 - opacity
        for style, share in ((self.edge_style, EDGE_WIDTH), (self.model_edge_style, MODEL_EDGE_WIDTH),
                             (self.wire_style, WIRE_WIDTH)):
            style.lineWidth = max(share * line_width, 1)
        self.wire_style.pointSize = max(WIRE_NODE * point_size, 1)

    def set_wires(self, lines):
        """lines: (n, k, 3) points along each line of a wire; dots show where one ends."""
        self.wire_dots.numPoints = 0
        fill_rows(self.wire_lines.coordIndex, self.wire_points.point, lines)
        fill(self.wire_nodes.point, lines[:, [0, -1]].reshape(-1, 3))
        self.wire_dots.numPoints = 2 * len(lines)

    def set_points(self, points, normals):
        """Nothing is drawn from here on until set_indices."""
        nothing = np.zeros(0, np.int32)
        self.set_indices(nothing, nothing, nothing)  # never indices of points or colours that are not there
        fill(self.points.point, points)
        fill(self.normals.vector, normals)

    def set_indices(self, triangles, edges, model_edges):
        """edges: of elements; model_edges: of those on edges of the model."""
        for field, indices in ((self.face_set.coordIndex, triangles), (self.lines.coordIndex, edges),
                               (self.model_lines.coordIndex, model_edges)):
            if len(indices) or field.getNum():
                fill(field, indices)

    def set_colours(self, per_point):
        """per_point: (points,) packed colours as they shall be drawn."""
        self.binding.value = coin.SoMaterialBinding.PER_VERTEX_INDEXED
        fill(self.packed.orderedRGBA, per_point)

    def set_one_colour(self, packed):
        self.binding.value = coin.SoMaterialBinding.OVERALL
        fill(self.packed.orderedRGBA, np.array([packed], np.uint32))

    def set_shaded(self, is_shaded):
        self.light.model = coin.SoLightModel.PHONG if is_shaded else coin.SoLightModel.BASE_COLOR

    def set_edge_colour(self, rgb, packed):
        """packed: colours of the elements."""
        self.edge_colour.rgb = tuple(rgb[:3])
        mean = [float((packed >> shift & 255).mean()) / 255 if len(packed) else 0.5 for shift in (24, 16, 8)]
        self.faint_colour.rgb = tuple(FAINT * m + (1 - FAINT) * c for m, c in zip(mean, rgb))


def both_sides():
    """An open surface has two."""
    return node(coin.SoShapeHints, vertexOrdering=coin.SoShapeHints.COUNTERCLOCKWISE,
                shapeType=coin.SoShapeHints.UNKNOWN_SHAPE_TYPE, faceType=coin.SoShapeHints.CONVEX)


def soft_material():
    """Without gloss, which would wash colours out."""
    return node(coin.SoMaterial, ambientColor=(0.3, 0.3, 0.3), specularColor=(0, 0, 0))


def fill_lights():
    """Weak lights besides the camera's: faces seen at an angle keep colours that can be read."""
    return [node(coin.SoDirectionalLight, direction=direction, intensity=FILL_INTENSITY) for direction in FILL_DIRECTIONS]


def by_index():
    return node(coin.SoNormalBinding, value=coin.SoNormalBinding.PER_VERTEX_INDEXED)
