"""How meshes look in FreeCAD's window. display_test.py runs this with a screen of its own; the pictures it takes are left
in the build folder."""
import os
import tempfile
import unittest

import FreeCAD
import FreeCADGui
import numpy as np
import Part
from pivy import coin
from PySide import QtCore, QtGui

import drawing
import window
from paver_wb import core, mesh_object, meshing
from paver_wb.formats import mesh_file
from paver_wb.gui.base import first_view
from paver_wb.gui.display import colour_maps, colouring, drawn_mesh, legend, mesh_display

RADIUS = 10


def wait(ms=30):
    """Lets FreeCAD work through its events, and through those that they cause."""
    for _ in range(3):
        loop = QtCore.QEventLoop()
        QtCore.QTimer.singleShot(ms // 3, loop.quit)
        loop.exec_()


class InWindow(unittest.TestCase):
    """A document with a sphere, not meshed yet."""

    def setUp(self):
        window.clear()
        self.document = FreeCAD.newDocument("PaverDisplay")
        self.sphere = self.document.addObject("Part::Sphere", "Sphere")
        self.sphere.Radius = RADIUS
        self.document.recompute()
        self.mesh = self.add(self.sphere, size=3)
        self.view = FreeCADGui.ActiveDocument.ActiveView

    def tearDown(self):
        FreeCADGui.Selection.clearSelection()
        FreeCAD.closeDocument(self.document.Name)

    def add(self, source, **options):
        mesh = mesh_object.add(self.document, source, **options)
        source.ViewObject.Visibility = False
        return mesh

    def run_mesh(self, mesh=None):
        """Meshes; the display, up to date."""
        meshing.mesh(mesh or self.mesh)
        wait()
        return self.display(mesh)

    def display(self, mesh=None):
        return (mesh or self.mesh).ViewObject.Proxy.display

    def set(self, **properties):
        for name, value in properties.items():
            setattr(self.mesh.ViewObject, name, value)
        wait()
        return self.display()

    def look(self):
        first_view.show_all(self.view)
        wait(100)

    def picture(self, name, size=(900, 700), background="White"):
        """(height, width, 3) of what the view shows; the picture is kept."""
        folder = os.environ.get("PAVER_PICTURES") or tempfile.gettempdir()
        path = os.path.join(folder, name + ".png")
        wait()
        self.view.saveImage(path, *size, background)
        image = QtGui.QImage(path).convertToFormat(QtGui.QImage.Format_RGBA8888)
        return np.frombuffer(image.constBits(), np.uint8).reshape(image.height(), image.width(), 4)[:, :, :3].astype(int)

    def triangles_drawn(self, display):
        rows = drawing.content(display.scene.face_set.coordIndex, np.int32).reshape(-1, 4)
        self.assertTrue((rows[:, 3] == -1).all())
        return rows[:, :3]


def share_of(picture, is_wanted):
    return is_wanted(picture).mean()


def is_coloured(picture):
    return np.ptp(picture, axis=2) > 40


class Modes(InWindow):
    def test_own_modes_come_besides_those_of_fem(self):
        listed = self.mesh.ViewObject.listDisplayModes()
        self.assertEqual(self.mesh.ViewObject.DisplayMode, mesh_display.CURVED_EDGES)
        self.assertEqual(listed[-3:], list(mesh_display.MODES))
        self.assertIn("Faces & Wireframe", listed)

    def test_what_each_mode_draws(self):
        self.run_mesh()
        self.set(ColourBar=False, EdgeColour=(1.0, 0.0, 0.0))
        self.look()
        drawn = {}
        for mode in mesh_display.MODES:
            self.set(DisplayMode=mode)
            picture = self.picture("mode_" + mode.replace(" + ", "_").replace(" ", "_").lower())
            is_edge = (picture[:, :, 0] > 200) & (picture[:, :, 1:].max(axis=2) < 40)
            drawn[mode] = (is_coloured(picture) & ~is_edge).mean() > 0.15, is_edge.mean() > 0.005
        self.assertEqual(list(drawn.values()), [(True, False), (True, True), (False, True)])

    def test_edges_fade_where_they_lie_close(self):
        self.mesh.Size = 0.5
        self.run_mesh()
        self.set(ColourBar=False, Shaded=False, ColourBy=colouring.NONE, ShapeColor=(1.0, 1.0, 1.0),
                 EdgeColour=(0.0, 0.0, 0.0))
        self.look()
        dark = lambda picture: (picture.max(axis=2) < 60).mean()  # noqa: E731
        before = dark(self.picture("edges_faint"))
        self.view.getCameraNode().height = self.view.getCameraNode().height.getValue() / 8
        near = dark(self.picture("edges_near"))
        self.look()
        self.set(AlwaysAllEdges=True)
        always = dark(self.picture("edges_all"))
        self.assertLess(before, 0.01)
        self.assertGreater(min(near, always), 2 * before + 0.01)

    def test_faces_and_edges_are_curved_and_normals_true(self):
        display = self.run_mesh()
        points = drawing.content(display.scene.points.point, np.float32, 3)
        normals = drawing.content(display.scene.normals.vector, np.float32, 3)
        self.assertGreater(display.subdivision, 1)
        np.testing.assert_allclose(np.linalg.norm(points, axis=1), RADIUS, rtol=2e-3)
        np.testing.assert_allclose(normals, points / RADIUS, atol=0.03)
        lines = drawing.content(display.scene.lines.coordIndex, np.int32)
        self.assertEqual((lines == -1).sum(), 2 * display.mesh.count)  # closed, all quads: two edges for each
        self.assertEqual(len(lines), (display.subdivision + 2) * 2 * display.mesh.count)
        self.assertEqual(len(self.triangles_drawn(display)), 2 * display.subdivision ** 2 * display.mesh.count)

    def test_nothing_is_built_before_it_is_shown(self):
        self.set(Visibility=False)
        self.assertIsNone(self.run_mesh().mesh)
        self.assertIsNotNone(self.set(Visibility=True).mesh)
        self.set(DisplayMode="Faces")
        before = self.display().mesh
        self.mesh.Size = 4
        self.assertIs(self.run_mesh().mesh, before)
        shown = self.set(DisplayMode=mesh_display.CURVED)
        self.assertIsNot(shown.mesh, before)
        self.assertEqual(shown.mesh.count, self.mesh.Quads + self.mesh.Triangles)

    def test_the_drawing_does_not_need_the_fem_mesh(self):
        settings = FreeCAD.ParamGet(mesh_object.PREFERENCES)
        settings.SetInt("FillLimit", 10)
        self.addCleanup(settings.RemInt, "FillLimit")
        display = self.run_mesh()
        self.assertEqual(self.mesh.FemMesh.FaceCount, 0)
        self.assertEqual(display.mesh.count, self.mesh.Quads + self.mesh.Triangles)
        self.assertGreater(len(self.triangles_drawn(display)), 0)

    def test_a_damaged_file_shows_nothing(self):
        display = self.run_mesh()
        with open(self.mesh.MeshFile, "r+b") as file:
            file.seek(300)
            file.write(b"\xff" * 2000)
        display.changed(mesh_display.MESH)
        wait()
        self.assertIsNone(display.mesh)
        self.assertEqual(len(self.triangles_drawn(display)), 0)


class Wires(InWindow):
    """Lines on no face."""

    def wire(self):
        arc = self.document.addObject("Part::Feature", "Arc")
        arc.Shape = Part.Arc(*[FreeCAD.Vector(*at) for at in ((0, 0, 0), (20, 0, 20), (40, 0, 0))]).toShape()
        return arc

    def test_they_are_drawn_in_all_modes_besides_faces(self):
        plate = self.document.addObject("Part::Feature", "Plate")
        plate.Shape = Part.makePlane(60, 30, FreeCAD.Vector(-10, -15, 0))
        self.mesh = self.add(plate, size=5)
        self.mesh.MoreParts = [self.wire()]
        display = self.run_mesh()
        points = drawing.content(display.scene.wire_points.point, np.float32, 3)
        self.assertEqual(len(points), 9 * self.mesh.Lines)
        np.testing.assert_allclose(np.linalg.norm(points - (20, 0, 0), axis=1), 20, rtol=1e-3)
        self.assertEqual(display.scene.wire_dots.numPoints.getValue(), 2 * self.mesh.Lines)
        self.set(ColourBar=False, EdgeColour=(1.0, 0.0, 0.0))
        self.look()
        for mode in mesh_display.MODES:
            self.set(DisplayMode=mode)
            picture = self.picture("wire_" + mode.replace(" + ", "_").replace(" ", "_").lower())
            is_wire = (picture[:, :, 0] > 200) & (picture[:, :, 1:].max(axis=2) < 40)
            self.assertGreater(is_wire.mean(), 0.002)

    def test_a_wire_alone(self):
        self.mesh = self.add(self.wire(), size=5)
        display = self.run_mesh()
        self.assertEqual((self.mesh.Quads, self.mesh.Triangles, self.mesh.Lines), (0, 0, 13))
        self.assertEqual((self.mesh.FemMesh.EdgeCount, self.mesh.FemMesh.FaceCount), (13, 0))
        self.look()
        self.assertGreater((self.picture("wire_alone").max(axis=2) < 60).mean(), 0.001)
        display.clear()
        self.assertEqual(display.scene.wire_dots.numPoints.getValue(), 0)


class Colours(InWindow):
    def setUp(self):
        super().setUp()
        self.set(Shaded=False)

    def per_element(self, display):
        """(elements,) packed colours as drawn; one for all points of each."""
        drawn = drawing.content(display.scene.packed.orderedRGBA, np.uint32)
        of_quad, of_triangle = display.mesh.points_per_element(display.subdivision)
        split = display.mesh.quad_count * of_quad
        quads, others = drawn[:split].reshape(-1, of_quad), drawn[split:].reshape(-1, of_triangle)
        for block in (quads, others):
            self.assertTrue((block == block[:, :1]).all())
        return np.concatenate([quads[:, 0], others[:, 0]])

    def expect_colours(self, display, values, low, high, table):
        wanted = np.minimum(np.clip((values - low) / (high - low), 0, 1) * 256, 255).astype(int)
        np.testing.assert_array_equal(self.per_element(display), colour_maps.packed(colour_maps.table(table))[wanted])

    def test_scaled_jacobian(self):
        display = self.run_mesh()
        self.expect_colours(display, display.mesh.core_mesh.quality().sj, 0, 1, "Quality")
        values = display.mesh.quality.sj
        self.set(ColourRange="Data", ColourMap="Viridis")
        self.expect_colours(display, values, values.min(), values.max(), "Viridis")
        self.set(ColourRange="Manual", RangeLow=0.5, RangeHigh=0.75)
        self.expect_colours(display, values, 0.5, 0.75, "Viridis")

    def test_edge_length_over_target(self):
        self.run_mesh()
        display = self.set(ColourBy=colouring.LENGTH)
        stored = mesh_object.stored(self.mesh)
        corners = stored.nodes[stored.quads[:, :4]]
        longest = np.linalg.norm(corners - np.roll(corners, -1, axis=1), axis=2).max(axis=1)
        self.assertEqual(len(stored.triangles), 0)
        self.expect_colours(display, longest / self.mesh.TargetLength.Value, 0, 2, "Deviation")

    def test_edge_length_over_local_target(self):
        cylinder = self.document.addObject("Part::Cylinder", "Cylinder")
        cylinder.Height = 30
        self.document.recompute()
        self.mesh = self.add(cylinder, size=2)
        self.mesh.Local = ["Face3=0.5mm"]
        mesh = self.run_mesh().mesh
        display, stored = self.set(ColourBy=colouring.LOCAL_LENGTH, Shaded=False), mesh_object.stored(self.mesh)
        targets, worst = stored.node_targets, []
        for rows, corners in ((stored.quads, 4), (stored.triangles, 3)):
            for row in rows:
                pairs = [(row[k], row[(k + 1) % corners]) for k in range(corners)]
                worst.append(max(np.linalg.norm(stored.nodes[a] - stored.nodes[b]) / ((targets[a] + targets[b]) / 2)
                                 for a, b in pairs))
        self.expect_colours(display, np.array(worst), 0, 2, "Deviation")
        self.assertLess(targets[targets > 0].min(), 0.6)
        self.assertRegex(drawing.labels(display.colouring.legend)[1], "^target 0.4[0-9]* \u2013 [12].* mm$")
        older = drawn_mesh.DrawnMesh(stored._replace(node_targets=None))
        np.testing.assert_array_equal(np.nanmax(older.edge_targets), mesh.target)

    def test_element_type_face_and_certificate(self):
        cylinder = self.document.addObject("Part::Cylinder", "Cylinder")
        self.document.recompute()
        self.mesh = self.add(cylinder, size=1, elements="all-triangle")
        mesh = self.run_mesh().mesh
        self.assertGreater(mesh.triangle_count, 0)
        for what, numbers in ((colouring.KIND, np.arange(mesh.count) >= mesh.quad_count), (colouring.FACE, mesh.faces),
                              (colouring.CERTIFICATE, mesh.quality.validity)):
            colours = self.per_element(self.set(ColourBy=what))
            self.assertEqual(len(set(zip(numbers, colours))), len(set(numbers)), what)
            self.assertEqual(len(set(colours)), len(set(numbers)), what)
        self.assertEqual({e[0] for e in colouring.by_face(mesh).legend.entries}, {"Face1", "Face2", "Face3"})

    def test_one_colour(self):
        self.run_mesh()
        display = self.set(ColourBy=colouring.NONE, ShapeColor=(1.0, 0.0, 0.0))
        self.assertEqual(drawing.content(display.scene.packed.orderedRGBA, np.uint32).tolist(), [0xff0000ff])
        self.assertIsNone(display.colouring.legend)

    def test_the_pixels_have_the_colours(self):
        self.run_mesh()
        display = self.set(ColourBy=colouring.LENGTH, Shaded=False, ColourBar=False, DisplayMode=mesh_display.CURVED)
        self.look()
        picture = self.picture("pixels", self.view.getSize(), "Current")
        away = np.array(self.view.getViewDirection())
        colours, compared = self.per_element(display), 0
        for element in np.flatnonzero(display.mesh.normals @ away < -0.5):
            x, y = self.view.getPointOnScreen(FreeCAD.Vector(*display.mesh.centres[element]))
            wanted = [int(colours[element]) >> shift & 255 for shift in (24, 16, 8)]
            np.testing.assert_allclose(picture[picture.shape[0] - 1 - y, x], wanted, atol=2)
            compared += 1
        self.assertGreater(compared, 20)

    def test_light_makes_up_for_darker_colours(self):
        self.run_mesh()
        self.set(ColourBy=colouring.NONE, ShapeColor=(0.5, 0.25, 0.75), Shaded=True, DisplayMode=mesh_display.CURVED,
                 ColourBar=False)
        self.look()
        picture = self.picture("shaded")
        middle = picture[picture.shape[0] // 2, picture.shape[1] // 2]
        np.testing.assert_allclose(middle / 255, (0.5, 0.25, 0.75), atol=0.09)

    def test_new_colours_leave_points_alone(self):
        display = self.run_mesh()
        before = display.scene.points.getNodeId(), display.scene.face_set.getNodeId(), display.scene.packed.getNodeId()
        self.set(ColourBy=colouring.LENGTH)
        after = display.scene.points.getNodeId(), display.scene.face_set.getNodeId(), display.scene.packed.getNodeId()
        self.assertEqual(before[:2], after[:2])
        self.assertNotEqual(before[2], after[2])


class ColourBar(InWindow):
    def test_texts(self):
        display = self.run_mesh()
        scale = display.colouring.legend
        self.assertEqual(drawing.labels(scale)[:7], ["Scaled Jacobian", "1", "0.8", "0.6", "0.4", "0.2", "0"])
        self.assertEqual(scale.histogram.sum(), display.mesh.count)
        values = display.mesh.quality.sj
        self.assertAlmostEqual(scale.least, values.min())
        for at in (0, 5, 11, 23):
            within = (values >= at / 24) & ((values < (at + 1) / 24) | (at == 23))
            self.assertEqual(scale.histogram[at], within.sum())
        texts = drawing.labels(self.set(ColourBy=colouring.LENGTH).colouring.legend)
        self.assertEqual(texts[:3], ["Longest edge / target", "target 3 mm", "2"])
        texts = drawing.labels(self.set(ColourBy=colouring.KIND).colouring.legend)
        self.assertEqual(texts, ["Element type", "Quad", str(display.mesh.count)])

    def test_many_faces_are_told_in_few_rows(self):
        key = colouring.Key("Source face", [(f"Face{i}", (0, 0, 0), 1) for i in range(30)])
        rows = legend.key_rows(key)
        self.assertEqual((len(rows), rows[-1][:2]), (colouring.MOST_ENTRIES, ("17 more", "17")))

    def test_it_lies_in_the_corner_and_can_be_hidden(self):
        self.run_mesh()
        self.look()
        for mode in (mesh_display.CURVED, mesh_display.CURVED_EDGES):
            self.set(DisplayMode=mode, ColourBar=True)
            bar = self.picture("colour_bar", background="Black")[10:300, 10:200]
            self.assertGreater((bar.min(axis=2) > 180).mean(), 0.5, mode)
            self.set(ColourBar=False)
            bar = self.picture("no_colour_bar", background="Black")[10:300, 10:200]
            self.assertLess((bar.min(axis=2) > 180).mean(), 0.05, mode)
        self.set(DisplayMode=mesh_display.EDGES, ColourBar=True)
        bar = self.picture("no_colour_bar", background="Black")[10:300, 10:200]
        self.assertLess((bar.min(axis=2) > 180).mean(), 0.05, "no colours, no bar")

    def test_it_adds_nothing_to_the_extent_of_the_model(self):
        self.sphere.Placement.Base = FreeCAD.Vector(1e4, 2e4, 3e4)
        self.document.recompute()
        display = self.run_mesh()
        low, high = display.mesh.extent
        action = coin.SoGetBoundingBoxAction(coin.SbViewportRegion(800, 600))
        action.apply(self.mesh.ViewObject.RootNode)
        box = action.getBoundingBox()
        np.testing.assert_allclose(box.getMin().getValue(), low, atol=0.3)
        np.testing.assert_allclose(box.getMax().getValue(), high, atol=0.3)


class Elements(unittest.TestCase):
    """drawn_mesh against the core's tessellation."""

    def drawn(self, elements, order=2):
        import Part
        result = core.load().mesh(Part.makeCylinder(5, 20), size=4, order=order, elements=elements)
        return drawn_mesh.DrawnMesh(mesh_file.of_result(result, result.face_names))

    def test_triangles_and_outlines_of_elements(self):
        for kind in ("quad-dominant", "all-triangle"):
            mesh = self.drawn(kind)
            for n in (1, 2, 3):
                drawn = mesh.tessellation(n)
                for elements in ([0], [3, 7], range(mesh.count)):
                    rows = mesh.triangle_rows(list(elements), n)
                    self.assertEqual(set(drawn.triangle_elements[rows]), set(elements))
                    self.assertEqual(len(rows), np.isin(drawn.triangle_elements, list(elements)).sum())
                lines = mesh.element_outlines(np.arange(mesh.count), n)
                pieces = np.split(lines, np.flatnonzero(lines == -1) + 1)[:-1]
                self.assertEqual(len(pieces), mesh.count)
                for element, piece in enumerate(pieces):
                    corners = mesh.corners[element][mesh.corners[element] >= 0]
                    self.assertEqual((len(piece), piece[0]), (len(corners) * n + 2, piece[-2]))
                    np.testing.assert_allclose(drawn.points[piece[:-2:n]], mesh.stored.nodes[corners], atol=1e-5)

    def test_files_without_local_targets(self):
        mesh = self.drawn("quad-dominant").stored
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "mesh.paver")
            for targets in (mesh.node_targets, None):
                mesh_file.write(mesh._replace(node_targets=targets), path)
                np.testing.assert_array_equal(mesh_file.read(path).node_targets, targets)

    def test_subdivision_follows_curvature_and_count(self):
        self.assertEqual(drawn_mesh.subdivision_for(1000, 0), 1)
        self.assertGreater(drawn_mesh.subdivision_for(1000, 0.1), 3)
        self.assertEqual(drawn_mesh.subdivision_for(500000, 0.1), 1)
        self.assertEqual(self.drawn("quad-dominant", 1).sag, 0)
        self.assertGreater(self.drawn("quad-dominant").sag, 0.02)
        for elements in (2000, 100000, 500000):
            n = drawn_mesh.subdivision_for(elements, 1)
            self.assertLessEqual(2 * n * n * elements, drawn_mesh.MOST_TRIANGLES)
