"""Meshing in a process of its own. Run inside FreeCAD: freecadcmd -t TestPaver."""
import os
import signal
import tempfile
import unittest

import FreeCAD
import numpy as np

from paver_wb import core, mesh_object, meshing
from paver_wb.formats import mesh_file
from paver_wb.processes import child_process, mesh_job


def children():
    """Ids of the processes that this one has started."""
    found = []
    for entry in filter(str.isdigit, os.listdir("/proc")):
        try:
            with open(f"/proc/{entry}/stat") as file:
                fields = file.read().rsplit(")", 1)[1].split()
        except OSError:
            continue
        if int(fields[1]) == os.getpid() and fields[0] != "Z":
            found.append(int(entry))
    return found


class ChildProcess(unittest.TestCase):
    def setUp(self):
        self.document = FreeCAD.newDocument("PaverChild", hidden=True)
        self.document.UndoMode = 1
        self.box, self.ball = (self.document.addObject("Part::" + kind, kind) for kind in ("Box", "Sphere"))
        self.ball.Placement.Base.x = 40
        self.document.recompute()
        self.mesh = mesh_object.add(self.document, [self.box, self.ball], size=2)
        folder = tempfile.TemporaryDirectory(dir=os.path.dirname(self.document.TransientDir))
        self.addCleanup(folder.cleanup)
        self.folder = folder.name

    def tearDown(self):
        FreeCAD.closeDocument(self.document.Name)

    def run_with(self, at_progress, **changes):
        """Runs a job of many elements; at_progress() is called once, when the child has told how far it is."""
        calls = []

        def progress(stage, fraction):
            calls.append(stage)
            return at_progress() if len(calls) == 2 else None
        job = meshing.prepare(self.mesh, size=0.05, max_elements=3000000, **changes)
        return child_process.run(job, self.folder, progress)

    def test_child_gives_the_mesh_that_freecad_itself_gives(self):
        job = meshing.prepare(self.mesh)
        seen = []
        made, path = child_process.run(job, self.folder, lambda stage, fraction: seen.append(stage))
        expected = mesh_job.stored(job, mesh_job.run(job))
        self.assertEqual(made.face_names, expected.face_names)
        self.assertEqual(made.face_names[-1], "Sphere_Face1")
        for name in mesh_file.ARRAYS:
            np.testing.assert_array_equal(getattr(made, name), getattr(expected, name), name)
        self.assertEqual((seen[0], seen[-1]), ("read", "write"))
        meshing.keep(self.mesh, job, made, path)
        self.assertEqual((self.mesh.Status, self.mesh.Quads, os.path.exists(path)),
                         ("Up to date", len(expected.quads), False))
        np.testing.assert_array_equal(mesh_object.stored(self.mesh).nodes, expected.nodes)

    def test_changed_options_come_with_the_mesh_and_go_with_it(self):
        meshing.mesh(self.mesh)
        coarse = self.mesh.Quads
        changes = {"frequency": "30 GHz", "divisions": 8, "order": 1}
        job = meshing.prepare(self.mesh, **changes)
        self.assertEqual((self.mesh.Size.Value, self.mesh.Status), (2, "Up to date"))
        made, path = child_process.run(job, self.folder)
        meshing.keep(self.mesh, job, made, path, **changes)
        self.assertEqual((self.mesh.Frequency.Value, self.mesh.Size.Value, self.mesh.Status), (3e10, 0, "Up to date"))
        self.assertGreater(self.mesh.Quads, coarse)
        self.document.undo()
        self.assertEqual((self.mesh.Frequency.Value, self.mesh.Size.Value, self.mesh.Quads), (0, 2, coarse))
        self.assertEqual(self.mesh.Status, "Up to date")

    def test_errors_are_those_of_the_core_and_have_a_place(self):
        paver = core.load()
        with self.assertRaises(paver.LimitError) as caught:
            child_process.run(meshing.prepare(self.mesh, size=0.1, max_elements=100), self.folder)
        self.assertEqual((caught.exception.code, caught.exception.place), ("too_many_elements", None))
        self.assertIn("max_elements", str(caught.exception))
        job = meshing.prepare(self.mesh)
        error = paver.FaceError("It cannot be meshed.", face="Face7")
        self.assertEqual(mesh_job.place_of(job.model(), error), (1, "Face1"))
        self.assertEqual(mesh_job.place_of(job.model(), paver.InputError("Bad edge.", edge="Edge3")), (0, "Edge3"))

    def test_stopping_ends_the_process(self):
        paver, cancel = core.load(), core.load().Cancel()
        self.assertRaises(paver.Cancelled, self.run_with, lambda: False)
        self.assertEqual(children(), [])
        job = meshing.prepare(self.mesh, size=0.05, max_elements=3000000)
        self.assertRaises(paver.Cancelled, child_process.run, job, self.folder, lambda *_: cancel.set(), cancel)
        self.assertEqual(children(), [])

    def test_a_killed_and_an_aborting_child_are_told_in_a_sentence(self):
        for number, words in ((signal.SIGKILL, "memory"), (signal.SIGABRT, "SIGABRT"), (signal.SIGSEGV, "SIGSEGV")):
            with self.assertRaises(child_process.ChildDied) as caught:
                self.run_with(lambda: [os.kill(child, number) for child in children()] and None)
            self.assertIn(words, str(caught.exception))
            self.assertEqual(str(caught.exception).count("\n"), 0)

    def test_child_ends_and_cleans_up_when_its_input_closes(self):
        """As when FreeCAD dies."""
        job = meshing.prepare(self.mesh, size=0.02, max_elements=10**8)
        child_process.write_content(child_process.content_of(job, self.folder, child_process.MESH), self.folder)
        child = child_process.subprocess.Popen(
            child_process.command(self.folder), env=child_process.environment(), stdin=child_process.subprocess.PIPE,
            stdout=child_process.subprocess.PIPE, stderr=child_process.subprocess.DEVNULL)
        child.stdout.readline()
        child.stdin.close()
        self.assertEqual(child.wait(60), 1)
        child.stdout.close()
        self.assertFalse(os.path.exists(self.folder))
        os.mkdir(self.folder)

    def test_missing_python_is_told(self):
        names = child_process.sys.base_prefix, child_process.shutil.which
        self.addCleanup(lambda: (setattr(child_process.sys, "base_prefix", names[0]),
                                 setattr(child_process.shutil, "which", names[1])))
        child_process.sys.base_prefix, child_process.shutil.which = self.folder, lambda name: None
        with self.assertRaisesRegex(child_process.ChildDied, "install it"):
            child_process.run(meshing.prepare(self.mesh), self.folder)
