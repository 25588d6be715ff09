"""Drawings through undo, saving, copying and deleting; see display_cases.py."""
import gc
import os
import re
import tempfile
import weakref

import FreeCAD
import FreeCADGui
import numpy as np

import display_cases
import window
from display_cases import is_coloured, wait
from paver_wb import mesh_object, meshing
from paver_wb.gui.base import background, first_view
from paver_wb.gui.display import actions, colouring, mesh_display, view_properties


class Life(display_cases.InWindow):
    def expect_shown(self, display):
        self.assertEqual(display.mesh.count, self.mesh.Quads + self.mesh.Triangles)
        self.assertEqual(len(self.triangles_drawn(display)),
                         (2 * self.mesh.Quads + self.mesh.Triangles) * display.subdivision ** 2)

    def test_undo_and_redo(self):
        display = self.run_mesh()
        first = display.mesh.count
        self.document.openTransaction("size")
        self.mesh.Size = 2
        self.document.commitTransaction()
        self.run_mesh()
        second = display.mesh.count
        self.assertGreater(second, first)
        self.expect_shown(display)
        for step, count in ((self.document.undo, first), (self.document.redo, second), (self.document.undo, first)):
            step()
            wait()
            self.assertEqual(display.mesh.count, count)
            self.expect_shown(display)
        self.document.undo()
        self.document.undo()
        wait()
        self.assertEqual(self.mesh.Status, "Not meshed")
        self.assertIsNone(display.mesh)
        self.assertEqual(len(self.triangles_drawn(display)), 0)

    def expect_reading(self, display):
        """What FreeCAD's event loop would do first begins to read the mesh."""
        display.update_later()
        self.assertTrue(display.loading)
        self.assertIsNone(display.mesh)

    def test_large_meshes_are_read_beside_the_window(self):
        self.mesh.Size = 0.25
        meshing.mesh(self.mesh)
        self.assertGreater(self.mesh.Quads, mesh_display.HEAVY)
        display = self.display()
        self.expect_reading(display)
        window.wait(lambda: display.mesh, "for the mesh")
        wait()
        self.expect_shown(display)
        self.document.undo()
        wait()
        self.document.redo()
        self.expect_reading(display)
        self.assertEqual(actions.show_triangles(self.mesh), self.mesh.Triangles, "scripts get what they ask for at once")
        self.expect_shown(display)
        self.document.undo()
        wait()
        self.document.redo()
        self.expect_reading(display)
        self.document.undo()
        window.wait(lambda: not background._running, "for the thread")
        wait()
        self.assertIsNone(display.mesh)
        self.assertEqual(len(self.triangles_drawn(display)), 0)
        self.document.redo()
        self.expect_reading(display)
        FreeCAD.closeDocument(self.document.Name)
        window.wait(lambda: not background._running, "for the thread")
        self.document = FreeCAD.newDocument("PaverDisplay")

    def test_what_is_chosen_is_saved(self):
        self.run_mesh()
        chosen = {"DisplayMode": mesh_display.CURVED, "ColourBy": colouring.FACE, "ColourMap": "Rainbow",
                  "ColourRange": "Manual", "RangeLow": 0.25, "RangeHigh": 0.5, "ShrinkFactor": 0.7, "ShowWorst": 3,
                  "ShowNormals": True, "Subdivision": 4, "ColourBar": False}
        self.set(**chosen)
        name, documentation = self.mesh.Name, self.mesh.ViewObject.getDocumentationOfProperty("ShowWorst")
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "made.FCStd")
            self.document.saveAs(path)
            FreeCAD.closeDocument(self.document.Name)
            self.document = FreeCAD.openDocument(path)
            self.mesh = self.document.getObject(name)
            wait(100)
            self.expect_shown(self.display())
        for what, value in chosen.items():
            self.assertEqual(getattr(self.mesh.ViewObject, what), value, what)
        self.assertEqual(self.mesh.ViewObject.getEnumerationsOfProperty("ColourBy"), list(colouring.CHOICES))
        self.assertEqual(self.mesh.ViewObject.getDocumentationOfProperty("ShowWorst"), documentation)
        self.assertEqual((self.display().subdivision, len(self.display().worst.elements)), (4, 3))

    def open_headless(self, path=None):
        """Opens the document that was made without a window, or another one; its view."""
        path = path or os.environ.get("PAVER_HEADLESS_DOCUMENT")
        if not path:
            self.skipTest("no document from a FreeCAD without a window")
        document = FreeCAD.openDocument(path)
        name = document.Name
        self.addCleanup(lambda: name in FreeCAD.listDocuments() and FreeCAD.closeDocument(name))
        self.mesh, = mesh_object.meshes_of(document)
        self.view = FreeCADGui.getDocument(document.Name).ActiveView
        return document

    def test_a_document_made_without_a_window_is_seen_whole(self):
        self.open_headless()
        wait(500)
        self.assertEqual(self.mesh.ViewObject.DisplayMode, mesh_display.CURVED_EDGES)
        self.assertTrue(self.mesh.ViewObject.Visibility)
        self.expect_shown(self.display())
        window.wait(self.is_seen_whole, "for the view to show the mesh whole")

    def is_seen_whole(self):
        coloured = is_coloured(self.picture("headless"))
        rim = np.concatenate([coloured[0], coloured[-1], coloured[:, -1]])  # the colour bar is at the left
        return coloured.mean() > 0.1 and not rim.any()

    def turn(self):
        """Turns the camera at once: other ways may take FreeCAD a moment."""
        self.view.setCamera(re.sub(r"orientation .*", "orientation 0.6 0 0.8 0.7", self.view.getCamera()))

    def seen(self):
        """Orientation and height of the camera."""
        _, *axis, angle = first_view.camera_of(self.view)[1].split()
        return [round(float(number), 3) for number in (*axis, angle, first_view.camera_of(self.view)[2].split()[1])]

    def test_a_view_that_was_chosen_or_saved_stays(self):
        document = self.open_headless()
        self.turn()
        wait(500)
        self.assertEqual(self.seen()[:4], [0.6, 0, 0.8, 0.7], "chosen at once")
        self.look()
        wait(500)
        self.turn()
        seen = self.seen()
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "seen.FCStd")
            document.saveAs(path)
            self.assertTrue(first_view.has_view(document))
            FreeCAD.closeDocument(document.Name)
            self.open_headless(path)
            wait(500)
        self.assertEqual(self.seen(), seen, "saved")
        self.assertEqual(self.seen()[:4], [0.6, 0, 0.8, 0.7])

    def test_a_copy_has_a_drawing_of_its_own(self):
        self.run_mesh()
        self.set(ColourBy=colouring.FACE)
        copy = self.document.copyObject(self.mesh)
        wait(100)
        self.assertIsNot(self.display(copy), self.display())
        self.assertEqual(copy.ViewObject.DisplayMode, mesh_display.CURVED_EDGES)
        self.mesh = copy
        self.expect_shown(self.display())

    def test_a_deleted_mesh_is_forgotten(self):
        display = self.run_mesh()
        actions.select(self.mesh, ["Elem1"])
        display.changed(mesh_display.MESH)
        self.document.removeObject(self.mesh.Name)
        wait(100)
        self.document.undo()
        wait(100)
        self.mesh, = mesh_object.meshes_of(self.document)
        self.expect_shown(self.display())

    def test_a_closed_document_leaves_no_memory(self):
        self.run_mesh()
        name = self.mesh.Name
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "made.FCStd")
            self.document.saveAs(path)
            for _ in ("made", "opened"):
                wait(100)
                display = self.display()
                self.view.getObjectInfo((10, 10))
                left = [weakref.ref(one) for one in (display.mesh, display.picker, display.scene)]
                fields = [display.scene.points.point, display.scene.normals.vector, display.scene.packed.orderedRGBA,
                          display.scene.face_set.coordIndex, display.scene.lines.coordIndex]
                self.assertGreater(min(field.getNum() for field in fields), 100)
                del display, self.mesh, self.sphere, self.view
                FreeCAD.closeDocument(self.document.Name)
                wait(100)
                gc.collect()
                self.document = FreeCAD.openDocument(path)
                self.assertEqual([one() for one in left], [None] * 3)
                self.assertEqual([field.getNum() for field in fields], [0] * 5)
                self.mesh, self.sphere = self.document.getObject(name), None
                self.view = FreeCADGui.ActiveDocument.ActiveView

    def test_inside_of_a_group(self):
        group = self.document.addObject("App::DocumentObjectGroup", "Group")
        group.addObject(self.mesh)
        display = self.run_mesh()
        self.look()
        FreeCADGui.Selection.addSelection(self.document.Name, group.Name, self.mesh.Name + ".Elem4")
        wait()
        self.assertEqual(display.selection.elements, (3,))

    def test_actions_on_what_is_not_meshed(self):
        for action in (actions.show_worst, actions.show_free_edges, actions.show_triangles):
            self.assertRaisesRegex(ValueError, "mesh it first", action, self.mesh)

    def test_every_property_is_explained(self):
        vobj = self.mesh.ViewObject
        for name, (_, group, tooltip, *_) in view_properties.PROPERTIES.items():
            self.assertEqual((vobj.getGroupOfProperty(name), vobj.getDocumentationOfProperty(name)), (group, tooltip))
