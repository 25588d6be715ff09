"""The task panel of a mesh object and runs off the main thread, with clicks. Runs in FreeCAD's window: panel_test.py."""
import os
import signal
import threading
import unittest

import FreeCAD
import FreeCADGui
import Part
from PySide import QtCore, QtGui

import window
from child_cases import children
from paver_wb import core, mesh_object
from paver_wb.gui import run_control
from paver_wb.gui.display import drawn_mesh

PANEL_WIDTH = 360
LONG = {"size": 0.03, "max_elements": 3000000}  # a run that takes a while
BOW_TIE = [(0, 0), (10, 10), (10, 0), (2, 9), (0, 0)]  # its boundary crosses itself: cannot be meshed


def folders(document):
    """What runs have left in the folder of temporary files."""
    return [n for n in os.listdir(os.path.dirname(document.TransientDir)) if n.startswith("paver")]


class PanelCase(unittest.TestCase):
    """A document with a box and a coarse mesh object of it."""

    def setUp(self):
        FreeCADGui.activateWorkbench("PaverWorkbench")
        main = FreeCADGui.getMainWindow()
        main.resize(1560, 960)
        self.document = FreeCAD.newDocument("PaverPanel")
        self.box = self.document.addObject("Part::Box", "Box")
        self.document.recompute()
        FreeCADGui.ActiveDocument.ActiveView.viewIsometric()
        FreeCADGui.SendMsgToActiveView("ViewFit")
        for dock in main.findChildren(QtGui.QDockWidget):
            if dock.objectName() in ("Python console", "Report view"):
                dock.hide()
            if dock.objectName() == "Combo View":
                main.resizeDocks([dock], [PANEL_WIDTH], QtCore.Qt.Horizontal)

    def tearDown(self):
        if FreeCADGui.Control.activeDialog():
            self.button(QtGui.QDialogButtonBox.Cancel).click()
            window.pause(50)
        if self.document is not None:
            FreeCAD.closeDocument(self.document.Name)
        window.wait(lambda: not run_control._runs and not run_control.run_thread._running, "for runs to end")

    def add_mesh(self, *parts, **options):
        mesh = mesh_object.add(self.document, list(parts) or self.box, **(options or {"size": 2}))
        self.document.recompute()
        self.document.clearUndos()
        return mesh

    def open(self, mesh):
        FreeCADGui.ActiveDocument.setEdit(mesh.Name)
        window.wait(lambda: window.widget("Paver_MeshButton"), "for the panel")

    def button(self, which):
        """One of the panel's OK, Apply, Cancel."""
        return next(box.button(which) for box in window.widgets(QtGui.QDialogButtonBox) if box.button(which))

    def text(self, name):
        return window.widget("Paver_" + name).text()

    def mesh_and_wait(self):
        window.click(window.widget("Paver_MeshButton"))
        window.wait(lambda: window.widget("Paver_MeshButton").isEnabled(), "for the mesh")

    def begin_long_run(self, mesh, **changes):
        """A run that has told how far it is, but is far from its end."""
        run = run_control.start(mesh, **{**LONG, **changes})
        self.seen = []
        run.progressed.connect(lambda stage, fraction: self.seen.append(stage))
        window.wait(lambda: self.seen, "for progress")
        return run


