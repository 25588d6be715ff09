"""FreeCAD's own properties of a view, and where the legends of several meshes stand. display_test.py runs this."""
import FreeCAD
import FreeCADGui
import numpy as np
from pivy import coin

from display_cases import InWindow, wait
from paver_wb.gui.display import colouring, mesh_display, panels

BLACK = "Black"


class Look(InWindow):
    def pictures(self, name, **properties):
        """{mode: picture on white} with properties of the view."""
        made = {}
        self.set(**properties)
        for mode in mesh_display.MODES:
            self.set(DisplayMode=mode)
            made[mode] = self.picture(f"look_{name}_{mesh_display.MODES.index(mode)}")
        return made

    def setUp(self):
        super().setUp()
        self.run_mesh()
        self.set(ColourBar=False, Shaded=False, ColourBy=colouring.NONE, ShapeColor=(1.0, 0.0, 0.0), EdgeColour=(0.0, 0.0, 0.0),
                 AlwaysAllEdges=True)
        self.look()

    def test_transparency_in_every_mode(self):
        opaque, clear = self.pictures("opaque"), self.pictures("clear", Transparency=80)
        for mode in mesh_display.MODES:
            darker = (opaque[mode].min(axis=2) < 100).mean(), (clear[mode].min(axis=2) < 100).mean()
            self.assertGreater(darker[0], 0.01, mode)
            self.assertLess(darker[1], darker[0] / 2, mode)
        self.set(ColourBy=colouring.KIND, DisplayMode=mesh_display.CURVED)
        self.assertLess((self.picture("look_clear_kind").min(axis=2) < 100).mean(), 0.01)

    def test_line_width_in_every_mode_with_edges(self):
        def dark(made):
            return {mode: (picture.max(axis=2) < 90).mean() for mode, picture in made.items() if mode != mesh_display.CURVED}
        thin, thick = dark(self.pictures("thin")), dark(self.pictures("thick", LineWidth=8.0))
        for mode in thin:
            self.assertGreater(thick[mode], 2 * thin[mode], mode)

    def test_point_size_of_nodes_in_every_mode(self):
        def blue(made):
            return {mode: ((picture[:, :, 2] > 150) & (picture[:, :, :2].max(axis=2) < 90)).mean()
                    for mode, picture in made.items()}
        none = blue(self.pictures("no_nodes", PointColor=(0.0, 0.0, 1.0)))
        small, large = blue(self.pictures("small", ShowNodes=True, PointSize=3.0)), blue(self.pictures("large", PointSize=9.0))
        for mode in mesh_display.MODES:
            self.assertEqual(none[mode], 0, mode)
            self.assertGreater(large[mode], 2 * small[mode], mode)
            self.assertGreater(small[mode], 0, mode)


def sheets(picture):
    """[(first, end)] of the columns that legends stand in, white on black."""
    is_white = (picture.min(axis=2) > 170).sum(axis=0) > 60
    ends = np.flatnonzero(np.diff(np.concatenate([[False], is_white, [False]]).astype(int)))
    return [tuple(pair) for pair in ends.reshape(-1, 2) if pair[1] - pair[0] > 20]


class Legends(InWindow):
    def setUp(self):
        super().setUp()
        other = self.document.addObject("Part::Box", "Box")
        other.Placement.Base.x = 30
        self.document.recompute()
        self.other = self.add(other, size=3)
        for mesh in (self.mesh, self.other):
            self.run_mesh(mesh)
            mesh.ViewObject.EdgeColour = (0.0, 0.0, 0.0)
        self.look()

    def seen(self, name):
        return sheets(self.picture(name, background=BLACK))

    def test_two_legends_stand_side_by_side(self):
        self.assertEqual(len(self.seen("legends_two")), 2)
        self.other.ViewObject.Visibility = False
        wait(100)
        self.assertEqual(len(self.seen("legends_one")), 1)
        self.other.ViewObject.Visibility = True
        self.set(ColourBar=False)
        wait(100)
        self.assertEqual(len(self.seen("legends_other")), 1)
        self.set(ColourBar=True)
        self.document.removeObject(self.other.Name)
        wait(100)
        self.assertEqual(len(self.seen("legends_left")), 1)

    def test_a_legend_stands_in_the_corner_that_is_chosen(self):
        self.other.ViewObject.Visibility = False
        for corner in panels.CORNERS:
            self.set(LegendCorner=corner)
            white = np.argwhere(self.picture("legends_corner", background=BLACK).min(axis=2) > 200)
            (y, x), (height, width) = white.mean(axis=0), (700, 900)
            self.assertEqual((y < height / 2, x < width / 2), (corner.startswith("Upper"), corner.endswith("left")), corner)

    def test_legends_of_one_side_do_not_cover_each_other(self):
        self.set(LegendCorner="Lower left")
        picture = self.picture("legends_one_side", size=(900, 400), background=BLACK)
        self.assertEqual(len(sheets(picture)), 2)

    def test_the_report_of_an_element_leaves_the_legend(self):
        self.other.ViewObject.Visibility = False
        display, real = self.display(), mesh_display.view_height
        self.addCleanup(setattr, mesh_display, "view_height", real)
        for height, beside in ((2000, False), (300, True)):
            mesh_display.view_height = lambda document: height
            FreeCADGui.Selection.clearSelection()
            wait()
            FreeCADGui.Selection.addSelection(self.mesh, "Elem1")
            wait()
            display.report(0)
            wait(100)
            picture = self.picture("legends_report", size=(900, height), background=BLACK)
            self.assertEqual(len(sheets(picture)), 1 + beside, height)

    def test_clipping_planes_leave_the_legends(self):
        root = self.view.getSceneGraph()
        for normal in ((1, 0, 0), (-1, 0, 0), (0, 1, 0), (0, -1, 0), (0, 0, 1), (0, 0, -1)):
            for distance in (-5, 0, 5, 200):
                plane = coin.SoClipPlane()
                plane.plane = coin.SbPlane(coin.SbVec3f(*normal), distance)
                root.insertChild(plane, 0)
                self.assertEqual(len(self.seen("legends_clipped")), 2, (normal, distance))
                root.removeChild(0)
        self.assertEqual(FreeCAD.ActiveDocument, self.document)
