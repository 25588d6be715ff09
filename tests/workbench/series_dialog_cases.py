"""Series beside the window, and their dialog. Runs in FreeCAD's window: commands_test.py."""
import os
import tempfile

import FreeCAD
import FreeCADGui
from PySide import QtCore, QtGui

import window
from child_cases import children
from commands_cases import WithCommands, select
from paver_wb import mesh_object, refinement, series
from paver_wb.gui import run_control
from paver_wb.gui.base import measuring
from paver_wb.gui.series import run as series_run


class SeriesDialogs(WithCommands):
    def tearDown(self):
        for dialog in list(measuring._open.values()):
            dialog.close()
        for run in list(series_run._at_work):
            run.stop()
        window.wait(lambda: not series_run._at_work and not run_control._runs, "for series to end")
        super().tearDown()

    def open(self, **options):
        mesh = self.mesh(is_meshed=False, **(options or {"frequency": "60 GHz", "divisions": 4}))
        select(mesh)
        FreeCADGui.runCommand("Paver_Series")
        window.wait(lambda: window.widget("Paver_SeriesTable"), "for the dialog")
        return mesh

    def write(self, name, text):
        window.widget("Paver_Series" + name).setText(text)

    def click(self, name):
        window.click(window.widget("Paver_Series" + name))

    def choose(self, option):
        field = window.widget("Paver_SeriesOption")
        field.setCurrentIndex(field.findData(option))
        field.activated.emit(field.currentIndex())

    def wait(self):
        window.wait(lambda: not series_run._at_work, "for the series")
        window.pause(50)

    def fault(self):
        label = window.widget("Paver_FaultText", QtGui.QLabel)
        return label.text() if label else ""

    def table(self):
        table = window.widget("Paver_SeriesTable")
        return [[table.item(i, k).text() for k in range(table.columnCount())] for i in range(table.rowCount())]

    def click_row(self, number):
        table = window.widget("Paver_SeriesTable")
        middle = table.visualItemRect(table.item(number, 1)).center()
        window.QTest.mouseClick(table.viewport(), QtCore.Qt.LeftButton, QtCore.Qt.NoModifier, middle)

    def test_the_table_fills_and_a_click_shows_the_mesh(self):
        mesh = self.open()
        self.write("Values", "30 GHz; 900 THz; 60 GHz")
        self.click("Run")
        self.wait()
        obj, = series.of_document(self.document)
        rows = self.table()
        self.assertEqual([row[0] for row in rows], ["30 GHz", "60 GHz", "900 THz"])
        self.assertEqual([row[1] for row in rows], [*(str(child.Quads + child.Triangles) for child in obj.Meshes[:2]), ""])
        self.assertIn("elements are predicted", rows[2][6])
        self.assertEqual([child.Status for child in obj.Meshes], ["Up to date", "Up to date", "Not meshed"])
        self.assertIn("paver_wb.gui.series.run.start(", self.console())
        self.assertIn("frequencies=['30 GHz', '900 THz', '60 GHz']", self.console())
        self.assertEqual(self.document.UndoNames[-1], "Series of PaverMesh")
        window.picture("series_dialog")
        for number in (0, 1):
            self.click_row(number)
            self.assertEqual([child.ViewObject.Visibility for child in obj.Meshes], [number == 0, number == 1, False])
            self.assertEqual((mesh.ViewObject.Visibility, self.box.ViewObject.Visibility), (False, False))
            self.assertEqual(FreeCADGui.Selection.getSelection(), [obj.Meshes[number]])
        self.click_row(2)
        self.assertEqual(FreeCADGui.Selection.getSelection(), [obj.Meshes[1]])
        self.assertEqual(self.fault(), series.rows_of(obj)[2].error)

    def test_a_row_whose_mesh_has_changed_says_so(self):
        self.open()
        self.write("Values", "30 GHz, 60 GHz")
        self.click("Run")
        self.wait()
        obj, = series.of_document(self.document)
        sound = [row[6] for row in self.table()]
        obj.Meshes[1].Order = 1
        window.wait(lambda: "this row is of before" in self.table()[1][6], "for the note")
        self.assertEqual(self.table()[0][6], sound[0])
        obj.Meshes[1].Order = 2
        window.wait(lambda: self.table()[1][6] == sound[1], "for the verdict")
        obj.Meshes[1].Divisions = 6
        run = run_control.start(obj.Meshes[1])
        window.wait(lambda: run.outcome, "for the mesh")
        window.pause(100)
        self.assertIn("this row is of before", self.table()[1][6])
        self.box.Length = 11
        self.document.recompute()
        window.wait(lambda: "this row is of before" in self.table()[0][6], "for the note")

    def test_a_stop_keeps_what_is_done_and_continue_does_the_rest(self):
        self.open(size=2, max_elements=3000000)
        self.write("Values", "0.03 mm, 1 mm, 2 mm")
        self.click("Run")
        obj, = series.of_document(self.document)
        for run in series_run._at_work[0].runs[:1]:
            run.stop()  # the first one alone
        window.wait(lambda: series.rows_of(obj)[1] is not None, "for the second step")
        self.click("Stop") if window.widget("Paver_SeriesStop").isEnabled() else None
        self.wait()
        self.assertIsNone(series.rows_of(obj)[0])
        self.assertEqual((self.table()[0][6], obj.Meshes[0].Status), ("Not done", "Not meshed"))
        obj.Meshes[0].Size = 3
        self.click("Continue")
        self.wait()
        self.assertTrue(all(series.rows_of(obj)))
        self.assertFalse(window.widget("Paver_SeriesContinue").isEnabled())
        with self.assertRaises(AssertionError):
            self.click("Stop")

    def test_stop_stops_all_steps(self):
        self.open(size=2, max_elements=3000000)
        self.write("Values", "0.03 mm, 0.032 mm")
        self.click("Run")
        window.wait(lambda: self.table() and "%" in self.table()[0][6], "for progress")
        self.assertEqual(self.table()[1][6], "Waiting")
        self.click("Stop")
        self.wait()
        self.assertEqual([row[6] for row in self.table()], ["Not done"] * 2)

    def test_large_steps_run_in_a_process_of_their_own_and_one_that_dies_is_a_row(self):
        mesh = self.open(size=2, max_elements=3000000)
        mesh.RunIn = "Own process"
        self.write("Values", "0.03 mm, 2 mm")
        self.click("Run")
        window.wait(lambda: children() and series_run._at_work[0].runs[0].stage, "for the process")
        os.kill(children()[0], 9)
        self.wait()
        obj, = series.of_document(self.document)
        self.assertIn("memory runs out", series.rows_of(obj)[0].error)
        self.assertEqual(obj.Meshes[1].Status, "Up to date")
        self.assertEqual(children(), [])

    def test_files_only(self):
        mesh = self.open()
        self.choose("divisions")
        self.assertEqual(window.widget("Paver_SeriesValues").text(), "6, 8, 10, 14")
        self.write("Values", "4, 6")
        self.click("Files")
        window.widget("Paver_SeriesFormat_unv").setChecked(True)
        self.write("Folder", "/nowhere")
        self.click("Run")
        self.assertIn("cannot be written to the folder", self.fault())
        self.assertEqual(self.document.UndoNames, [])
        with tempfile.TemporaryDirectory() as folder:
            self.write("Folder", folder)
            self.click("Run")
            self.wait()
            self.assertEqual(self.fault(), "")
            stem = f"{self.document.Name}-{mesh.Name}"
            self.assertEqual(set(os.listdir(folder)), {stem + "-series.csv", *(
                f"{stem}-divisions{n}.{ending}" for n in (4, 6) for ending in ("msh", "unv"))})
        self.assertEqual(mesh_object.meshes_of(self.document), [mesh])
        self.assertTrue(all(row[1] for row in self.table()))

    def test_ranges_and_what_is_no_value(self):
        self.open()
        window.widget("Paver_SeriesCount").setValue(3)
        for first, last, how, wanted in (("1 GHz", "4 GHz", 1, "1 GHz; 2 GHz; 4 GHz"), ("1", "4", 0, "1 GHz; 2.5 GHz; 4 GHz")):
            self.write("First", first)
            self.write("Last", last)
            window.widget("Paver_SeriesSpread").setCurrentIndex(how)
            self.click("FillIn")
            self.assertEqual(window.widget("Paver_SeriesValues").text(), wanted)
        self.write("First", "9 mm")
        self.click("FillIn")
        self.assertIn("'9 mm' cannot be read", self.fault())
        for text in ("3 mm", "fast", "", "-1"):
            self.write("Values", text)
            self.click("Run")
            self.assertTrue(self.fault(), text)
        self.assertEqual(series.of_document(self.document), [])

    def test_deleting_and_undoing_while_it_runs(self):
        mesh = self.open(size=2, max_elements=3000000)
        refinement.make(mesh, ["Face1"], "1 mm")
        for goes in ("series", "undo", "mesh"):
            self.write("Values", "0.03 mm, 0.032 mm")
            self.click("Run")
            window.wait(lambda: series_run._at_work[0].runs[0].stage, "for progress")
            obj = series.of_document(self.document)[-1]
            self.assertEqual(obj.ViewObject.Proxy.claimChildren(), obj.Meshes)
            if goes == "undo":
                self.document.undo()
            elif goes == "series":
                select(obj)
                FreeCADGui.runCommand("Std_Delete")
            else:
                self.document.removeObject(obj.Meshes[0].Name)
                self.click("Stop")
            self.wait()
            left = [thing.Name for thing in self.document.Objects if thing.Name.startswith("PaverMesh_")]
            self.assertEqual(len(left), goes == "mesh", goes)

    def test_a_document_that_was_opened_again_shows_its_table(self):
        self.open()
        self.write("Values", "30 GHz")
        self.click("Run")
        self.wait()
        before = self.table()
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "kept.FCStd")
            self.document.saveAs(path)
            FreeCAD.closeDocument(self.document.Name)
            window.wait(lambda: not measuring._open, "for the dialog to close")
            self.document = FreeCAD.openDocument(path)
            obj, = series.of_document(self.document)
            window.tree_dock()
            window.pause(300)
            window.double_click(obj)
            window.wait(lambda: window.widget("Paver_SeriesTable"), "for the dialog")
            self.assertEqual(self.table(), before)
            self.click_row(0)
            self.assertTrue(obj.Meshes[0].ViewObject.Visibility)
