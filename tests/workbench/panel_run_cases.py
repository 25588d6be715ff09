"""Runs off the main thread, with and without the task panel. Runs in FreeCAD's window: panel_test.py."""
import os
import signal
import threading

import FreeCAD
import FreeCADGui
import Part
from PySide import QtCore, QtGui

import window
from child_cases import children
from paver_wb import mesh_object, properties
from paver_wb.gui import run_control
from paver_wb.gui.display import drawn_mesh
from panel_cases import PanelCase

BOW_TIE = [(0, 0), (10, 10), (10, 0), (2, 9), (0, 0)]  # its boundary crosses itself: cannot be meshed


def folders(document):
    """What runs have left in the folder of temporary files."""
    return [n for n in os.listdir(os.path.dirname(document.TransientDir)) if n.startswith("paver")]


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
        self.assertEqual((mesh.Status, self.text("size")), ("Up to date", "0.03 mm"))
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
        mesh, held, real = self.add_mesh(), threading.Event(), run_control.MeshThread.tell

        def held_up(thread, stage, fraction):
            real(thread, stage, fraction)
            held.wait(window.LIMIT)
        run_control.MeshThread.tell = held_up
        self.addCleanup(held.set)
        try:
            run = self.begin_long_run(mesh)
        finally:
            run_control.MeshThread.tell = real
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
        window.wait(lambda: run.state == "taking", "for the result")
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
            self.assertIn("repair the face in the CAD model", self.text("FaultText"))
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
        window.type_into(window.widget("Paver_size"), "1.1")
        self.mesh_and_wait()
        self.assertEqual((mesh.RunIn, mesh.Status), ("Own process", "Up to date"))
        self.assertEqual(self.document.UndoNames, ["Mesh PaverMesh"])
        self.document.undo()
        self.assertEqual((mesh.RunIn, mesh.Size.Value), ("Automatic", 1))
        self.document.redo()
        self.assertEqual((mesh.RunIn, mesh.Size.Value), ("Own process", 1.1))
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

    def test_ranks_give_the_same_mesh(self):
        if not properties.has_ranks():
            return
        mesh = self.add_mesh(size=0.5)
        self.open(mesh)
        self.mesh_and_wait()
        alone = mesh_object.stored(mesh).report["checksum"]
        window.click(window.widget("Paver_More"))
        for run_in in ("Automatic", "Own process"):
            mesh.RunIn, mesh.Ranks = run_in, 2
            self.assertEqual(self.text("ranks"), "2")
            self.mesh_and_wait()
            self.assertEqual((window.widget("Paver_FaultText"), mesh.Status), (None, "Up to date"))
            self.assertEqual(mesh_object.stored(mesh).report["checksum"], alone)
        window.picture("panel_ranks")
        mesh.RunIn = "Automatic"
        run = self.begin_long_run(mesh)
        run.stop()
        window.wait(lambda: run.outcome, "for the stop")
        self.assertEqual(run.outcome.kind, "cancelled")
        del run  # nobody waits for it any more
        window.wait(lambda: not folders(self.document), "for the thread that was left to itself")

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
