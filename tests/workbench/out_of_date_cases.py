"""A mesh that does not fit what it was made of, as it is seen in FreeCAD's window. Runs there: display_test.py and
commands_test.py."""
import os
import tempfile

import FreeCAD
import FreeCADGui
import numpy as np
from PySide import QtCore, QtGui

import commands_cases
import display_cases
import window
from display_cases import is_coloured, wait
from paver_wb import mesh_object, meshing
from paver_wb.gui import run_control
from paver_wb.gui.commands import export_question, files
from paver_wb.gui.view_provider import STATE_ICONS


def is_banner(picture):
    red, green, blue = np.moveaxis(picture, -1, 0)
    return (red > 200) & (green > 180) & (blue < 190) & (blue > 100)


class OutOfDateView(display_cases.InWindow):
    def icon(self):
        return os.path.basename(self.mesh.ViewObject.Proxy.getIcon())

    def resize(self, radius):
        self.document.openTransaction("Radius")
        self.sphere.Radius = radius
        self.document.recompute()
        self.document.commitTransaction()
        wait(100)

    def test_an_old_mesh_is_grey_under_a_banner_until_it_is_so_no_longer(self):
        display = self.run_mesh()
        self.look()
        fresh = self.picture("state_fresh")
        self.assertEqual((display.banner.text, is_banner(fresh[:60, 300:600]).any()), ("", False))
        self.resize(8)
        self.assertEqual(display.banner.text, "Out of date: PaverMesh\nchanged: a shape; mesh again")
        old = self.picture("state_old")
        self.assertLess(is_coloured(old[100:]).mean(), 0.001)
        self.assertGreater(is_banner(old[:60, 300:600]).mean(), 0.1)
        self.assertFalse(is_banner(old[60:]).any())
        self.document.undo()
        wait(100)
        self.assertEqual(display.banner.text, "")
        np.testing.assert_array_equal(self.picture("state_undone"), fresh)
        self.document.redo()
        wait(100)
        self.assertTrue(display.banner.text)
        self.mesh.Size = 4
        wait(100)
        self.assertIn("a shape, Size", display.banner.text)
        self.run_mesh()
        self.assertEqual(display.banner.text, "")
        self.assertGreater(is_coloured(self.picture("state_again")).mean(), 0.1)

    def test_banners_are_of_meshes_that_are_seen_one_below_the_other(self):
        other = self.add(self.sphere, size=4)
        for mesh in (self.mesh, other):
            self.run_mesh(mesh)
            mesh.Size = 2
        wait(100)
        banners = [self.display(mesh).banner for mesh in (self.mesh, other)]
        self.assertEqual([banner.row for banner in banners], [0, 1])
        self.look()
        self.assertGreater(is_banner(self.picture("state_two"))[60:100, 300:600].mean(), 0.1)
        self.mesh.ViewObject.Visibility = False
        wait(100)
        self.assertEqual((banners[0].text, banners[1].row), ("", 0))
        other.ViewObject.DisplayMode = "Faces"
        other.Label = "Other"
        wait(100)
        self.assertIn("Other", banners[1].text)
        self.assertTrue(is_banner(self.picture("state_fem")).any(), "in FEM's display modes too")
        self.mesh.ViewObject.Visibility = True
        wait(100)
        self.assertEqual([banner.row for banner in banners], [0, 1])
        self.document.removeObject(self.mesh.Name)
        self.mesh = other
        wait(100)
        self.assertEqual(banners[1].row, 0)

    def test_an_app_part_that_is_moved_makes_it_old_and_undo_makes_it_good(self):
        part = self.document.addObject("App::Part", "Assembly")
        part.addObject(self.sphere)
        self.document.recompute()
        display = self.run_mesh()
        self.document.openTransaction("Move")
        part.Placement.Base.x = 5
        self.document.commitTransaction()
        window.wait(lambda: self.mesh.Status == "Out of date", "for the state")
        wait(100)
        self.assertTrue(display.banner.text)
        for step, status in ((self.document.undo, "Up to date"), (self.document.redo, "Out of date"),
                             (self.document.undo, "Up to date")):
            step()
            window.wait(lambda status=status: self.mesh.Status == status, "for the state")
        self.assertEqual(self.document.RedoNames, ["Move"])

    def test_the_icon_tells_the_state(self):
        icons = [self.icon()]
        self.run_mesh()
        icons.append(self.icon())
        self.resize(8)
        icons.append(self.icon())
        self.document.undo()
        icons.append(self.icon())
        self.mesh.FailedFaces = ["Face1: it cannot be meshed"]
        icons.append(self.icon())
        states = [mesh_object.NOT_MESHED, mesh_object.UP_TO_DATE, mesh_object.OUT_OF_DATE, mesh_object.UP_TO_DATE,
                  mesh_object.FACES_FAILED]
        self.assertEqual(icons, [STATE_ICONS[state] for state in states])
        self.assertEqual(len(set(icons)), 4)
        for icon in set(icons):
            self.assertFalse(QtGui.QIcon(os.path.join(os.path.dirname(self.mesh.ViewObject.Proxy.getIcon()), icon))
                             .pixmap(16, 16).isNull())

    def tree_icon(self):
        """The picture in the tree, as numbers."""
        window.tree_dock()
        window.pause(400)  # FreeCAD fills its tree late
        for tree in window.widgets(QtGui.QTreeWidget):
            for item in tree.findItems(self.mesh.Label, QtCore.Qt.MatchExactly | QtCore.Qt.MatchRecursive):
                image = item.icon(0).pixmap(16, 16).toImage().convertToFormat(QtGui.QImage.Format_RGBA8888)
                return bytes(image.constBits())
        raise AssertionError("the mesh is in no tree that is seen")

    def test_the_tree_follows(self):
        self.document.recompute()
        empty = self.tree_icon()
        self.run_mesh()
        fresh = self.tree_icon()
        self.resize(8)
        old = self.tree_icon()
        self.assertEqual(len({empty, fresh, old}), 3)
        self.document.undo()
        self.assertEqual(self.tree_icon(), fresh)
        name = self.mesh.Name
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "made.FCStd")
            self.document.recompute()
            self.document.saveAs(path)
            FreeCAD.closeDocument(self.document.Name)
            self.document = FreeCAD.openDocument(path)
            self.mesh = self.document.getObject(name)
        self.assertEqual(self.tree_icon(), fresh)


