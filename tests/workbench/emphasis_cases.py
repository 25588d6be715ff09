"""Labels that stand apart, rings, and parts of a mesh alone; see display_cases.py. The dialog of a check; see
commands_cases.py."""
import math
import os
import tempfile

import FreeCAD
import FreeCADGui
import numpy as np
import Part
from PySide import QtCore, QtGui

import commands_cases
import display_cases
import drawing
import window
from display_cases import wait
from display_pick_cases import WithPlaces
from paver_wb import mesh_check, mesh_object, meshing
from paver_wb.gui.base import measuring
from paver_wb.gui.commands import view
from paver_wb.gui.display import actions
from paver_wb.gui.display.emphasis import isolation, labels, rings


def is_ring(picture):
    red, green, blue = np.moveaxis(picture, -1, 0)
    return (red > 200) & (green < 40) & (blue > 90) & (blue < 150)


def wedge(degrees):
    """A body with elements as poor as its edge is sharp."""
    corners = [(0, 0), (100, 0), (100, 100 * math.tan(math.radians(degrees)))]
    face = Part.Face(Part.makePolygon([FreeCAD.Vector(*at) for at in (*corners, corners[0])]))
    return face.extrude(FreeCAD.Vector(0, 0, 20))


class LabelsApart(display_cases.InWindow):
    def overlaps(self, shown):
        low, high = shown.corners, shown.corners + shown.sizes
        meet = (low[:, None] < high[None]).all(axis=2) & (low[None] < high[:, None]).all(axis=2)
        return int(meet.sum() - len(low))

    def test_labels_at_one_place_do_not_overlap_from_near_and_far(self):
        display = self.run_mesh()
        self.set(ShowWorst=15)
        heights = []
        for height in (2000, 60, 3):
            self.look()
            self.view.getCameraNode().height = height
            wait(100)
            self.picture(f"labels_{height}")
            self.assertEqual((len(display.labels.corners), self.overlaps(display.labels)), (15, 0))
            heights.append(np.ptp(display.labels.corners[:, 1]))
        self.assertGreater(heights[0], 14 * display.labels.sizes[0, 1], "a column, as all points are one")

    def test_the_camera_makes_no_room_for_labels(self):
        self.run_mesh()
        self.look()
        before = self.view.getCameraNode().height.getValue()
        self.set(ShowWorst=20)
        self.view.getCameraNode().height = 1000
        wait(100)
        self.look()
        self.assertAlmostEqual(self.view.getCameraNode().height.getValue(), before, delta=0.02 * before)

    def test_apart(self):
        sizes = np.full((4, 2), (30.0, 10.0))
        made = labels.apart([(0, 0), (5, 5), (100, 0), (190, 0)], sizes, np.array([200, 100]))
        np.testing.assert_array_equal(made[[0, 2]], [(0, 0), (100, 0)])
        self.assertEqual(tuple(made[1]), (5, 10 + labels.GAP))
        self.assertEqual(tuple(made[3]), (170, 0), "inside the view")


