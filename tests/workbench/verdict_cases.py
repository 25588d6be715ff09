"""What the task panel says about a mesh. Runs in FreeCAD's window: panel_test.py."""
import os
import tempfile

import FreeCAD
import Part
from PySide import QtGui

import window
from panel_cases import PanelCase
from panel_run_cases import BOW_TIE
from paver_wb import export_mesh, import_mesh, mesh_check, meshing
from paver_wb.gui.base import measuring, verdict
from paver_wb.gui.display import colouring


class Verdicts(PanelCase):
    def verdict(self):
        """(level, text) of the line, when the check has ended."""
        window.wait(lambda: window.widget("Paver_Verdict") and window.widget("Paver_Verdict").level, "for the verdict")
        return window.widget("Paver_Verdict").level, self.text("VerdictText")

    def meshed(self, shape, **options):
        source = self.document.addObject("Part::Feature", "Source")
        source.Shape = shape
        mesh = self.add_mesh(source, **options)
        self.open(mesh)
        self.mesh_and_wait()
        return mesh

    def colour_of(self):
        return window.widget("Paver_Verdict").styleSheet().split("background: ")[1][:7]

    def test_a_good_mesh_and_one_that_is_out_of_date(self):
        mesh = self.add_mesh()
        self.open(mesh)
        self.assertIsNone(window.widget("Paver_Verdict"), "nothing is meshed")
        self.mesh_and_wait()
        self.assertEqual(self.verdict(), ("good", "Good: nothing is wrong with the mesh."))
        self.assertEqual(self.colour_of(), verdict.COLOURS[mesh_check.GOOD][0])
        window.picture("verdict_good")
        self.document.openTransaction("Size")
        mesh.Size = 1.5
        self.document.commitTransaction()
        self.assertEqual(self.verdict(), ("warning", "Warning: The mesh is out of date (changed: Size; mesh again)."))
        self.assertEqual(self.colour_of(), verdict.COLOURS[mesh_check.WARNING][0])
        self.mesh_and_wait()
        self.assertEqual(self.verdict()[0], "good")
        for step, level in ((self.document.undo, "warning"), (self.document.undo, "good")):
            step()
            self.assertEqual(self.verdict()[0], level)

    def test_imported_meshes_and_wires_alone(self):
        mesh = self.add_mesh()
        meshing.mesh(mesh)
        with tempfile.TemporaryDirectory() as folder:
            read = import_mesh.add(self.document, export_mesh.write(mesh, os.path.join(folder, "mesh.msh")))
        self.open(read)
        self.assertEqual(self.verdict(), ("good", "Good: nothing is wrong with the mesh."))
        table = window.widget("Paver_Result")
        names = [table.item(i, 0).text() for i in range(table.rowCount())]
        self.assertIn("Watertight", names)
        self.assertNotIn("Irregular nodes", names)
        window.click(self.button(QtGui.QDialogButtonBox.Cancel))
        wire = self.meshed(Part.makeLine(FreeCAD.Vector(0, 0, 20), FreeCAD.Vector(0, 0, 50)), size=5)
        self.assertEqual(self.verdict(), ("good", "Good: nothing is wrong with the mesh."))
        for colours in colouring.CHOICES:
            wire.ViewObject.ColourBy = colours
            window.pause(50)

    def test_the_worst_finding_is_told_and_the_rest_opens(self):
        self.meshed(Part.makeBox(100, 100, 50).cut(Part.makeBox(50, 100, 0.016, FreeCAD.Vector(0, 0, 49.984))), size=30)
        level, text = self.verdict()
        self.assertEqual(level, "warning")
        self.assertIn("0.016 mm instead of 30 mm", text)
        window.picture("verdict_warning")
        window.click(window.widget("Paver_VerdictDetails", QtGui.QPushButton))
        panel = window.widget("Paver_CheckPanel", QtGui.QDialog)
        window.wait(lambda: panel.findings, "for the check")
        self.assertIn(panel.findings[0].text, text)
        panel.close()
        window.wait(lambda: not measuring._open, "for the dialog to close")

    def test_a_face_that_failed_is_an_error_and_nothing_says_that_all_is_well(self):
        wire = Part.makePolygon([FreeCAD.Vector(x + 20, y) for x, y in BOW_TIE])
        mesh = self.meshed(Part.Compound([Part.makePlane(3, 3), Part.Face(wire)]), size=2)
        level, text = self.verdict()
        self.assertEqual((mesh.Status, level), ("Up to date", "error"))
        self.assertIn("Error: Face2 is not meshed", text)
        self.assertEqual(self.colour_of(), verdict.COLOURS[mesh_check.ERROR][0])
        self.assertIn("has holes", self.text("Status"))
        window.picture("verdict_error")

    def test_the_line_counts_what_else_is_bad(self):
        bad = mesh_check.Finding(mesh_check.WARNING, "It is poor.")
        note = mesh_check.Finding(mesh_check.NOTE, "It is open.")
        self.assertEqual([verdict.line(found) for found in ([bad, bad, note], [bad, note], [note], [])], [
            "Warning: It is poor. (1 more)", "Warning: It is poor.", "Good. It is open.",
            "Good: nothing is wrong with the mesh."])
