"""Export and import beside the window. Runs in FreeCAD's window: commands_test.py."""
import os
import tempfile

import FreeCAD
import numpy as np

import window
from commands_cases import WithCommands
from paver_wb import analysis, export_mesh, import_mesh, mesh_object
from paver_wb.gui import file_tasks
from paver_wb.gui.base import run_status, run_task
from paver_wb.processes import child_process


class FileTasks(WithCommands):
    def setUp(self):
        super().setUp()
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = folder.name

    def path(self, name):
        return os.path.join(self.folder, name)

    def done(self, task, outcome=run_task.DONE):
        window.wait(lambda: task.outcome, "for the task")
        self.wait_for_tasks()
        self.assertEqual(task.outcome, outcome, str(task.error))
        self.assertFalse(os.path.exists(task.folder))
        return task

    def content(self, path):
        with open(path, "rb") as file:
            return file.read()

    def test_files_are_those_that_scripts_write(self):
        mesh = self.mesh(size=2, order=1)
        for ending in ("msh", "vtu", "unv", "inp"):
            self.done(file_tasks.export(mesh, self.path("a." + ending)))
            export_mesh.write(mesh, self.path("b." + ending))
            one, two = (import_mesh.read(self.path(name + ending)) for name in ("a.", "b."))
            np.testing.assert_array_equal(one.nodes, two.nodes, ending)
            np.testing.assert_array_equal(one.quads, two.quads, ending)
            self.assertEqual(one.face_names, two.face_names)
        self.assertEqual(self.document.UndoCount, 0)

    def test_groups_of_the_analysis_come_along(self):
        import ObjectsFem
        mesh = self.mesh()
        made = ObjectsFem.makeAnalysis(self.document)
        pressure = ObjectsFem.makeConstraintPressure(self.document)
        pressure.References = [(self.box, ("Face2",))]
        made.addObject(pressure)
        made.addObject(mesh)
        self.done(file_tasks.export(mesh, self.path("a.unv")))
        self.assertIn(pressure.Name + "_Faces", self.content(self.path("a.unv")).decode())
        self.assertEqual(analysis.face_groups(mesh, [self.box], ["Face1", "Face2"]), {pressure.Name + "_Faces": {1}})

    def test_what_a_format_cannot_hold_is_told_and_leaves_no_file(self):
        mesh = self.mesh(size=2, order=1)
        task = self.done(file_tasks.export(mesh, self.path("a.z88")), run_task.FAILED)
        self.assertRegex(str(task.error), "no faces of order 1 to .z88; mesh with order 2")
        self.assertIn("order 1", window.widget("Paver_Complaint").text())
        window.picture("export_refused")
        window.widget("Paver_Complaint").close()
        self.assertEqual(os.listdir(self.folder), [])

    def test_what_an_undo_takes_away_is_still_written(self):
        mesh = self.mesh()
        count = mesh.Quads
        self.document.openTransaction("Change")
        with open(self.path("other.paver"), "wb") as file:
            file.write(b"nothing")
        mesh_object.keep(mesh, file.name)
        self.document.commitTransaction()
        self.document.undo()
        task = file_tasks.export(mesh, self.path("a.msh"))
        self.document.removeObject(mesh.Name)
        self.done(task)
        self.assertEqual(len(import_mesh.read(self.path("a.msh")).quads), count)

    def test_import_reads_beside_the_window_and_draws_at_once(self):
        mesh = self.mesh(size=0.5)
        for ending in ("msh", "unv"):
            export_mesh.write(mesh, self.path("read." + ending))
            self.document.clearUndos()
            task = file_tasks.import_file(self.document, self.path("read." + ending))
            self.assertEqual(len(mesh_object.meshes_of(self.document)), 1)
            self.assertIs(run_status._box.runs[-1], task)
            self.done(task)
            made = mesh_object.meshes_of(self.document)[-1]
            self.assertEqual((made.Quads, self.document.UndoNames), (mesh.Quads, ["Import mesh"]))
            window.pause(50)
            self.assertEqual(made.ViewObject.Proxy.display.mesh.count, mesh.Quads)
            self.document.undo()

    def test_stop_leaves_nothing(self):
        mesh = self.mesh(size=0.2)
        for start in (lambda: file_tasks.export(mesh, self.path("stopped.unv")),
                      lambda: file_tasks.export(mesh, self.path("stopped.msh"))):
            task = start()
            self.assertIs(run_status._box.runs[-1], task)
            run_status._box.stop()
            self.done(task, run_task.STOPPED)
            self.assertEqual(os.listdir(self.folder), [])
        export_mesh.write(mesh, self.path("long.unv"))
        task = file_tasks.import_file(self.document, self.path("long.unv"))
        window.pause(50)
        window.picture("task_reading")
        run_status._box.stop()
        self.done(task, run_task.STOPPED)
        self.assertEqual((mesh_object.meshes_of(self.document), self.document.UndoCount), ([mesh], 0))

    def test_a_document_that_is_closed_meanwhile(self):
        mesh = self.mesh()
        export_mesh.write(mesh, self.path("read.msh"))
        other = FreeCAD.newDocument("PaverOther")
        task = file_tasks.import_file(other, self.path("read.msh"))
        FreeCAD.closeDocument(other.Name)
        self.done(task, run_task.FAILED)
        self.assertIn("was closed", self.complaint())

    def test_faults_are_sentences(self):
        mesh = self.mesh()
        with open(self.path("bad.unv"), "w") as file:
            file.write("no mesh\n")
        task = self.done(file_tasks.import_file(self.document, self.path("bad.unv")), run_task.FAILED)
        self.assertIn("bad.unv cannot be read: ", self.complaint())
        self.assertEqual(len(mesh_object.meshes_of(self.document)), 1)
        with self.assertRaisesRegex(export_mesh.CannotHold, "none of the endings"):
            file_tasks.export(mesh, self.path("a.txt"))
        real = child_process.MAIN
        self.addCleanup(setattr, child_process, "MAIN", real)
        child_process.MAIN = "nowhere.py"
        task = self.done(file_tasks.export(mesh, self.path("a.unv")), run_task.FAILED)
        self.assertIn("ended without a result", self.complaint())
        self.assertIn("nowhere.py", task.error.log)
        self.assertEqual(os.listdir(self.folder), ["bad.unv"])

    def test_without_a_python_for_it_freecad_does_it_itself(self):
        mesh = self.mesh()

        def none():
            raise child_process.ChildDied("There is none.")
        real = child_process.interpreter
        self.addCleanup(setattr, child_process, "interpreter", real)
        child_process.interpreter = none
        self.done(file_tasks.export(mesh, self.path("a.unv")))
        self.done(file_tasks.import_file(self.document, self.path("a.unv")))
        self.assertEqual(mesh_object.meshes_of(self.document)[-1].Quads, mesh.Quads)