class OldExport(commands_cases.WithCommands):
    """The question before the export of an old mesh."""

    def setUp(self):
        super().setUp()
        self.made, self.asked = self.mesh(), []
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.path = os.path.join(folder.name, "mesh.msh")

    def export(self, answer=None):
        """What the command does once a file is chosen; `answer` is clicked."""
        def click():
            box = window.widget("Paver_ExportQuestion", QtGui.QMessageBox)
            if box is not None:
                self.asked.append(box.text())
                window.picture("export_question")
                window.click(window.widget("Paver_Export_" + answer, QtGui.QPushButton))
        if answer:
            QtCore.QTimer.singleShot(300, click)
        files.Export().ask_and_write(self.made, self.path, {})
        window.wait(lambda: not run_control._runs, "for a run")
        window.pause(50)
        self.wait_for_tasks()

    def test_a_good_mesh_is_written_without_a_question(self):
        self.export()
        self.assertTrue(os.path.isfile(self.path))

    def test_the_answers(self):
        quads = self.made.Quads
        self.made.Size = 1
        self.export(export_question.CANCEL)
        self.assertFalse(os.path.exists(self.path))
        self.export(export_question.EXPORT)
        self.assertTrue(os.path.isfile(self.path))
        self.assertEqual((self.made.Quads, self.made.Status), (quads, "Out of date"))
        os.remove(self.path)
        self.export(export_question.MESH)
        self.assertTrue(os.path.isfile(self.path))
        self.assertEqual(self.made.Status, "Up to date")
        self.assertGreater(self.made.Quads, quads)
        self.assertEqual(self.document.UndoNames, ["Mesh PaverMesh"])
        self.assertTrue(all("is out of date (changed: Size; mesh again)" in text for text in self.asked))
        self.assertEqual(len(self.asked), 3)
        self.assertIn("paver_wb.gui.file_tasks.mesh_and_export(", self.console())

    def test_shapes_that_have_moved_unseen_are_noticed(self):
        part = self.document.addObject("App::Part", "Assembly")
        part.addObject(self.box)
        self.document.recompute()
        meshing.mesh(self.made)
        part.Placement.Base.x = 5
        self.export(export_question.CANCEL)
        self.assertEqual((len(self.asked), os.path.exists(self.path)), (1, False))

    def test_a_mesh_with_holes_is_asked_about_and_not_meshed_the_same_again(self):
        self.made.FailedFaces = ["PCB: top/Face3 + Face1: no: end", "Face4: it cannot be meshed"]
        self.export(export_question.CANCEL)
        self.assertIn("has holes: PCB: top/Face3 + Face1, Face4 could", self.asked[0])
        self.assertFalse(os.path.exists(self.path))
        self.export(export_question.EXPORT)
        self.assertTrue(os.path.isfile(self.path))
        self.assertIsNone(window.widget("Paver_Export_mesh"))

    def test_a_run_that_fails_writes_nothing(self):
        self.made.Size, self.made.MaxElements = 0.1, 10
        self.export(export_question.MESH)
        self.assertFalse(os.path.exists(self.path))
        FreeCADGui.Selection.clearSelection()