class Rings(display_cases.InWindow):
    def test_a_ring_is_seen_where_the_element_is_too_small(self):
        display = self.run_mesh()
        self.set(ColourBar=False)
        self.look()
        self.view.getCameraNode().height = 3000
        wait(100)
        self.assertFalse(is_ring(self.picture("rings_none")).any())
        actions.ring(self.mesh, ["Elem1"])
        wait(100)
        seen = np.argwhere(is_ring(self.picture("rings_one")))
        size = np.ptp(seen, axis=0)
        self.assertTrue((abs(size - rings.DIAMETER) < 8).all(), size)
        self.mesh.Size = 4
        self.run_mesh()
        self.assertEqual(len(display.rings.places), 0, "it was about the mesh of before")

    def test_many_places_have_a_ring_near(self):
        places = np.random.default_rng(1).random((5000, 3)) * (100, 100, 0)
        few = rings.spread(places)
        self.assertLessEqual(len(few), rings.MOST_RINGS)
        nearest = np.linalg.norm(places[:, None] - few[None], axis=2).min(axis=1)
        self.assertLess(nearest.max(), 40)
        self.assertEqual(len(rings.spread(places[:7])), 7)

    def test_going_to_an_element_shows_it_in_the_middle_with_a_ring(self):
        display = self.run_mesh()
        self.set(ColourBar=False)
        actions.go_to(self.mesh, "Elem7")
        wait(100)
        np.testing.assert_array_equal(display.rings.places, display.mesh.centres[[6]])
        seen = np.argwhere(is_ring(self.picture("rings_go_to")))
        np.testing.assert_allclose((seen.min(axis=0) + seen.max(axis=0)) / 2, (350, 450), atol=6)

    def test_looking_at_several_elements_has_all_in_sight(self):
        self.mesh.Size = 1
        display = self.run_mesh()
        self.set(ColourBar=False)
        for names in (["Elem3", "Elem4", "Elem40"], [f"Elem{n}" for n in range(1, display.mesh.count + 1)]):
            actions.look_at(self.mesh, names)
            wait(100)
            width, height = self.view.getSize()
            for name in names[::50] or names:
                x, y = self.view.getPointOnScreen(FreeCAD.Vector(*actions.element(self.mesh, name)["centre"]))
                self.assertTrue(0 < x < width and 0 < y < height, name)
        self.assertRaisesRegex(ValueError, "has no element Elem0", actions.look_at, self.mesh, ["Elem0"])


