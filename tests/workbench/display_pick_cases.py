"""The element under the mouse, marks and highlights in the 3D view; see display_cases.py."""
import FreeCAD
import FreeCADGui
import numpy as np
from PySide import QtCore

import display_cases
import drawing
import window
from display_cases import RADIUS, wait
from paver_wb import mesh_object
from paver_wb.gui.commands import view
from paver_wb.gui.display import actions, colouring, report


class Marks(display_cases.InWindow):
    def marked(self, mark):
        return set(mark.elements)

    def test_worst_elements(self):
        display = self.run_mesh()
        values = display.mesh.quality.sj
        names = actions.show_worst(self.mesh, 5)
        wait()
        found = [report.element_number(name) for name in names]
        self.assertEqual(self.marked(display.worst), set(found))
        self.assertEqual(sorted(values)[:5], [values[e] for e in found])
        self.assertEqual(display.labels.texts, [f"{i + 1}: {values[e]:.2f}" for i, e in enumerate(found)])
        rows = drawing.content(display.worst.face_set.coordIndex, np.int32).reshape(-1, 4)[:, :3]
        of_point = display.mesh.per_point(np.arange(display.mesh.count), display.subdivision)
        self.assertEqual(set(of_point[rows].ravel()), set(found))
        self.look()
        self.picture("worst")
        self.assertEqual(actions.show_worst(self.mesh, 0), [])
        wait()
        self.assertEqual((self.marked(display.worst), display.labels.texts), (set(), []))

    def test_more_worst_elements_than_there_are(self):
        display = self.run_mesh()
        self.assertEqual(len(actions.show_worst(self.mesh, 1000)), min(display.mesh.count, 1000))

    def test_free_edges(self):
        plane = self.document.addObject("Part::Plane", "Plane")
        self.document.recompute()
        self.mesh = self.add(plane, size=10)
        display = self.run_mesh()
        border = mesh_object.stored(self.mesh).report["quality"]["border_edges"]
        self.assertEqual(actions.show_free_edges(self.mesh), (border, 0))
        wait()
        self.assertEqual((display.free.count, display.crowded.count), (border, 0))
        points = drawing.content(display.free.points.point, np.float32, 3)
        on_rim = np.isclose(points[:, :2], 0, atol=1e-4) | np.isclose(points[:, :2], 100)
        self.assertTrue(on_rim.any(axis=1).all())
        self.look()
        self.picture("free_edges")
        actions.show_free_edges(self.mesh, False)
        wait()
        self.assertEqual(display.free.count, 0)
        self.assertEqual(self.run_mesh(self.add(self.sphere, size=4)).tessellation.outline_elements.min(), 2)

    def test_triangles(self):
        self.mesh.Elements = "all-triangle"
        display = self.run_mesh()
        self.assertEqual(actions.show_triangles(self.mesh), self.mesh.Triangles)
        wait()
        self.assertEqual(self.marked(display.triangles), set(range(self.mesh.Quads, display.mesh.count)))
        actions.show_triangles(self.mesh, False)
        wait()
        self.assertEqual(self.marked(display.triangles), set())

    def test_normals(self):
        display = self.run_mesh()
        actions.show_normals(self.mesh)
        wait()
        pairs = drawing.content(display.normals.vertices.vertex, np.float32, 3).reshape(-1, 2, 3)
        self.assertEqual(len(pairs), display.mesh.count)
        lengths = np.linalg.norm(pairs, axis=2)
        self.assertTrue((lengths[:, 1] > lengths[:, 0] + 0.5).all(), "they point out of the sphere")
        self.look()
        self.picture("normals")
        actions.show_normals(self.mesh, False)
        wait()
        self.assertEqual(display.normals.count, 0)

    def test_shrunk_elements(self):
        display = self.run_mesh()
        whole = drawing.content(display.scene.points.point, np.float32, 3)
        actions.shrink(self.mesh, 0.5)
        wait()
        shrunk = drawing.content(display.scene.points.point, np.float32, 3)
        size = display.mesh.points_per_element(display.subdivision)[0]
        before, after = whole.reshape(-1, size, 3), shrunk.reshape(-1, size, 3)
        np.testing.assert_allclose(after.mean(axis=1), before.mean(axis=1), atol=1e-4)
        np.testing.assert_allclose(np.ptp(after, axis=1), 0.5 * np.ptp(before, axis=1), atol=1e-4)
        lines = drawing.content(display.scene.lines.coordIndex, np.int32)
        self.assertEqual((lines == -1).sum(), display.mesh.count, "an outline for each element")
        self.look()
        self.picture("shrunk")
        actions.shrink(self.mesh, 1)
        wait()
        np.testing.assert_array_equal(drawing.content(display.scene.points.point, np.float32, 3), whole)


