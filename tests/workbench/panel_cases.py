"""The task panel of a mesh object, with clicks. Runs in FreeCAD's window: panel_test.py."""
import unittest

import FreeCAD
import FreeCADGui
from PySide import QtCore, QtGui

try:
    import shiboken2 as shiboken
except ImportError:
    import shiboken6 as shiboken

import window
from paver_wb import core, mesh_object, refinement
from paver_wb.gui import run_control
from paver_wb.gui.base import background, edit_panel, first_view

PANEL_WIDTH = 360
LONG = {"size": 0.03, "max_elements": 3000000}  # a run that takes a while


class PanelCase(unittest.TestCase):
    """A document with a box and a coarse mesh object of it."""

    def setUp(self):
        FreeCADGui.activateWorkbench("PaverWorkbench")
        main = FreeCADGui.getMainWindow()
        main.resize(1560, 960)
        window.clear()
        self.document = FreeCAD.newDocument("PaverPanel")
        self.box = self.document.addObject("Part::Box", "Box")
        self.document.recompute()
        first_view.show_all(FreeCADGui.ActiveDocument.ActiveView)
        for dock in window.all_widgets(QtGui.QDockWidget):
            if dock.objectName() in ("Python console", "Report view"):
                dock.hide()
        main.resizeDocks([window.task_dock()], [PANEL_WIDTH], QtCore.Qt.Horizontal)

    def tearDown(self):
        if FreeCADGui.Control.activeDialog():
            self.button(QtGui.QDialogButtonBox.Cancel).click()
            window.pause(50)
        if self.document is not None:
            FreeCAD.closeDocument(self.document.Name)
        window.wait(lambda: not run_control._runs and not background._running, "for runs to end")

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
        return window.standard_button(which)

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
    def test_a_script_that_closes_the_panel_leaves_nothing_that_follows_the_document(self):
        mesh = self.add_mesh()
        self.open(mesh)
        FreeCADGui.Control.closeDialog()
        window.pause(100)
        mesh.Size = 3  # a traceback of something that is gone would fail the whole test
        self.box.Length = 12
        self.document.recompute()
        window.pause(100)
        self.assertIsNone(edit_panel._open)

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

    def test_the_count_of_the_mesh_stands_where_the_prediction_was(self):
        mesh = self.add_mesh()
        self.open(mesh)

        def wait_for(beginning):
            window.wait(lambda: self.text("Prediction").startswith(beginning), f"for '{beginning}'")
        wait_for("About ")
        self.mesh_and_wait()
        wait_for(f"The mesh has {mesh.Quads + mesh.Triangles} elements")
        window.pause(500)
        wait_for("The mesh has ")
        window.picture("panel_count")
        for change, back in ((lambda: window.type_into(window.widget("Paver_size"), "1.5 mm"),
                              lambda: window.type_into(window.widget("Paver_size"), "2 mm")),
                             (lambda: setattr(mesh, "Size", 3), lambda: setattr(mesh, "Size", 2)),
                             (lambda: self.set_height(12), lambda: self.set_height(10))):
            change()
            wait_for("About ")
            back()
            wait_for("The mesh has ")
        window.click(self.button(QtGui.QDialogButtonBox.Cancel))
        self.open(mesh)
        wait_for("The mesh has ")
        refinement.make(mesh, ["Face1"], 1)
        wait_for("About ")
        self.document.undo()
        wait_for("About ")
        self.assertEqual(mesh.Status, "Not meshed")

    def set_height(self, height):
        self.box.Height = height
        self.document.recompute()

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

    def test_apply_meshes_in_one_step_and_cancel_drops_the_rest(self):
        mesh = self.add_mesh()
        self.open(mesh)
        window.type_into(window.widget("Paver_size"), "1.5")
        window.widget("Paver_order").setCurrentIndex(0)
        self.assertEqual((mesh.Size.Value, mesh.Order, self.document.UndoNames), (2, 2, []))
        window.click(self.button(QtGui.QDialogButtonBox.Apply))
        self.assertFalse(self.button(QtGui.QDialogButtonBox.Apply).isEnabled())
        window.wait(lambda: mesh.Status == "Up to date", "for the mesh")
        window.wait(lambda: self.button(QtGui.QDialogButtonBox.Apply).isEnabled())
        self.assertEqual((mesh.Size.Value, mesh.Order, self.document.UndoNames), (1.5, 1, ["Mesh PaverMesh"]))
        window.type_into(window.widget("Paver_size"), "1.2")
        window.click(self.button(QtGui.QDialogButtonBox.Cancel))
        window.wait(lambda: not FreeCADGui.Control.activeDialog())
        self.assertEqual((mesh.Size.Value, mesh.Status, self.document.UndoCount), (1.5, "Up to date", 1))
        self.document.undo()
        self.assertEqual((mesh.Size.Value, mesh.Order, mesh.Status), (2, 2, "Not meshed"))

    def test_apply_needs_fields_with_values(self):
        self.open(self.add_mesh())
        window.type_into(window.widget("Paver_size"), "wide")
        self.assertFalse(self.button(QtGui.QDialogButtonBox.Apply).isEnabled())
        window.click(self.button(QtGui.QDialogButtonBox.Ok))
        self.assertIn("cannot be read", self.text("FaultText"))
        window.type_into(window.widget("Paver_size"), "2 mm")
        self.assertIsNone(window.widget("Paver_FaultText"))  # its cause has gone
        self.assertTrue(self.button(QtGui.QDialogButtonBox.Apply).isEnabled())

    def test_an_error_goes_with_its_cause(self):
        mesh = self.add_mesh(size=0.5, max_elements=100)
        self.open(mesh)
        changes = (lambda: window.type_into(window.widget("Paver_size"), "0.4"), lambda: setattr(mesh, "Size", 0.6),
                   lambda: self.set_height(11), lambda: refinement.make(mesh, ["Face1"], 0.3))
        for change in changes:
            self.mesh_and_wait()
            self.assertIn("raise 'Most elements'", self.text("FaultText"))
            change()
            self.assertIsNone(window.widget("Paver_FaultText"))

    def test_what_cannot_be_read_is_seen_in_every_theme(self):
        """White on red, whatever colours the theme has for fields."""
        self.addCleanup(QtGui.QApplication.instance().setStyleSheet, QtGui.QApplication.instance().styleSheet())
        QtGui.QApplication.instance().setStyleSheet("QLineEdit { color: #eeeeee; background-color: #202020 }")
        self.open(self.add_mesh())
        field = window.widget("Paver_size")
        window.type_into(field, "wide")
        field.deselect()
        window.picture("panel_dark_fault")
        image = field.grab().toImage()
        colours = [image.pixelColor(x, y) for x in range(image.width()) for y in range(image.height())]
        self.assertGreater([colour.name() for colour in colours].count("#c01c28"), len(colours) / 2)
        self.assertGreater(sum(min(colour.getRgb()[:3]) > 150 for colour in colours), 20)

    def test_figures_keep_their_units_where_the_panel_is_narrow(self):
        mesh = self.add_mesh(size=1.2345)
        self.open(mesh)
        self.mesh_and_wait()
        window.wait(lambda: window.widget("Paver_Result"), "for figures")
        table = window.widget("Paver_Result")
        for name in ("Skalierte Jacobi-Determinante aller Elemente", "Elements"):  # as long as other languages have it
            table.item(0, 0).setText(name)
            for row in range(table.rowCount()):
                needed = table.fontMetrics().horizontalAdvance(table.item(row, 1).text())
                self.assertLess(needed, table.columnWidth(1))
            self.assertLessEqual(table.columnWidth(0) + table.columnWidth(1), table.viewport().width())
        told = {table.item(row, 0).text(): table.item(row, 1).text() for row in range(table.rowCount())}
        self.assertRegex(told["Scaled Jacobian"], "^min .*, mean ")
        self.assertRegex(told["Edge length"], " mm$")

    def test_a_small_screen_shows_what_meshes_and_the_prediction(self):
        FreeCADGui.getMainWindow().resize(1024, 768)
        window.dock("Report view")
        self.open(self.add_mesh())
        window.wait(lambda: "elements" in self.text("Prediction"), "for a prediction")
        window.pause(200)
        window.picture("panel_small_screen")
        for name in ("MeshButton", "Prediction", "size", "frequency"):
            part = window.widget("Paver_" + name)
            self.assertEqual(part.visibleRegion().boundingRect(), part.rect(), name)

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

    def test_an_undo_of_something_else_leaves_what_is_typed(self):
        mesh = self.add_mesh()
        self.document.openTransaction("Label")
        self.box.Label = "Other"
        self.document.commitTransaction()
        self.open(mesh)
        window.type_into(window.widget("Paver_size"), "1 mm")
        self.document.undo()
        window.pause(100)
        self.assertEqual((self.box.Label, self.text("size"), mesh.Size.Value), ("Box", "1 mm", 2))
        self.mesh_and_wait()
        self.assertEqual(mesh.Size.Value, 1)

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
        for which in (QtGui.QDialogButtonBox.Ok, QtGui.QDialogButtonBox.Apply, QtGui.QDialogButtonBox.Cancel):
            self.assertNotEqual(self.button(which).toolTip(), "")

    def test_python_knows_no_box_that_is_gone(self):
        mesh = self.add_mesh()
        for _ in range(2):
            self.open(mesh)
            window.click(self.button(QtGui.QDialogButtonBox.Cancel))
            window.wait(lambda: not window.widget("Paver_MeshButton"), "for the panel to go")
            window.pause(200)
        known = [w for w in shiboken.getAllValidWrappers() if isinstance(w, QtGui.QDialogButtonBox)]
        self.assertLessEqual(len(known), len(window.all_widgets(QtGui.QDialogButtonBox)))

    def test_no_text_is_clipped(self):
        main = FreeCADGui.getMainWindow()
        dock = window.task_dock()
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