class Isolation(WithPlaces):
    def drawn(self, display):
        """Numbers of the elements whose triangles are drawn."""
        rows = drawing.content(display.scene.face_set.coordIndex, np.int32).reshape(-1, 4)[:, :3]
        return set(display.mesh.per_point(np.arange(display.mesh.count), display.subdivision)[rows].ravel())

    def boxes(self):
        """A mesh of two boxes that touch, A and B."""
        made = []
        for name, x in (("A", 0), ("B", 10)):
            made.append(self.document.addObject("Part::Box", name))
            made[-1].Placement.Base.x = x
        self.document.recompute()
        self.mesh = mesh_object.add(self.document, made, size=4)
        return self.run_mesh()

    def faces_drawn(self, display):
        return {display.mesh.face_names[display.mesh.faces[e]] for e in self.drawn(display)}

    def test_faces_and_objects_are_hidden_and_shown_again(self):
        display = self.boxes()
        every = set(display.mesh.face_names[f] for f in display.mesh.faces)
        between = "A/Face2 + B/Face1"
        self.assertIn(between, every)
        of = {name: {face for face in every if face.startswith(name) and face != between} for name in "AB"}
        for act, names, left in ((actions.hide, ["A"], of["B"] | {between}), (actions.hide, ["B/Face6"], None),
                                 (actions.show_only, ["A"], of["A"]), (actions.show_only, ["A/Face6"], {"A/Face6"}),
                                 (actions.show_only, ["B/Face1"], {between})):
            act(self.mesh, names)
            wait()
            self.assertEqual(self.faces_drawn(display), of["B"] - {"B/Face6"} | {between} if left is None else left, names)
        self.picture("isolated_face")
        actions.show_everything(self.mesh)
        wait()
        self.assertEqual(self.faces_drawn(display), every)
        with self.assertRaisesRegex(ValueError, "no face or object C"):
            actions.hide(self.mesh, ["C"])

    def test_elements_alone_and_marks_follow(self):
        display = self.run_mesh()
        worst = actions.isolate_worst(self.mesh, 4)
        wait()
        self.assertEqual(self.drawn(display), {int(name[4:]) - 1 for name in worst})
        self.set(ShowWorst=6)
        self.assertEqual(len(self.drawn(display)), 6)
        actions.isolate(self.mesh, ["Elem2", "Elem5"])
        actions.show_normals(self.mesh)
        wait()
        self.assertEqual(self.drawn(display), {1, 4})
        self.assertEqual((display.normals.count, set(display.worst.elements) - {1, 4}), (2, set()))
        lines = drawing.content(display.scene.lines.coordIndex, np.int32)
        self.assertEqual((lines == -1).sum(), 2)
        self.mesh.Size = 4
        self.run_mesh()
        self.assertEqual(self.mesh.ViewObject.Isolate, isolation.EVERYTHING, "the numbers mean other elements")
        self.assertEqual(len(self.drawn(display)), display.mesh.count)

    def test_free_edges_alone(self):
        with self.assertRaisesRegex(ValueError, "no free edges"):
            self.run_mesh()
            actions.isolate_free_edges(self.mesh)
        plane = self.document.addObject("Part::Plane", "Plane")
        self.document.recompute()
        self.mesh = self.add(plane, size=3)
        display = self.run_mesh()
        actions.isolate_free_edges(self.mesh)
        wait()
        self.assertEqual((self.drawn(display), display.bar.switch.whichChild.getValue()), (set(), -1))
        self.assertEqual(display.free.count, mesh_object.stored(self.mesh).report["quality"]["border_edges"])
        self.look()
        self.picture("isolated_free_edges")

    def test_hidden_elements_are_not_picked(self):
        display = self.run_mesh()
        self.look()
        element = int(self.facing(display)[2])
        place = self.place_of(display, element)
        self.assertEqual(self.view.getObjectInfo(place)["Component"], f"Elem{element + 1}")
        others = [f"Elem{e + 1}" for e in range(display.mesh.count) if e != element and e not in self.facing(display)]
        actions.isolate(self.mesh, others)
        wait()
        self.assertIn(self.view.getObjectInfo(place)["Component"], others, "what lies behind")
        actions.isolate(self.mesh, [f"Elem{element + 1}"])
        wait()
        self.assertEqual(self.view.getObjectInfo(place)["Component"], f"Elem{element + 1}")

    def test_what_is_hidden_is_shown_when_one_goes_there(self):
        display = self.run_mesh()
        actions.isolate(self.mesh, ["Elem2"])
        actions.go_to(self.mesh, "Elem5")
        wait()
        self.assertIn(4, self.drawn(display))

    def test_it_is_saved(self):
        display = self.boxes()
        actions.hide(self.mesh, ["A"])
        actions.isolate(self.mesh, [f"Elem{n}" for n in range(1, display.mesh.count + 1)])
        wait()
        drawn, name = self.faces_drawn(display), self.mesh.Name
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "made.FCStd")
            self.document.saveAs(path)
            FreeCAD.closeDocument(self.document.Name)
            self.document = FreeCAD.openDocument(path)
            self.mesh = self.document.getObject(name)
            wait(100)
            self.assertEqual(self.mesh.ViewObject.Isolate, isolation.LISTED)
            self.assertEqual(self.faces_drawn(self.display()), drawn)


