"""The workbench in FreeCAD's window. gui_test.py runs this with a screen of its own."""
import os
import tempfile
import unittest

import FreeCAD
import FreeCADGui

import window
from paver_wb import mesh_object
from paver_wb.gui import run_control


def select(*things):
    FreeCADGui.Selection.clearSelection()
    for thing in things:
        FreeCADGui.Selection.addSelection(thing)


class Window(unittest.TestCase):
    def setUp(self):
        FreeCADGui.activateWorkbench("PaverWorkbench")
        self.document = FreeCAD.newDocument("PaverGui")
        self.box = self.document.addObject("Part::Box", "Box")
        self.document.recompute()

    def tearDown(self):
        FreeCAD.closeDocument(self.document.Name)

    def mesh_and_wait(self):
        FreeCADGui.runCommand("Paver_Mesh")
        window.wait(lambda: not run_control._runs, "for the mesh")

    def test_create_mesh_and_mesh_are_two_steps_of_undo(self):
        select(self.box)
        FreeCADGui.runCommand("Paver_CreateMesh")
        mesh, = mesh_object.meshes_of(self.document)
        self.assertEqual((mesh.Part, FreeCADGui.Selection.getSelection()), (self.box, [mesh]))
        self.assertAlmostEqual(mesh.Size.Value, 0.9)  # a twentieth of the diagonal, to one digit
        window.wait(FreeCADGui.Control.activeDialog, "for the panel")
        FreeCADGui.ActiveDocument.resetEdit()
        self.mesh_and_wait()
        self.assertEqual((mesh.Status, mesh.FemMesh.FaceCount), ("Up to date", mesh.Quads + mesh.Triangles))
        self.assertEqual(self.document.UndoNames, ["Mesh PaverMesh", "Create mesh"])
        self.document.undo()
        self.assertEqual((mesh.Status, mesh.FemMesh.FaceCount), ("Not meshed", 0))
        self.document.undo()
        self.assertEqual(mesh_object.meshes_of(self.document), [])

    def test_bad_options_leave_no_step_and_no_change(self):
        mesh = mesh_object.add(self.document, self.box, size=3)
        mesh.Frequency = 1e9
        select(mesh)
        before = self.document.UndoNames
        self.mesh_and_wait()
        self.assertEqual((mesh.Status, self.document.UndoNames), ("Not meshed", before))

    def test_a_document_made_without_a_window_gets_its_view(self):
        path = os.environ.get("PAVER_HEADLESS_DOCUMENT")  # of gui_test.py: here everything has a window
        if not path:
            self.skipTest("no document from a FreeCAD without a window")
        document = FreeCAD.openDocument(path)
        self.addCleanup(FreeCAD.closeDocument, document.Name)
        mesh, = mesh_object.meshes_of(document)
        self.assertEqual(type(mesh.ViewObject.Proxy).__name__, "MeshViewProvider")
        self.assertFalse(mesh.ViewObject.BackfaceCulling)
        self.assertEqual(mesh.ViewObject.MaxFacesShowInner, 1)
        self.assertTrue(os.path.isfile(mesh.ViewObject.Proxy.getIcon()))
        self.assertGreater(mesh.FemMesh.FaceCount, 0)

    def test_the_view_is_there_after_saving_and_opening(self):
        mesh = mesh_object.add(self.document, self.box, size=3)
        name = mesh.Name
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "made.FCStd")
            self.document.saveAs(path)
            FreeCAD.closeDocument(self.document.Name)
            self.document = FreeCAD.openDocument(path)
        provider = self.document.getObject(name).ViewObject.Proxy
        self.assertEqual(type(provider).__module__, "paver_wb.gui.view_provider")
