"""Mesh objects made with the window: in analyses, and of objects that are empty. Runs in FreeCAD's window: panel_test.py."""
import os
import tempfile

import FreeCAD
import FreeCADGui
import ObjectsFem
from PySide import QtGui

import window
from paver_wb import export_mesh, mesh_object, meshing, refinement
from paver_wb.base import proxies
from paver_wb.gui import file_tasks
from panel_cases import PanelCase


class Create(PanelCase):
    def create(self, *things):
        """The mesh object that the command makes of objects, or (object, path in it), its panel open."""
        FreeCADGui.Selection.clearSelection()
        for thing in things:
            FreeCADGui.Selection.addSelection(*(thing if isinstance(thing, tuple) else (thing,)))
        before = mesh_object.meshes_of(self.document)
        FreeCADGui.runCommand("Paver_CreateMesh")
        window.wait(lambda: window.widget("Paver_MeshButton"), "for the panel")
        made, = [mesh for mesh in mesh_object.meshes_of(self.document) if mesh not in before]
        return made

    def cancel(self):
        window.click(self.button(QtGui.QDialogButtonBox.Cancel))
        window.wait(lambda: not FreeCADGui.Control.activeDialog())

    def analysis(self):
        import FemGui
        made = ObjectsFem.makeAnalysis(self.document, "Analysis")
        FemGui.setActiveAnalysis(made)
        self.addCleanup(lambda: FemGui.setActiveAnalysis())
        return made

    def test_a_mesh_goes_into_the_active_analysis(self):
        self.create(self.box)
        self.cancel()
        analysis = self.analysis()
        self.assertEqual(mesh_object.meshes_of(self.document), [])
        self.document.clearUndos()
        mesh = self.create(self.box)
        self.assertEqual((analysis.Group, self.document.UndoNames), ([mesh], ["Create mesh"]))
        self.mesh_and_wait()
        self.assertTrue(mesh.FemMeshFilled)
        window.click(self.button(QtGui.QDialogButtonBox.Ok))
        window.wait(lambda: not FreeCADGui.Control.activeDialog())
        with tempfile.TemporaryDirectory() as folder:
            path = export_mesh.write(mesh, os.path.join(folder, "other.msh"))
            task = file_tasks.import_file(self.document, path)
            window.wait(lambda: task.outcome, "for the file")
        self.assertEqual([member.Label for member in analysis.Group], [mesh.Label, "other"])
        for _ in range(3):
            self.document.undo()
        self.assertEqual((analysis.Group, mesh_object.meshes_of(self.document)), ([], []))

    def test_an_analysis_of_another_document_is_left_alone(self):
        analysis, own = self.analysis(), self.document
        self.document = FreeCAD.newDocument("PaverOther")
        self.addCleanup(FreeCAD.closeDocument, own.Name)
        box = self.document.addObject("Part::Box", "Box")
        self.document.recompute()
        self.create(box)
        self.cancel()
        self.assertEqual(analysis.Group, [])

    def test_what_was_clicked_is_meshed_where_it_was_clicked(self):
        part = self.document.addObject("App::Part", "Part")
        part.addObject(self.box)
        link = self.document.addObject("App::Link", "Link")
        link.LinkedObject, link.Placement.Base.x = part, 40
        body = self.document.addObject("PartDesign::Body", "Body")
        body.newObject("PartDesign::AdditiveBox", "Block")
        self.document.recompute()
        for clicks, wanted in (([(link, "Box.Face1")], [link]), ([(link, "Box.Face1"), (part, "Box.Face6")], [link, self.box]),
                               ([(body, "Block.Face2"), (body, "Block.Face3")], [body])):
            mesh = self.create(*clicks)
            self.assertEqual(proxies.sources(mesh), wanted)
            self.cancel()

    def test_cancel_takes_it_back_where_nothing_is_undone(self):
        self.document.UndoMode = 0
        mesh = self.create(self.box)
        refinement.make(mesh, ["Face1"], 1)
        self.cancel()
        self.assertEqual(self.document.Objects, [self.box])

    def test_what_is_empty_is_told_in_a_sentence(self):
        for kind in ("Part::Compound", "PartDesign::Body", "App::Part"):
            thing = self.document.addObject(kind, "Empty")
            self.document.recompute()
            mesh = self.create(thing)
            window.wait(lambda: self.text("Prediction").startswith("'Empty"), f"for a sentence on {kind}")
            window.click(window.widget("Paver_MeshButton"))
            window.wait(lambda: window.widget("Paver_FaultText"), f"for an error on {kind}")
            self.assertRegex(self.text("FaultText"), "has no (faces|shape)")
            window.picture("create_empty")
            self.assertEqual(mesh.Status, "Not meshed")
            with self.assertRaisesRegex(Exception, "has no (faces|shape)"):
                meshing.mesh(mesh)
            self.cancel()
            self.document.removeObject(thing.Name)
