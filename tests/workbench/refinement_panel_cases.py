"""The task panel of a refinement. Runs in FreeCAD's window: panel_test.py."""
import FreeCADGui
from PySide import QtGui

import window
from paver_wb import mesh_object, meshing, refinement
from panel_cases import PanelCase


class RefinementPanel(PanelCase):
    def refined(self, **options):
        mesh = self.add_mesh(**options)
        child = refinement.make(mesh, [(self.box, ["Face6", "Edge1"])], 1)
        self.document.recompute()
        self.document.clearUndos()
        return mesh, child

    def open_panel(self, child):
        FreeCADGui.ActiveDocument.setEdit(child.Name)
        window.wait(lambda: window.widget("Paver_RefinementWhere"), "for the panel")

    def lines(self):
        shown = window.widget("Paver_RefinementWhere", QtGui.QListWidget)
        return [shown.item(row).text() for row in range(shown.count())]

    def select(self, *elements):
        FreeCADGui.Selection.clearSelection()
        for element in elements:
            FreeCADGui.Selection.addSelection(self.box, element)

    def choose(self, number):
        by = window.widget("Paver_RefinementBy")
        by.setCurrentIndex(number)
        by.activated.emit(number)

    def ok(self):
        window.click(self.button(QtGui.QDialogButtonBox.Ok))
        window.pause(50)

    def test_double_click_edits_length_and_references_in_one_step(self):
        mesh, child = self.refined()
        window.pause(300)  # FreeCAD fills its tree late
        for tree in window.widgets(QtGui.QTreeWidget):
            tree.expandAll()
        window.double_click(child)
        window.wait(lambda: window.widget("Paver_RefinementWhere"), "for the panel")
        self.assertEqual((self.lines(), self.text("RefinementLength")), (["Box: Face6", "Box: Edge1"], "1 mm"))
        self.assertEqual(FreeCADGui.Selection.getSelectionEx()[0].SubElementNames, ("Face6", "Edge1"))
        self.assertFalse(window.widget("Paver_RefinementEpsR"))
        window.picture("panel_refinement")
        window.type_into(window.widget("Paver_RefinementLength"), "0.4 mm")
        self.select("Face3", "Vertex2", "Face6")
        window.click(window.widget("Paver_RefinementAdd"))
        self.assertEqual(self.lines(), ["Box: Face6", "Box: Edge1", "Box: Face3", "Box: Vertex2"])
        window.widget("Paver_RefinementWhere").setCurrentRow(1)
        self.assertEqual(FreeCADGui.Selection.getSelectionEx()[0].SubElementNames, ("Edge1",))
        window.click(window.widget("Paver_RefinementRemove"))
        self.assertEqual((child.Length.Value, self.document.UndoCount), (1, 0))
        self.ok()
        self.assertFalse(FreeCADGui.Control.activeDialog())
        self.assertEqual((child.Length.Value, child.References), (0.4, [(self.box, ("Face6", "Face3", "Vertex2"))]))
        self.assertEqual(self.document.UndoNames, [f"Size of {child.Label}"])
        self.document.undo()
        self.assertEqual((child.Length.Value, child.References), (1, [(self.box, ("Face6", "Edge1"))]))

    def test_a_medium_and_cancel(self):
        mesh, child = self.refined(frequency="30 GHz")
        self.open_panel(child)
        self.choose(1)
        self.assertFalse(window.widget("Paver_RefinementLength"))
        window.type_into(window.widget("Paver_RefinementEpsR"), "4")
        window.picture("panel_refinement_medium")
        window.click(self.button(QtGui.QDialogButtonBox.Cancel))
        window.pause(50)
        self.assertEqual((child.By, self.document.UndoCount), ("Length", 0))
        self.open_panel(child)
        self.choose(1)
        window.type_into(window.widget("Paver_RefinementEpsR"), "4")
        self.ok()
        self.assertEqual((child.By, child.EpsR, child.MuR, self.document.UndoCount), ("Medium", 4, 1, 1))
        self.open_panel(child)
        self.ok()
        self.assertEqual(self.document.UndoCount, 1, "nothing was changed")

    def test_faults_stay_in_the_panel(self):
        mesh, child = self.refined()
        ball = self.document.addObject("Part::Sphere", "Ball")
        self.document.recompute()
        self.document.clearUndos()
        self.open_panel(child)
        FreeCADGui.Selection.clearSelection()
        window.click(window.widget("Paver_RefinementAdd"))
        self.assertIn("Nothing of the model is selected", self.text("FaultText"))
        FreeCADGui.Selection.addSelection(ball, "Face1")
        window.click(window.widget("Paver_RefinementAdd"))
        self.assertIn("not among", self.text("FaultText"))
        window.picture("panel_refinement_fault")
        for text, words in (("two", "cannot be read"), ("0", "above 0"), ("3 GHz", "cannot be read")):
            window.type_into(window.widget("Paver_RefinementLength"), text)
            window.click(self.button(QtGui.QDialogButtonBox.Ok))
            self.assertIn(words, self.text("FaultText"))
        window.type_into(window.widget("Paver_RefinementLength"), "2")
        window.widget("Paver_RefinementWhere").selectAll()
        window.click(window.widget("Paver_RefinementRemove"))
        window.click(self.button(QtGui.QDialogButtonBox.Ok))
        self.assertIn("Nothing is refined", self.text("FaultText"))
        self.assertEqual((child.Length.Value, self.document.UndoCount), (1, 0))
        self.document.removeObject(child.Name)
        window.wait(lambda: not FreeCADGui.Control.activeDialog(), "for the panel to go")

    def test_refine_opens_it_and_cancel_takes_the_refinement_back(self):
        mesh = self.add_mesh()
        for is_kept in (False, True):
            self.select("Face6")
            FreeCADGui.runCommand("Paver_Refine")
            window.wait(lambda: window.widget("Paver_RefinementLength"), "for the panel")
            self.assertEqual(self.text("RefinementLength"), "0.7 mm")
            if is_kept:
                window.type_into(window.widget("Paver_RefinementLength"), "0.3")
                self.ok()
            else:
                window.click(self.button(QtGui.QDialogButtonBox.Cancel))
                window.pause(50)
            self.assertEqual(len(mesh.Refinements), is_kept)
        self.assertEqual(mesh.Refinements[0].Length.Value, 0.3)

    def test_every_field_and_button_has_a_tooltip(self):
        mesh, child = self.refined()
        self.open_panel(child)
        shown = [w for w in window.widgets(QtGui.QWidget) if w.objectName().startswith("Paver_Refinement")]
        self.assertGreater(len(shown), 6)
        self.assertEqual([w.objectName() for w in shown if not w.toolTip()], [])

    def test_elements_of_the_mesh_are_refined_by_their_faces(self):
        other = self.document.addObject("Part::Box", "Other")
        other.Placement.Base.x = 30
        self.document.recompute()
        for parts, expected in (([self.box], ["Box: Face2", "Box: Face5"]), ([self.box, other], ["Other: Face3"])):
            mesh = self.add_mesh(*parts, size=5)
            meshing.mesh(mesh)
            stored = mesh_object.stored(mesh)
            wanted = [line.replace("Box: ", "" if len(parts) < 2 else "Box_").replace("Other: ", "Other_") for line in expected]
            FreeCADGui.Selection.clearSelection()
            for i, face in enumerate(stored.quad_faces, 1):
                if stored.face_names[face] in wanted:
                    FreeCADGui.Selection.addSelection(mesh, f"Elem{i}")
            FreeCADGui.runCommand("Paver_Refine")
            window.wait(lambda: window.widget("Paver_RefinementWhere"), "for the panel")
            self.assertEqual(self.lines(), expected)
            self.ok()
            self.assertEqual(mesh.Refinements[0].References[0][1], tuple(line.split(": ")[1] for line in expected))
        self.box.Length = 12
        self.document.recompute()
        FreeCADGui.Selection.clearSelection()
        FreeCADGui.Selection.addSelection(mesh, "Elem1")
        FreeCADGui.runCommand("Paver_Refine")
        window.wait(lambda: window.widget("Paver_Complaint"), "for an error")
        self.assertIn("has changed since meshing", window.widget("Paver_Complaint").text())
        window.widget("Paver_Complaint").close()

    def test_a_mesh_without_a_target_length(self):
        mesh = self.add_mesh(frequency="30 GHz")
        mesh.Divisions = 0
        FreeCADGui.Selection.clearSelection()
        FreeCADGui.Selection.addSelection(self.box, "Face1")
        FreeCADGui.runCommand("Paver_Refine")
        window.wait(lambda: window.widget("Paver_RefinementLength"), "for the panel")
        self.assertEqual(mesh.Refinements[0].Length.Value, 1)

    def test_a_length_without_effect_is_told(self):
        mesh, child = self.refined()  # of 2 mm
        self.open_panel(child)
        self.assertIsNone(window.widget("Paver_RefinementNote"))
        window.type_into(window.widget("Paver_RefinementLength"), "2")
        self.assertIn("No effect: 2 mm is not below the target length of the mesh, 2 mm.", self.text("RefinementNote"))
        window.picture("panel_refinement_no_effect")
        window.type_into(window.widget("Paver_RefinementLength"), "1.5")
        self.assertIsNone(window.widget("Paver_RefinementNote"))