class Panel(PanelCase):
    def test_create_opens_it_predicts_meshes_and_shows_figures(self):
        FreeCADGui.Selection.addSelection(self.box)
        FreeCADGui.runCommand("Paver_CreateMesh")
        window.wait(lambda: window.widget("Paver_Prediction"), "for the panel")
        mesh, = mesh_object.meshes_of(self.document)
        window.wait(lambda: "elements" in self.text("Prediction"), "for a prediction")
        first = self.text("Prediction")
        window.type_into(window.widget("Paver_size"), "2 mm")
        window.wait(lambda: "elements" in self.text("Prediction") and self.text("Prediction") != first, "for another")
        window.picture("panel_predicted")
        self.mesh_and_wait()
        self.assertEqual((mesh.Size.Value, mesh.Status), (2, "Up to date"))
        self.assertEqual(self.document.UndoNames, ["Mesh PaverMesh", "Create mesh"])
        window.wait(lambda: window.widget("Paver_Result"), "for figures")
        table = window.widget("Paver_Result")
        rows = {table.item(i, 0).text(): table.item(i, 1).text() for i in range(table.rowCount())}
        self.assertEqual((rows["Elements"], rows["Quads"], rows["Watertight"]), (str(mesh.Quads),) * 2 + ("yes",))
        self.assertIn("2 mm", rows["Target length"])
        window.picture("panel_meshed")

    def test_double_click_in_the_tree_opens_it(self):
        mesh = self.add_mesh()
        window.pause(300)  # FreeCAD fills its tree late
        window.double_click(mesh)
        window.wait(lambda: window.widget("Paver_MeshButton"), "for the panel")
        self.assertEqual(FreeCADGui.ActiveDocument.getInEdit().Object, mesh)
        self.mesh_and_wait()
        self.assertEqual(self.document.UndoNames, ["Mesh PaverMesh"])
        window.click(self.button(QtGui.QDialogButtonBox.Ok))
        window.wait(lambda: not FreeCADGui.Control.activeDialog())
        window.double_click(mesh)
        window.wait(lambda: window.widget("Paver_MeshButton"), "for the panel again")

    def test_too_many_elements_are_told_before_and_after(self):
        mesh = self.add_mesh(size=0.5, max_elements=100)
        self.open(mesh)
        window.wait(lambda: "elements" in self.text("Prediction"), "for a prediction")
        self.assertIn("more than 'Most elements' allows", self.text("Prediction"))
        self.mesh_and_wait()
        self.assertIn("raise 'Most elements'", self.text("FaultText"))
        self.assertEqual((mesh.Status, self.document.UndoCount), ("Not meshed", 0))
        window.picture("panel_limit")

    def test_model_and_mesh_are_not_seen_at_one_place(self):
        mesh = self.add_mesh()
        self.open(mesh)
        self.mesh_and_wait()
        self.assertEqual((self.box.ViewObject.Visibility, mesh.ViewObject.Visibility), (False, True))
        FreeCADGui.Selection.clearSelection()
        window.picture("panel_mesh_in_view")
        window.click(window.widget("Paver_ViewModel"))
        self.assertEqual((self.box.ViewObject.Visibility, mesh.ViewObject.Visibility), (True, False))
        self.mesh_and_wait()
        self.assertEqual((self.box.ViewObject.Visibility, mesh.ViewObject.Visibility), (False, True))
        self.document.undo()
        window.click(window.widget("Paver_ViewModel"))
        window.click(window.widget("Paver_ViewMesh"))
        self.assertEqual((self.box.ViewObject.Visibility, mesh.ViewObject.Visibility), (False, True))
        self.document.undo()
        self.assertEqual((mesh.Status, self.box.ViewObject.Visibility), ("Not meshed", True))

    def test_frequency_and_length_are_linked(self):
        self.open(self.add_mesh(frequency="30 GHz", divisions=10, order=1))
        self.assertEqual((self.text("frequency"), self.text("size")), ("30 GHz", "0.9993082 mm"))
        window.type_into(window.widget("Paver_frequency"), "9.375 GHz")
        window.type_into(window.widget("Paver_eps_r"), "4")
        self.assertEqual((self.text("frequency"), self.text("size")), ("9.375 GHz", "1.598893 mm"))
        self.assertIn("15.99 mm", self.text("Wavelength"))
        window.picture("panel_frequency")
        window.click(window.widget("Paver_ByLength"))
        self.assertFalse(window.widget("Paver_frequency").isEnabled())
        window.type_into(window.widget("Paver_size"), "0.1 in")
        self.assertEqual(self.text("size"), "2.54 mm")
        window.type_into(window.widget("Paver_size"), "3 GHz")
        self.assertIn("write a number and a unit", self.text("Prediction"))
        self.assertFalse(window.widget("Paver_MeshButton").isEnabled())
        window.picture("panel_bad_value")

    def test_apply_is_one_step_and_cancel_drops_the_rest(self):
        mesh = self.add_mesh()
        self.open(mesh)
        window.type_into(window.widget("Paver_size"), "1.5")
        window.widget("Paver_order").setCurrentIndex(0)
        self.assertEqual((mesh.Size.Value, mesh.Order, self.document.UndoNames), (2, 2, []))
        window.click(self.button(QtGui.QDialogButtonBox.Apply))
        self.assertEqual((mesh.Size.Value, mesh.Order, self.document.UndoCount), (1.5, 1, 1))
        window.type_into(window.widget("Paver_size"), "1.2")
        window.click(self.button(QtGui.QDialogButtonBox.Cancel))
        window.wait(lambda: not FreeCADGui.Control.activeDialog())
        self.assertEqual((mesh.Size.Value, self.document.UndoCount), (1.5, 1))
        self.document.undo()
        self.assertEqual((mesh.Size.Value, mesh.Order), (2, 2))

    def test_ok_applies_and_closes(self):
        mesh = self.add_mesh()
        self.open(mesh)
        window.click(window.widget("Paver_More"))
        window.type_into(window.widget("Paver_gradation"), "0.4")
        window.picture("panel_more")
        window.click(self.button(QtGui.QDialogButtonBox.Ok))
        window.wait(lambda: not FreeCADGui.Control.activeDialog())
        self.assertEqual((mesh.Gradation, self.document.UndoCount), (0.4, 1))
        self.assertIsNone(FreeCADGui.ActiveDocument.getInEdit())

    def test_cancel_takes_a_new_object_back_unless_it_is_meshed(self):
        for is_meshed in (False, True):
            FreeCADGui.Selection.addSelection(self.box)
            FreeCADGui.runCommand("Paver_CreateMesh")
            window.wait(lambda: window.widget("Paver_MeshButton"), "for the panel")
            if is_meshed:
                self.mesh_and_wait()
            window.click(self.button(QtGui.QDialogButtonBox.Cancel))
            window.wait(lambda: not FreeCADGui.Control.activeDialog())
            self.assertEqual(len(mesh_object.meshes_of(self.document)), is_meshed)

    def test_undo_and_redo_with_the_panel_open(self):
        mesh = self.add_mesh()
        self.open(mesh)
        window.type_into(window.widget("Paver_size"), "1 mm")
        self.mesh_and_wait()
        count = mesh.Quads
        self.document.undo()
        window.wait(lambda: self.text("Status") == "Not meshed yet")
        self.assertEqual((self.text("size"), mesh.Quads, mesh.FemMesh.FaceCount), ("2 mm", 0, 0))
        self.document.redo()
        window.wait(lambda: self.text("Status") == "The mesh is up to date")
        self.assertEqual((self.text("size"), mesh.Quads, mesh.FemMesh.FaceCount), ("1 mm", count, count))

    def test_without_the_core_nothing_opens(self):
        mesh = self.add_mesh()
        real = core.problem
        core.problem = lambda: "The core is not there; build it."
        self.addCleanup(setattr, core, "problem", real)
        FreeCADGui.ActiveDocument.setEdit(mesh.Name)
        window.pause(100)
        self.assertFalse(FreeCADGui.Control.activeDialog())
        self.assertIsNone(FreeCADGui.ActiveDocument.getInEdit())

    def test_changes_in_the_property_editor_are_seen(self):
        mesh = self.add_mesh()
        self.open(mesh)
        mesh.Size = "3 mm"
        self.assertEqual(self.text("size"), "3 mm")

    def test_an_object_that_goes_takes_its_panel_along(self):
        mesh = self.add_mesh()
        self.open(mesh)
        self.begin_long_run(mesh)
        self.document.removeObject(mesh.Name)
        window.wait(lambda: not FreeCADGui.Control.activeDialog(), "for the panel to go")
        self.assertIsNone(FreeCADGui.ActiveDocument.getInEdit())

    def test_every_field_and_button_has_a_tooltip(self):
        self.open(self.add_mesh())
        window.click(window.widget("Paver_More"))
        shown = [w for w in window.widgets(QtGui.QWidget) if w.objectName().startswith("Paver_")]
        self.assertGreater(len(shown), 15)
        self.assertEqual([w.objectName() for w in shown if not w.toolTip()], [])

    def test_no_text_is_clipped(self):
        main = FreeCADGui.getMainWindow()
        dock, = [d for d in window.widgets(QtGui.QDockWidget) if d.objectName() == "Combo View"]
        main.resizeDocks([dock], [100], QtCore.Qt.Horizontal)
        window.pause(50)
        self.open(self.add_mesh(frequency="9.375 GHz", divisions=12))
        window.click(window.widget("Paver_More"))
        window.pause(50)
        for field in window.widgets(QtGui.QLineEdit):
            if field.objectName().startswith("Paver_"):
                needed = field.fontMetrics().horizontalAdvance(field.text() or field.placeholderText())
                self.assertLess(needed, field.width(), field.objectName())
        window.picture("panel_narrow")
        for part in window.widgets(QtGui.QPushButton) + window.widgets(QtGui.QLabel):
            if part.objectName().startswith("Paver_"):
                right = part.mapTo(dock, part.rect().topRight()).x()
                self.assertTrue(part.minimumSizeHint().width() <= part.width() and right < dock.width(),
                                part.objectName())