class IsolateCommands(commands_cases.WithCommands):
    def test_every_choice_is_one_step_of_undo_and_in_the_console(self):
        mesh = self.mesh()
        commands_cases.select((mesh, "Elem3"), (mesh, "Elem60"))
        for name, (function, *_) in view.ISOLATES.items():
            if name == "Paver_OnlyFreeEdges":
                continue  # a box has none
            self.document.clearUndos()
            FreeCADGui.runCommand(name)
            self.assertEqual(self.complaint(), "", name)
            self.assertIn(f"paver_wb.gui.display.actions.{function}(", self.console())
            self.assertEqual(self.document.UndoNames, ["Isolate"], name)
        self.assertEqual((mesh.ViewObject.Isolate, mesh.ViewObject.HiddenFaces), (isolation.EVERYTHING, []))
        FreeCADGui.runCommand("Paver_OnlyFreeEdges")
        self.assertIn("has no free edges", self.complaint())
        commands_cases.select(mesh)
        FreeCADGui.runCommand("Paver_HideFaces")
        self.assertIn("Nothing of the mesh is selected", self.complaint())

    def test_a_mesh_that_cannot_be_read_is_told(self):
        mesh = self.mesh()
        commands_cases.select((mesh, "Elem3"))
        with tempfile.TemporaryDirectory() as folder:
            with open(os.path.join(folder, "damaged"), "wb") as file:
                file.write(b"nothing")
            mesh_object.keep(mesh, file.name)
        FreeCADGui.runCommand("Paver_HideFaces")
        self.assertIn("cannot be read", self.complaint())

    def test_faces_are_those_of_elements_or_of_the_model(self):
        mesh = self.mesh()
        stored = mesh_object.stored(mesh)
        commands_cases.select((mesh, "Elem3"), (self.box, "Face6"))
        names = {stored.face_names[stored.quad_faces[2]], "Face6"}
        self.assertEqual(set(actions.faces_of_selection(mesh)), names)
        other = self.document.addObject("Part::Box", "Other")
        other.Placement.Base.x = 30
        self.document.recompute()
        mesh.MoreParts = [other]
        meshing.mesh(mesh)
        commands_cases.select((self.box, "Face6"), other)
        self.assertEqual(set(actions.faces_of_selection(mesh)), {"Box/Face6", "Other"})


