"""Lengths in the user's units, where they are written and where they are read. Runs in FreeCAD's window: panel_test.py."""
import FreeCAD
import FreeCADGui

import window
from paver_wb import refinement, statistics
from paver_wb.base import units
from paver_wb.gui.display import actions, colouring, report
from paver_wb.gui.panels import fields, sizes_box
from panel_cases import PanelCase
from PySide import QtGui

METRIC, US, IMPERIAL, CIVIL, INCH = 0, 2, 3, 7, 25.4


class Units(PanelCase):
    def setUp(self):
        super().setUp()
        self.addCleanup(FreeCAD.Units.setSchema, FreeCAD.Units.getSchema())
        self.choose(IMPERIAL)

    def choose(self, schema):
        if "UnitSystem" in self.document.PropertiesList:  # from FreeCAD 1.0 on each document has its own
            self.document.UnitSystem = self.document.getEnumerationsOfProperty("UnitSystem")[schema]
        FreeCAD.Units.setSchema(schema)

    def add_box(self):
        self.box.Length = self.box.Width = self.box.Height = 20 * INCH
        self.document.recompute()

    def test_a_bare_number_has_the_unit_that_is_shown(self):
        self.add_box()
        mesh = self.add_mesh(size=INCH)
        self.open(mesh)
        field = window.widget("Paver_size")
        self.assertEqual(field.text(), "1 in")
        for written, shown, value in (("2", "2 in", 2 * INCH), ("2,5", "2.5 in", 2.5 * INCH), ("25.4 mm", "1 in", INCH),
                                      ("3", "3 in", 3 * INCH), ('4"', "4 in", 4 * INCH)):
            window.type_into(field, written)
            self.assertEqual(field.text(), shown)
            self.assertAlmostEqual(field.value(), value)
        window.click(window.widget("Paver_More"))
        window.type_into(window.widget("Paver_chord_error"), "0.1")  # which shows nothing before
        self.assertAlmostEqual(window.widget("Paver_chord_error").value(), 0.1 * INCH)
        self.mesh_and_wait()
        self.assertAlmostEqual(mesh.Size.Value, 4 * INCH)
        window.picture("panel_inches")

    def test_the_wave_the_figures_and_the_table_are_in_inches(self):
        self.add_box()
        mesh = self.add_mesh(size=2 * INCH)
        refinement.make(mesh, ["Face1"], INCH)
        self.open(mesh)
        self.mesh_and_wait()
        window.wait(lambda: window.widget("Paver_Result"), "for figures")
        table, sizes = window.widget("Paver_Result"), window.widget("Paver_Sizes", QtGui.QTableWidget)
        rows = {table.item(i, 0).text(): table.item(i, 1).text() for i in range(table.rowCount())}
        self.assertEqual(rows["Target length"], "2 in")
        self.assertTrue(rows["Edge length"].endswith(" in"), rows)
        self.assertEqual(sizes.item(0, 2).text(), "1 in")
        sizes.item(0, 2).setText("0.5")
        self.assertAlmostEqual(refinement.of_mesh(mesh)[0].Length.Value, 0.5 * INCH)
        window.click(window.widget("Paver_ByFrequency"))
        window.type_into(window.widget("Paver_frequency"), "0.5 GHz")
        self.assertEqual((self.text("frequency"), self.text("Wavelength")), ("500 MHz", "\u03bb = 23.61 in"))

    def test_what_the_view_and_the_statistics_tell(self):
        self.add_box()
        mesh = self.add_mesh(size=2 * INCH)
        self.open(mesh)
        self.mesh_and_wait()
        told = dict(report.rows(actions.element(mesh, "Elem1")))
        self.assertEqual((told["Edges"], told["Area"]), ("2, 2, 2, 2 in", "4 in\u00b2"))
        self.assertIn("2, 2, 2, 2 in", report.line(actions.element(mesh, "Elem1")))
        self.assertEqual(colouring.range_text(INCH, 2 * INCH), "target 1 \u2013 2 in")
        table = {row[:2]: row.value for row in statistics.rows(statistics.of_object(mesh), units.unit_of("length", INCH))}
        self.assertEqual((table["Edge length", "Target"], table["Element area", "Mean"]), ("2 in", "4 in²"))

    def test_every_schema_reads_what_it_shows(self):
        mesh = self.add_mesh()
        sized = refinement.make(mesh, ["Face1"], 1)
        for schema in range(len(FreeCAD.Units.listSchemas())):
            FreeCAD.Units.setSchema(schema)
            for value in (0.004, 0.9, 12.5, 700, 2.5e6):
                field = fields.QuantityField("length")
                field.set_value(value)
                self.assertAlmostEqual(fields.parsed("length", field.text()) / value, 1, 5, field.text())
                field.setText(field.text().split()[0])
                field.read()
                self.assertAlmostEqual(field.value() / value, 1, 5, field.text())
                sized.Length = value
                bare = sizes_box.value_text(sized).split()[0]
                self.assertAlmostEqual(sizes_box.value_of(sized, bare)["length"] / value, 1, 5)
        for schema, text, value in ((US, "2", 2 * INCH), (CIVIL, "2", 2 * 12 * INCH), (METRIC, "2", 2)):
            FreeCAD.Units.setSchema(schema)
            self.assertAlmostEqual(units.parsed("length", text), value)