class Runs(PanelCase):
    def test_progress_is_seen_and_a_stop_leaves_the_old_mesh(self):
        mesh = self.add_mesh()
        self.open(mesh)
        self.mesh_and_wait()
        before = (mesh.Quads, mesh.MeshFile, mesh.Size.Value, self.document.UndoCount)
        window.click(window.widget("Paver_More"))
        window.type_into(window.widget("Paver_max_elements"), "3000000")
        window.click(window.widget("Paver_More"))
        window.type_into(window.widget("Paver_size"), "0.03 mm")
        window.click(window.widget("Paver_MeshButton"))
        stages = set()
        window.wait(lambda: stages.add(window.widget("Paver_Progress").text()) or len(stages) > 2, "for progress")
        self.assertTrue(all("%" in stage for stage in stages), stages)
        self.assertFalse(window.widget("Paver_size").isEnabled())
        window.picture("panel_running")
        window.click(window.widget("Paver_StopButton"))
        window.wait(lambda: window.widget("Paver_MeshButton").isEnabled(), "for the stop")
        self.assertEqual((mesh.Quads, mesh.MeshFile, mesh.Size.Value, self.document.UndoCount), before)
        self.assertEqual((mesh.Status, self.text("size")), ("Up to date", "30 \u00b5m"))
        window.picture("panel_stopped")

    def test_mesh_command_runs_beside_the_window_one_object_after_the_other(self):
        meshes = [self.add_mesh(size=size) for size in (2, 3)]
        FreeCADGui.Selection.clearSelection()
        for mesh in meshes:
            FreeCADGui.Selection.addSelection(mesh)
        FreeCADGui.runCommand("Paver_Mesh")
        runs = list(run_control._runs)
        self.assertEqual([run.state for run in runs], ["running", "waiting"])
        self.assertTrue(window.widget("PaverStatusStop"))
        with self.assertRaisesRegex(ValueError, "wait for that"):
            run_control.start(meshes[0])
        window.wait(lambda: not run_control._runs, "for both")
        self.assertEqual([mesh.Status for mesh in meshes], ["Up to date"] * 2)
        self.assertEqual(self.document.UndoNames, ["Mesh " + mesh.Label for mesh in reversed(meshes)])
        self.assertIsNone(window.widget("PaverStatusStop"))
        self.assertEqual(folders(self.document), [])

    def test_stop_in_the_status_bar(self):
        mesh = self.add_mesh()
        run = self.begin_long_run(mesh)
        window.picture("status_bar")
        window.click(window.widget("PaverStatusStop"))
        window.wait(lambda: run.outcome, "for the stop")
        self.assertEqual((run.outcome.kind, mesh.Status), ("cancelled", "Not meshed"))

    def test_a_run_that_does_not_answer_a_stop_is_left_to_itself(self):
        mesh, held, real = self.add_mesh(), threading.Event(), run_control.run_thread.MeshThread.tell

        def held_up(thread, stage, fraction):
            real(thread, stage, fraction)
            held.wait(window.LIMIT)
        run_control.run_thread.MeshThread.tell = held_up
        self.addCleanup(held.set)
        try:
            run = self.begin_long_run(mesh)
        finally:
            run_control.run_thread.MeshThread.tell = real
        run.stop()
        window.wait(lambda: run.outcome, "for the stop")
        self.assertTrue(run.thread.isRunning())
        after = run_control.start(mesh)
        window.wait(lambda: after.outcome, "for the next one")
        self.assertEqual((run.outcome.kind, after.outcome.kind, mesh.Status), ("cancelled", "meshed", "Up to date"))
        held.set()
        window.wait(lambda: not os.path.exists(run.folder), "for its files to go")
        self.assertEqual((mesh.Status, self.document.UndoCount), ("Up to date", 1))

    def test_a_result_waits_for_a_step_of_undo_that_is_open(self):
        mesh = self.add_mesh()
        self.document.openTransaction("Something else")
        self.box.Label = "Brick"
        run = run_control.start(mesh)
        window.wait(lambda: run.state == run_control.TAKING, "for the result")
        window.pause(300)
        self.assertEqual(mesh.Status, "Not meshed")
        self.document.commitTransaction()
        window.wait(lambda: run.outcome, "for the end")
        self.assertEqual((mesh.Status, self.document.UndoNames), ("Up to date", ["Mesh PaverMesh", "Something else"]))

    def test_a_shape_that_changes_meanwhile_leaves_the_mesh_out_of_date(self):
        mesh = self.add_mesh()
        for length, status in ((10, "Up to date"), (12, "Out of date")):
            run = run_control.start(mesh)
            self.box.Length = length
            self.document.recompute()
            self.assertIsNone(run.outcome)
            window.wait(lambda: run.outcome, "for the mesh")
            self.assertEqual((run.outcome.kind, mesh.Status), ("meshed", status))
        run = run_control.start(mesh)
        mesh.Part = None
        window.wait(lambda: run.outcome, "for the mesh")
        self.assertEqual(mesh.Status, "Out of date")

    def test_an_error_is_a_sentence_and_selects_the_face(self):
        wire = Part.makePolygon([FreeCAD.Vector(x + 20, y) for x, y in BOW_TIE])
        bad = self.document.addObject("Part::Feature", "Bad")
        bad.Shape = Part.Compound([Part.makePlane(3, 3, FreeCAD.Vector(40, 0)), Part.Face(wire)])
        FreeCADGui.SendMsgToActiveView("ViewFit")
        for parts, name in (([bad], "Face2"), ([self.box, bad], "Face2")):
            mesh = self.add_mesh(*parts)
            self.open(mesh)
            self.mesh_and_wait()
            chosen, = FreeCADGui.Selection.getSelectionEx()
            self.assertEqual((chosen.Object, chosen.SubElementNames), (bad, (name,)))
            self.assertIn("use a smaller size", self.text("FaultText"))
            self.assertEqual(self.text("ShowPlace"), "Show Face2")
            FreeCADGui.Selection.clearSelection()
            window.click(window.widget("Paver_ShowPlace"))
            self.assertEqual(FreeCADGui.Selection.getSelectionEx()[0].SubElementNames, (name,))
            window.picture("panel_error")
            window.click(self.button(QtGui.QDialogButtonBox.Ok))

    def test_an_error_without_any_mesh_selects_a_face_inside_a_part(self):
        part = self.document.addObject("App::Part", "Assembly")
        bad = self.document.addObject("Part::Feature", "Bad")
        bad.Shape = Part.Face(Part.makePolygon([FreeCAD.Vector(x, y) for x, y in BOW_TIE]))
        part.addObject(bad)
        part.Placement.Base.x = 30
        mesh = self.add_mesh(part)
        for run_in in ("FreeCAD", "Own process"):
            FreeCADGui.Selection.clearSelection()
            mesh.RunIn = run_in
            run = run_control.start(mesh)
            window.wait(lambda: run.outcome, "for the error")
            self.assertEqual((run.outcome.kind, run.outcome.place), ("failed", (0, "Face1")))
            self.assertEqual(FreeCADGui.Selection.getSelectionEx("", 0)[0].SubElementNames, ("Bad.Face1",))

    def test_a_child_process_gives_the_same_mesh(self):
        mesh = self.add_mesh(size=1)
        self.open(mesh)
        window.click(window.widget("Paver_More"))
        window.widget("Paver_RunIn").setCurrentIndex(2)
        window.widget("Paver_RunIn").activated.emit(2)
        window.wait(lambda: "process of its own" in self.text("Prediction"), "for a prediction")
        self.mesh_and_wait()
        self.assertEqual((mesh.RunIn, mesh.Status), ("Own process", "Up to date"))
        self.assertIn("process of its own", window.widget("Paver_Log").toPlainText())
        own = mesh_object.stored(mesh)
        mesh.RunIn = "FreeCAD"
        self.mesh_and_wait()
        self.assertEqual(own.report["checksum"], mesh_object.stored(mesh).report["checksum"])
        self.assertEqual((children(), folders(self.document)), ([], []))

    def test_what_is_drawn_is_made_on_the_thread_and_is_that_of_the_file(self):
        mesh = self.add_mesh(size=1)
        made = []
        real = drawn_mesh.DrawnMesh

        def noted(stored):
            made.append(QtCore.QThread.currentThread() == QtGui.QApplication.instance().thread())
            return real(stored)
        drawn_mesh.DrawnMesh = noted
        self.addCleanup(setattr, drawn_mesh, "DrawnMesh", real)
        run = run_control.start(mesh)
        window.wait(lambda: run.outcome, "for the mesh")
        display = mesh.ViewObject.Proxy.display
        window.wait(lambda: display.mesh is not None, "for the drawing")
        self.assertEqual(made, [False])
        kept = mesh_object.stored(mesh)
        self.assertTrue((display.mesh.stored.nodes == kept.nodes).all() and (display.mesh.stored.quads == kept.quads).all())
        self.document.undo()
        window.wait(lambda: display.mesh is None, "for undo")
        self.document.redo()
        window.wait(lambda: display.mesh is not None, "for redo")
        self.assertEqual((made, len(display.mesh.stored.quads)), ([False, True], len(kept.quads)))

    def test_heavy_runs_go_to_a_child_process(self):
        preferences = FreeCAD.ParamGet(mesh_object.PREFERENCES)
        preferences.SetInt("HeavyElements", 100)
        self.addCleanup(preferences.RemInt, "HeavyElements")
        moved = []
        for size in (5, 1):
            run = run_control.start(self.add_mesh(size=size))
            run.moved.connect(lambda: moved.append(size))
            window.wait(lambda: run.outcome, "for the mesh")
            self.assertEqual(run.outcome.kind, "meshed")
        self.assertEqual(moved, [1])

    def test_freecad_survives_a_child_that_dies(self):
        mesh = self.add_mesh()
        self.open(mesh)
        self.mesh_and_wait()
        window.click(window.widget("Paver_More"))
        window.type_into(window.widget("Paver_max_elements"), "3000000")
        window.widget("Paver_RunIn").setCurrentIndex(2)
        window.type_into(window.widget("Paver_size"), "0.03 mm")
        window.click(window.widget("Paver_More"))
        before = (mesh.Quads, mesh.Size.Value)
        for number, words in ((signal.SIGKILL, "memory runs out"), (signal.SIGABRT, "SIGABRT"),
                              (signal.SIGSEGV, "SIGSEGV")):
            window.click(window.widget("Paver_MeshButton"))
            window.wait(lambda: "Reading" in window.widget("Paver_Log").toPlainText().splitlines()[-1] or children(),
                        "for the process")
            window.wait(lambda: run_control._runs[0].stage, "for progress")
            child, = children()
            os.kill(child, number)
            window.wait(lambda: window.widget("Paver_MeshButton").isEnabled(), "for the end")
            self.assertIn(words, self.text("FaultText"))
            self.assertEqual((mesh.Quads, mesh.Size.Value, mesh.Status), (*before, "Up to date"))
        window.picture("panel_child_died")
        self.assertEqual((children(), folders(self.document)), ([], []))

    def test_stopping_a_child_process(self):
        mesh = self.add_mesh()
        mesh.RunIn = "Own process"
        run = self.begin_long_run(mesh)
        run.stop()
        window.wait(lambda: run.outcome, "for the stop")
        self.assertEqual(run.outcome.kind, "cancelled")
        window.wait(lambda: not children() and not folders(self.document), "for the process to go")

    def test_closing_the_panel_while_a_run_is_on(self):
        mesh = self.add_mesh()
        for which, kind in ((QtGui.QDialogButtonBox.Ok, "meshed"), (QtGui.QDialogButtonBox.Cancel, "cancelled")):
            self.open(mesh)
            window.type_into(window.widget("Paver_size"), "0.1 mm" if kind == "meshed" else "0.05 mm")
            window.click(window.widget("Paver_MeshButton"))
            run = run_control.run_of(mesh)
            window.click(self.button(which))
            window.wait(lambda: not FreeCADGui.Control.activeDialog(), "for the panel to go")
            window.wait(lambda: run.outcome, "for the run")
            self.assertEqual((run.outcome.kind, mesh.Size.Value, mesh.Status), (kind, 0.1, "Up to date"))

    def test_opening_the_panel_while_a_run_is_on(self):
        mesh = self.add_mesh()
        run = self.begin_long_run(mesh)
        self.open(mesh)
        self.assertTrue(window.widget("Paver_Progress"))
        self.assertFalse(window.widget("Paver_MeshButton").isEnabled())
        window.click(window.widget("Paver_StopButton"))
        window.wait(lambda: run.outcome, "for the stop")

    def test_the_panel_follows_a_run_of_the_mesh_command(self):
        mesh = self.add_mesh()
        self.open(mesh)
        run = self.begin_long_run(mesh)
        self.assertTrue(window.widget("Paver_Progress"))
        window.click(window.widget("Paver_StopButton"))
        window.wait(lambda: run.outcome, "for the stop")
        self.assertTrue(window.widget("Paver_MeshButton").isEnabled())

    def test_deleting_the_object_or_the_document_while_a_run_is_on(self):
        for goes in ("object", "undo", "document"):
            mesh = self.add_mesh() if goes != "undo" else None
            if goes == "undo":
                self.document.openTransaction("Create")
                mesh = mesh_object.add(self.document, self.box, size=2)
                self.document.commitTransaction()
            run = self.begin_long_run(mesh)
            if goes == "object":
                self.document.removeObject(mesh.Name)
            elif goes == "undo":
                self.document.undo()
            else:
                FreeCAD.closeDocument(self.document.Name)
                self.document = None
            self.assertEqual((run.outcome.kind, run_control._runs), ("cancelled", []))
            window.wait(lambda: not os.path.exists(run.folder), "for its files to go")