class CheckDialog(commands_cases.WithCommands):
    """Findings are found."""

    def setUp(self):
        super().setUp()
        source = self.document.addObject("Part::Feature", "Wedge")
        source.Shape = wedge(3)
        self.made = mesh_object.add(self.document, source, size=3)
        self.document.recompute()
        meshing.mesh(self.made)
        commands_cases.select(self.made)
        FreeCADGui.runCommand("Paver_Check")
        self.panel = window.widget("Paver_CheckPanel", QtGui.QDialog)
        self.wait()
        self.display = self.made.ViewObject.Proxy.display

    def tearDown(self):
        if window.widget("Paver_CheckPanel"):
            self.panel.close()
        super().tearDown()
        window.wait(lambda: not measuring._open, "for the dialog to close")

    def wait(self):
        window.wait(lambda: self.panel.findings and not self.panel.busy.isVisible(), "for the check")

    def test_it_closes_with_its_document(self):
        FreeCAD.closeDocument(self.document.Name)
        window.wait(lambda: window.widget("Paver_CheckPanel") is None, "for the dialog to close")

    def click(self, words):
        """Clicks on the finding with these words, and gives it."""
        number, = (i for i, finding in enumerate(self.panel.findings) if words in finding.text)
        item = self.panel.list.item(number)
        window.QTest.mouseClick(self.panel.list.viewport(), QtCore.Qt.LeftButton, QtCore.Qt.NoModifier,
                                self.panel.list.visualItemRect(item).center())
        window.pause(50)
        return self.panel.findings[number]

    def text(self, name):
        return window.widget("Paver_" + name, QtGui.QLabel).text()

    def test_a_click_goes_there_and_next_through_all(self):
        finding = self.click("scaled Jacobian below")
        count = len(finding.elements)
        self.assertGreater(count, 1)
        centres = self.display.mesh.centres
        np.testing.assert_array_equal(self.display.rings.places, centres[[n - 1 for n in finding.elements]])
        self.assertEqual(set(self.display.selected), {n - 1 for n in finding.elements})
        self.assertEqual(self.text("CheckCount"), f"{count} elements")
        self.assertLess(self.view_height(), 60)
        for number, element in [*enumerate(finding.elements, 1), (1, finding.elements[0])]:
            window.click(window.widget("Paver_CheckNext", QtGui.QPushButton))
            window.pause(30)
            self.assertEqual(self.text("CheckCount"), f"{number} of {count}")
            self.assertIn(f"Elem{element},", self.text("CheckFigures"))
            self.assertEqual(self.display.selected, (element - 1,))
        window.picture("check_next")
        window.click(window.widget("Paver_CheckPrevious", QtGui.QPushButton))
        self.assertEqual(self.text("CheckCount"), f"{count} of {count}")
        self.assertIn("paver_wb.gui.display.actions.go_to(", self.console())
        least = [self.display.mesh.quality.sj[n - 1] for n in finding.elements]
        self.assertEqual(least, sorted(least), "the worst first")
        self.panel.close()
        window.pause(50)
        self.assertEqual(len(self.display.rings.places), 0)

    def view_height(self):
        return FreeCADGui.ActiveDocument.ActiveView.getCameraNode().height.getValue()

    def test_the_number_of_an_element(self):
        field = window.widget("Paver_CheckElement", QtGui.QLineEdit)
        window.type_into(field, "12")
        window.pause(50)
        self.assertTrue(self.panel.isVisible(), "Return does not close the dialog")
        self.assertEqual(self.display.selected, (11,))
        self.assertIn("Elem12,", self.text("CheckFigures"))
        window.type_into(field, "999999")
        self.assertIn("has no element Elem999999; it has Elem1 to", self.text("CheckFigures"))

    def test_the_elements_of_a_finding_alone(self):
        finding = self.click("are triangles")
        box = window.widget("Paver_CheckIsolate", QtGui.QCheckBox)
        self.document.clearUndos()
        box.setChecked(True)
        window.pause(50)
        self.assertEqual(self.made.ViewObject.IsolatedElements, list(finding.elements))
        self.assertEqual(set(np.flatnonzero(self.display.shown.elements)), {n - 1 for n in finding.elements})
        self.assertEqual(self.document.UndoNames, ["Isolate"])
        window.picture("check_isolated")
        self.click("scaled Jacobian below")
        self.assertFalse(box.isChecked())
        self.assertEqual(self.made.ViewObject.Isolate, isolation.EVERYTHING)
        box.setChecked(True)
        self.panel.close()
        window.pause(50)
        self.assertEqual(self.made.ViewObject.Isolate, isolation.EVERYTHING)

    def test_it_leaves_the_middle_of_the_view_free(self):
        area = FreeCADGui.getMainWindow().centralWidget()
        self.assertFalse(self.panel.frameGeometry().contains(area.mapToGlobal(area.rect().center())))
        screen = QtGui.QApplication.primaryScreen().availableVirtualGeometry()
        self.assertTrue(screen.contains(self.panel.frameGeometry()))

    def test_what_has_no_elements_goes_nowhere(self):
        self.click("are proven not to fold")
        self.assertFalse(window.widget("Paver_CheckNext", QtGui.QPushButton).isEnabled())
        self.assertEqual((len(self.display.rings.places), self.text("CheckCount")), (0, ""))

    def test_it_follows_the_mesh(self):
        self.made.Size = 2
        window.wait(lambda: any("out of date" in finding.text for finding in self.panel.findings), "for the new state")
        meshing.mesh(self.made)
        window.wait(lambda: not any("out of date" in finding.text for finding in self.panel.findings), "for the new mesh")
        self.wait()
        self.document.removeObject(self.made.Name)
        window.wait(lambda: not measuring._open, "for the dialog to close")

    def test_a_face_that_failed_has_a_ring(self):
        bow_tie = Part.Face(Part.makePolygon([FreeCAD.Vector(x, y) for x, y in ((0, 0), (10, 10), (10, 0), (2, 9), (0, 0))]))
        self.made.Part.Shape = Part.makeCompound([bow_tie, Part.makePlane(50, 50, FreeCAD.Vector(30, 0, 0))])
        self.document.recompute()
        meshing.mesh(self.made)
        window.wait(lambda: any("is not meshed" in finding.text for finding in self.panel.findings), "for the new mesh")
        self.wait()
        finding = self.click("is not meshed")
        self.assertEqual(finding.level, mesh_check.ERROR)
        np.testing.assert_allclose(self.display.rings.places, finding.places)
        window.picture("check_failed")
