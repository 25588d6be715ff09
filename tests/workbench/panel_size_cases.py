"""Local sizes in the task panel. Runs in FreeCAD's window: panel_test.py."""
import FreeCADGui

import window
from paver_wb import mesh_object, refinement
from paver_wb.gui import run_control
from panel_cases import PanelCase
from PySide import QtGui


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
        self.assertEqual(self.row(), ["Face6, Edge1 of Box", "Length", "0.7 mm"])
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
        self.assertEqual(self.row(1), ["Face1 of Box", "Medium", "4, 2"])
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
        self.assertEqual((len(mesh.Refinements), self.row()[0]), (1, "Face6 of Box"))

    def test_cancel_brings_the_sizes_back(self):
        mesh = self.add_mesh(frequency="30 GHz", divisions=6)
        self.open(mesh)
        self.add("Face6")
        self.add("Face1", "Edge3")
        window.click(self.button(QtGui.QDialogButtonBox.Ok))
        window.wait(lambda: not FreeCADGui.Control.activeDialog())
        self.open(mesh)
        names = [child.Name for child in mesh.Refinements]
        before, label = (mesh.Status, len(mesh.Refinements)), mesh.Refinements[1].Label
        texts = [self.row(0), self.row(1)]
        self.add("Face2")
        window.widget("Paver_Sizes").item(0, 2).setText("0.1 mm")
        window.pause(50)
        window.widget("Paver_Sizes").selectRow(1)
        window.click(window.widget("Paver_RemoveSize"))
        window.pause(50)
        self.assertEqual(len(mesh.Refinements), 2)
        steps = self.document.UndoCount
        window.click(self.button(QtGui.QDialogButtonBox.Cancel))
        window.wait(lambda: not FreeCADGui.Control.activeDialog())
        self.assertEqual((mesh.Status, len(mesh.Refinements)), before)
        self.assertEqual(([child.Name for child in mesh.Refinements], mesh.Refinements[1].Label), (names, label))
        self.assertEqual((self.document.UndoCount, self.document.UndoNames[0]), (steps + 1, "Drop local sizes"))
        self.open(mesh)
        self.assertEqual([self.row(0), self.row(1)], texts)
        self.mesh_and_wait()
        window.click(self.button(QtGui.QDialogButtonBox.Cancel))
        window.wait(lambda: not FreeCADGui.Control.activeDialog())
        self.assertEqual((mesh.Status, len(mesh.Refinements)), ("Up to date", 2))

    def test_cancel_takes_a_new_mesh_with_sizes_back(self):
        FreeCADGui.Selection.addSelection(self.box)
        FreeCADGui.runCommand("Paver_CreateMesh")
        window.wait(lambda: window.widget("Paver_MeshButton"), "for the panel")
        self.add("Face6")
        window.widget("Paver_Sizes").item(0, 2).setText("0.1 mm")
        window.pause(50)
        window.click(self.button(QtGui.QDialogButtonBox.Cancel))
        window.wait(lambda: not FreeCADGui.Control.activeDialog())
        self.assertEqual([thing.Name for thing in self.document.Objects], ["Box"])

    def test_nothing_selected_is_told(self):
        mesh = self.add_mesh()
        self.open(mesh)
        self.add()
        self.assertIn("select", self.text("FaultText"))
        self.assertEqual((mesh.Refinements, self.document.UndoCount), ([], 0))

    def test_what_has_no_effect_is_told(self):
        mesh = self.add_mesh(frequency="30 GHz", divisions=10)  # 1 mm
        self.open(mesh)
        self.add("Face6")
        self.assertIsNone(window.widget("Paver_SizesNote"))
        window.widget("Paver_Sizes").item(0, 2).setText("3 mm")
        window.pause(50)
        self.assertIn("Face6 of Box: No effect: 3 mm is not below", self.text("SizesNote"))
        window.picture("panel_sizes_no_effect")
        window.type_into(window.widget("Paver_divisions"), "2")
        self.assertIsNone(window.widget("Paver_SizesNote"))
        window.type_into(window.widget("Paver_divisions"), "10")
        self.assertIn("No effect", self.text("SizesNote"))
        refinement.set_value(mesh.Refinements[0], eps_r=4)
        window.pause(50)
        self.assertIsNone(window.widget("Paver_SizesNote"))
        window.type_into(window.widget("Paver_eps_r"), "5")
        self.assertIn("No effect", self.text("SizesNote"))

    def test_the_face_is_seen_in_a_narrow_panel(self):
        self.box.Label = "The large reflector of the antenna on the mast"
        mesh = self.add_mesh()
        self.open(mesh)
        self.add("Face6", "Face3")
        table = window.widget("Paver_Sizes", QtGui.QTableWidget)
        begin = "Face3, Face6" if self.row()[0].startswith("Face3") else "Face6, Face3"
        self.assertTrue(self.row()[0].startswith(begin))
        self.assertLess(table.fontMetrics().horizontalAdvance(begin + "..."), table.columnWidth(0))
        window.picture("panel_sizes_where")

    def test_elements_of_the_mesh_stand_for_their_faces(self):
        mesh = self.add_mesh()
        self.open(mesh)
        self.mesh_and_wait()
        stored = mesh_object.stored(mesh)
        element = next(i for i, face in enumerate(stored.quad_faces, 1) if stored.face_names[face] == "Face4")
        FreeCADGui.Selection.clearSelection()
        FreeCADGui.Selection.addSelection(mesh, f"Elem{element}")
        window.click(window.widget("Paver_AddSize"))
        window.pause(50)
        self.assertEqual(self.row()[0], "Face4 of Box")