class Sizes(PanelCase):
    def row(self, number=0):
        table = window.widget("Paver_Sizes", QtGui.QTableWidget)
        return [table.item(number, 0).text(), table.cellWidget(number, 1).value(), table.item(number, 2).text()]

    def add(self, *elements):
        FreeCADGui.Selection.clearSelection()
        for element in elements:
            FreeCADGui.Selection.addSelection(self.box, element)
        window.click(window.widget("Paver_AddSize"))
        window.pause(50)

    def elements(self):
        """The prediction, when there is one."""
        window.wait(lambda: "elements" in self.text("Prediction"), "for a prediction")
        return int("".join(filter(str.isdigit, self.text("Prediction").split("elements")[0])))

    def test_sizes_come_from_the_selection_and_count_at_once(self):
        mesh = self.add_mesh()
        self.open(mesh)
        before = self.elements()
        self.add("Face6", "Edge1")
        self.assertEqual(self.row(), ["Box: Face6, Edge1", "Length", "0.7 mm"])
        self.assertGreater(self.elements(), 2 * before)
        window.widget("Paver_Sizes").item(0, 2).setText("0.5 mm")
        child, = mesh.Refinements
        self.assertEqual((child.Length.Value, self.document.UndoCount), (0.5, 2))
        window.picture("panel_sizes")
        self.mesh_and_wait()
        self.assertGreater(mesh.Quads, 3 * before)
        self.document.undo()
        self.document.undo()
        window.wait(lambda: self.row()[2] == "0.7 mm", "for undo")
        self.document.undo()
        window.wait(lambda: not window.widget("Paver_Sizes"), "for undo")
        self.assertEqual(self.elements(), before)

    def test_a_child_process_gets_them_too(self):
        mesh = self.add_mesh()
        mesh.RunIn = "Own process"
        coarse = run_control.start(mesh)
        window.wait(lambda: coarse.outcome, "for the mesh")
        before = mesh.Quads
        self.open(mesh)
        self.add("Face6")
        self.mesh_and_wait()
        self.assertGreater(mesh.Quads, before)

    def test_rows_select_change_to_a_medium_and_go(self):
        mesh = self.add_mesh(frequency="30 GHz", divisions=6)
        self.open(mesh)
        self.add("Face6")
        self.add("Face1")
        table = window.widget("Paver_Sizes")
        choice = table.cellWidget(1, 1)
        choice.setCurrentIndex(1)
        choice.activated.emit(1)
        window.pause(50)
        table.item(1, 2).setText("4, 2")
        window.pause(50)
        self.assertEqual(self.row(1), ["Box: Face1", "Medium", "4, 2"])
        self.assertEqual((mesh.Refinements[1].EpsR, mesh.Refinements[1].MuR), (4, 2))
        table.item(1, 2).setText("glass")
        self.assertIn("write its", self.text("FaultText"))
        self.assertEqual(self.row(1)[2], "4, 2")
        window.picture("panel_sizes_fault")
        FreeCADGui.Selection.clearSelection()
        table.selectRow(1)
        self.assertEqual(FreeCADGui.Selection.getSelectionEx()[0].SubElementNames, ("Face1",))
        window.click(window.widget("Paver_RemoveSize"))
        window.pause(50)
        self.assertEqual((len(mesh.Refinements), self.row()[0]), (1, "Box: Face6"))

    def test_nothing_selected_is_told(self):
        mesh = self.add_mesh()
        self.open(mesh)
        self.add()
        self.assertIn("select", self.text("FaultText"))
        self.assertEqual((mesh.Refinements, self.document.UndoCount), ([], 0))