class NamedPanel(PanelCase):
    """Panels of media, ports and wires."""

    def select(self, *elements):
        FreeCADGui.Selection.clearSelection()
        for element in elements:
            FreeCADGui.Selection.addSelection(self.box, element)

    def run_command(self, name):
        FreeCADGui.runCommand(name)
        window.wait(lambda: window.widget("Paver_NamedLabel"), "for the panel")

    def ok(self):
        window.click(self.button(QtGui.QDialogButtonBox.Ok))
        window.pause(50)

    def test_a_medium_of_a_card_for_the_solid_of_the_selected_face(self):
        mesh = self.add_mesh(frequency="30 GHz")
        self.select("Face6")
        self.run_command("Paver_Medium")
        medium, = mesh.Media
        self.assertEqual(medium.References, [(self.box, ("",))])
        self.assertEqual(mesh.ViewObject.Proxy.claimChildren(), [medium])
        choice = window.widget("Paver_NamedMaterial")
        choice.setCurrentIndex(choice.findText("Water"))
        choice.activated.emit(choice.currentIndex())
        self.assertEqual((self.text("NamedEpsR"), self.text("NamedLabel")), ("80", "Water"))
        window.type_into(window.widget("Paver_NamedLossTangent"), "0.1")
        window.pause(300)
        window.picture("panel_medium")
        self.ok()
        self.assertEqual((medium.Label, medium.EpsR, medium.LossTangent), ("Water", 80, 0.1))
        self.assertEqual(self.document.UndoNames, ["Change Medium", "Medium"])
        self.document.undo()
        self.assertEqual((medium.Label, medium.EpsR), ("Medium", 1))

    def test_a_name_that_another_object_has_as_its_label(self):
        mesh = self.add_mesh()
        self.select("Edge1")
        self.run_command("Paver_Port")
        window.widget("Paver_NamedLabel").setText("Box")
        self.ok()
        port, = mesh.Ports
        self.assertEqual((port.NameInFiles, port.Label), ("Box", "Box001"))
        FreeCADGui.ActiveDocument.setEdit(port.Name)
        window.wait(lambda: window.widget("Paver_NamedLabel"), "for the panel")
        self.assertEqual(self.text("NamedLabel"), "Box")

    def test_cancel_takes_a_new_port_back_and_a_fault_is_a_sentence(self):
        mesh = self.add_mesh()
        self.select("Edge1", "Face3")
        self.run_command("Paver_Port")
        self.assertEqual(len(mesh.Ports), 1)
        window.widget("Paver_NamedLabel").setText("")
        self.ok()
        self.assertIn("no name", self.text("FaultText"))
        window.picture("panel_port")
        window.click(self.button(QtGui.QDialogButtonBox.Cancel))
        window.pause(100)
        self.assertEqual((mesh.Ports, self.document.UndoCount), ([], 0))

    def test_a_sketch_becomes_a_wire_that_is_meshed(self):
        mesh = self.add_mesh()
        line = self.document.addObject("Part::Line", "Whip")
        line.Z1, line.Z2 = 10, 30
        self.document.recompute()
        FreeCADGui.Selection.clearSelection()
        FreeCADGui.Selection.addSelection(line)
        self.run_command("Paver_Wire")
        window.type_into(window.widget("Paver_NamedRadius"), "0.2 mm")
        self.ok()
        wire, = mesh.Wires
        self.assertEqual((wire.Radius.Value, mesh.MoreParts), (0.2, [line]))
        self.open(mesh)
        self.mesh_and_wait()
        self.assertGreater(mesh.Lines, 3)
        window.pause(300)
        window.picture("panel_wire")

    def test_what_cannot_be_in_a_wire_is_said(self):
        mesh = self.add_mesh()
        self.select("Face1")
        FreeCADGui.runCommand("Paver_Wire")
        window.wait(lambda: window.widget("Paver_Complaint"), "for the complaint")
        self.assertIn("cannot be in a wire", window.widget("Paver_Complaint").text())
        window.widget("Paver_Complaint").close()
        self.assertEqual((mesh.Wires, self.document.UndoCount), ([], 0))