class WithPlaces(display_cases.InWindow):
    """Where elements are seen."""

    def place_of(self, display, element):
        return self.view.getPointOnScreen(FreeCAD.Vector(*self.middle(display, element)))

    def middle(self, display, element):
        """On the curved element, where its centre is seen."""
        size = display.mesh.points_per_element(display.subdivision)[0]
        return [float(x) for x in display.tessellation.points[element * size:(element + 1) * size].mean(axis=0)]

    def facing(self, display):
        away = np.array(self.view.getViewDirection())
        return np.flatnonzero(display.mesh.normals @ away < -0.7)

    def mouse_place(self, x, y):
        """On the widget, of a place of the view."""
        viewport = window.viewport()
        width, height = self.view.getSize()
        return viewport, QtCore.QPoint(round((x + 0.5) * viewport.width() / width),
                                       round((height - 0.5 - y) * viewport.height() / height))


class Picking(WithPlaces):
    def test_the_element_under_every_place(self):
        display = self.run_mesh()
        self.look()
        elements = self.facing(display)
        self.assertGreater(len(elements), 15)
        for element in elements:
            info = self.view.getObjectInfo(self.place_of(display, element))
            self.assertEqual((info["Object"], info["Component"]), (self.mesh.Name, report.element_name(element)))
            self.assertAlmostEqual(np.linalg.norm([info[k] for k in "xyz"]), RADIUS, delta=0.05)
        self.assertIsNone(self.view.getObjectInfo((2, 2)))

    def test_elements_of_the_mesh_of_before_are_selected_no_longer(self):
        display = self.run_mesh()
        actions.select(self.mesh, ["Elem3", "Elem5"])
        wait()
        self.assertEqual(display.selected, (2, 4))
        self.mesh.Size = 0.5 * self.mesh.TargetLength
        self.run_mesh()
        part, = FreeCADGui.Selection.getSelectionEx()
        self.assertEqual((part.Object, part.SubElementNames, display.selected), (self.mesh, (), ()))

    def test_what_lies_in_front_is_picked(self):
        display = self.run_mesh()
        self.look()
        element = self.facing(display)[0]
        place, away = self.place_of(display, element), np.array(self.view.getViewDirection())
        ball = self.document.addObject("Part::Sphere", "Ball")
        ball.Radius = 1
        for distance, front in ((5, "Ball"), (-5, self.mesh.Name)):
            ball.Placement.Base = FreeCAD.Vector(*(float(x) for x in display.mesh.centres[element] - distance * away))
            self.document.recompute()
            wait()
            self.assertEqual(self.view.getObjectInfo(place)["Object"], front)

    def test_fem_picks_in_its_own_modes(self):
        display = self.run_mesh()
        self.look()
        place = self.place_of(display, self.facing(display)[0])
        self.set(DisplayMode="Faces")
        info = self.view.getObjectInfo(place)
        self.assertEqual(info["Object"], self.mesh.Name)
        self.set(Visibility=False)
        self.assertIsNone(self.view.getObjectInfo(place))

    def test_a_click_selects_highlights_and_reports(self):
        self.mesh.Size, self.mesh.Frequency = 0, "9 GHz"
        display = self.run_mesh()
        self.look()
        element = int(self.facing(display)[3])
        viewport, place = self.mouse_place(*self.place_of(display, element))
        for step in (4, 2, 0):
            window.QTest.mouseMove(viewport, place - QtCore.QPoint(step, step))
            wait(150)
        self.assertEqual(display.hovered, element)
        message = FreeCADGui.getMainWindow().statusBar().currentMessage()
        info = actions.element(self.mesh, report.element_name(element))
        self.assertIn(report.line(info), message)
        self.assertIn("\u03bb", message)
        window.QTest.mouseClick(viewport, QtCore.Qt.LeftButton, QtCore.Qt.NoModifier, place)
        wait(200)
        selected, = FreeCADGui.Selection.getSelectionEx()
        self.assertEqual((selected.Object, selected.SubElementNames), (self.mesh, (report.element_name(element),)))
        self.assertEqual((display.selected, display.reported), ((element,), element))
        self.assertEqual(display.selection.elements, (element,))
        self.assertEqual(display.report_panel.switch.whichChild.getValue(), 0)
        self.picture("clicked", background="Current")
        FreeCADGui.Selection.clearSelection()
        wait()
        self.assertEqual((display.selection.elements, display.report_panel.switch.whichChild.getValue()), ((), -1))

    def test_figures_of_an_element(self):
        self.mesh.Size, self.mesh.Frequency, self.mesh.EpsR = 0, "9 GHz", 4
        display = self.run_mesh()
        info = actions.element(self.mesh, "Elem2")
        stored = mesh_object.stored(self.mesh)
        corners = stored.nodes[stored.quads[1, :4]]
        lengths = np.linalg.norm(corners - np.roll(corners, -1, axis=0), axis=1)
        np.testing.assert_allclose(info["lengths"], lengths)
        np.testing.assert_allclose(info["lengths_in_wavelengths"], lengths / (299792458000 / 9e9 / 2))
        self.assertEqual((info["kind"], info["face"], info["order"]), ("quad", "Face1", 2))
        self.assertEqual(info["sj"], display.mesh.quality.sj[1])
        self.assertNotIn("lengths_in_wavelengths", report.information(display.mesh, 1))
        for name in ("Elem0", f"Elem{display.mesh.count + 1}", "Face1"):
            self.assertRaises(ValueError, actions.element, self.mesh, name)

    def test_selected_elements_are_highlighted(self):
        display = self.run_mesh()
        actions.select(self.mesh, ["Elem3", "Elem8", "Elem9"])
        wait()
        self.assertEqual(set(display.selection.elements), {2, 7, 8})
        FreeCADGui.Selection.removeSelection(self.document.Name, self.mesh.Name, "Elem8")
        wait()
        self.assertEqual(set(display.selection.elements), {2, 8})
        self.mesh.Size = 20
        self.run_mesh()
        self.assertLessEqual(set(display.selection.elements), set(range(display.mesh.count)))

    def test_going_to_an_element(self):
        display = self.run_mesh()
        actions.go_to(self.mesh, "Elem7")
        wait(100)
        self.assertEqual((display.selected, display.reported), ((6,), 6))
        width, height = self.view.getSize()
        self.assertEqual(self.view.getObjectInfo((width // 2, height // 2))["Component"], "Elem7")


class Buttons(display_cases.InWindow):
    def press(self, name):
        FreeCADGui.runCommand(name)
        wait()

    def test_each_is_one_step_of_undo_and_what_scripts_call(self):
        FreeCADGui.activateWorkbench("PaverWorkbench")
        for name in view.COMMANDS:
            self.assertFalse(FreeCADGui.Command.get(name).isActive(), name)
        self.run_mesh()
        vobj = self.mesh.ViewObject
        for name, what, off, on in (("Paver_ShowWorst", "ShowWorst", 0, 10), ("Paver_Shrink", "ShrinkFactor", 1, 0.75),
                                    ("Paver_ShowFreeEdges", "ShowFreeEdges", False, True),
                                    ("Paver_ShowTriangles", "ShowTriangles", False, True),
                                    ("Paver_ShowNormals", "ShowNormals", False, True)):
            self.document.clearUndos()
            self.press(name)
            self.assertEqual((getattr(vobj, what), len(self.document.UndoNames)), (on, 1), name)
            self.press(name)
            self.assertEqual((getattr(vobj, what), len(self.document.UndoNames)), (off, 2), name)
            self.document.undo()
            wait()
            self.assertEqual(getattr(vobj, what), on, name)
            self.document.undo()
            self.assertEqual(getattr(vobj, what), off, name)
        self.assertEqual([what for what, _ in view.COLOURS.values()], list(colouring.CHOICES))
        for name, (what, _) in view.COLOURS.items():
            self.press(name)
            self.assertEqual(vobj.ColourBy, what)
