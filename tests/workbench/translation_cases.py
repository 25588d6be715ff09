"""The workbench in German. Runs in FreeCAD's window: commands_test.py."""
import os
import xml.etree.ElementTree as ElementTree

import FreeCAD
import FreeCADGui
from PySide import QtGui

import window
from commands_cases import WithCommands
from paver_wb import core, examples, mesh_check, mesh_object, properties, refinement, series
from paver_wb.base.paths import TRANSLATIONS
from paver_wb.gui import check_panel, run_control, statistics_panel
from paver_wb.gui.commands import files
from paver_wb.gui.display import view_properties
from paver_wb.gui.panels import fields


class Translations(WithCommands):
    def setUp(self):
        super().setUp()
        FreeCADGui.setLocale("German")
        self.addCleanup(FreeCADGui.setLocale, "English")

    def test_every_text_is_shown_in_german(self):
        root = ElementTree.parse(os.path.join(TRANSLATIONS, "Paver_de.ts")).getroot()
        count = 0
        for context in root.iter("context"):
            for message in context.iter("message"):
                shown = FreeCAD.Qt.translate(context.findtext("name"), message.findtext("source"))
                self.assertEqual(shown, message.findtext("translation"))
                count += 1
        self.assertGreater(count, 200)

    def test_the_property_editor_is_german(self):
        mesh = self.mesh(size=3)
        child = refinement.make(mesh, ["Face1"], 1)
        groups = {mesh_object.INPUT, mesh_object.RESULT, properties.GROUP, refinement.GROUP, view_properties.COLOURS,
                  view_properties.SHAPE, view_properties.MARKS}
        count = 0
        for thing in (mesh, child, mesh.ViewObject):
            for name in thing.PropertiesList:
                if thing.getGroupOfProperty(name) in groups:
                    text = thing.getDocumentationOfProperty(name)
                    self.assertNotEqual(FreeCAD.Qt.translate("App::Property", text), text, f"{name}: run "
                                        "scripts/translations")
                    count += 1
        self.assertGreater(count, 45)
        self.assertTrue(all(FreeCAD.Qt.translate("App::Property", group) != group for group in groups))
        self.assertEqual((mesh.Status, mesh.MeshStatus), ("Out of date", "Veraltet"))
        window.tree_dock()
        FreeCADGui.Selection.clearSelection()
        FreeCADGui.Selection.addSelection(mesh)
        window.pause(500)
        shown = {}
        for view in window.widgets(QtGui.QTreeView):
            model = view.model()
            for row in range(model.rowCount() if model else 0):
                group = model.index(row, 0)
                shown.update({model.index(k, 0, group).data(): model.index(k, 1, group).data()
                              for k in range(model.rowCount(group))})
        self.assertEqual(shown.get("Mesh Status"), "Veraltet")
        self.assertNotIn("Status", shown)
        window.picture("commands_german_properties")

    def test_choices_formats_and_errors_are_german(self):
        connect = next(info for info in core.load().options() if info["name"] == "connect")
        field = fields.field_for(connect)
        self.assertEqual((field.itemText(1), field.itemData(1)), ("nur äußere Haut (union)", "union"))
        self.assertIn("STL, ebene Dreiecke (*.stl)", files.export_filters())
        with self.assertRaisesRegex(ValueError, "^Frequenz 'x' einer Reihe"):
            series.number_of("frequency", "x")
        for call in (mesh_object.path_of, run_control.start):
            with self.assertRaisesRegex(Exception, "nicht vernetzt|kein Objekt"):
                call(mesh_object.add(self.document, []))

    def test_commands_and_dialogs_are_german(self):
        self.assertEqual(examples.title("box.step"), "Quader")
        mesh = self.mesh(frequency="30 GHz")
        texts = [finding.text for finding in mesh_check.check(mesh)]
        self.assertIn("Alle Elemente sind Vierecke.", texts)
        statistics, check = statistics_panel.show(mesh), check_panel.show(mesh)
        FreeCADGui.runCommand("Paver_Help")
        window.wait(lambda: statistics.figures and check.findings, "for figures")
        check.move(760, 560)
        statistics.move(20, 60)
        window.pause(300)
        self.assertEqual(statistics.windowTitle(), f"Statistik von {mesh.Label}")
        page = window.widget("Paver_HelpPageText", QtGui.QTextBrowser)
        self.assertIn("Ein Netz in vier Schritten", page.toPlainText())
        titles = [menu.title() for menu in window.all_widgets(QtGui.QMenu)]
        self.assertIn("Beispiele", titles)
        window.picture("commands_german")
        check.close()
        statistics.close()
        window.dock("Paver_HelpPage").close()

    def test_nothing_is_cut_off_by_long_words(self):
        mesh = self.mesh(size=3)
        FreeCADGui.ActiveDocument.setEdit(mesh.Name)
        window.wait(lambda: window.widget("Paver_More"), "for the panel")
        window.click(window.widget("Paver_More"))
        window.pause(300)
        areas = [area for area in window.widgets(QtGui.QScrollArea) if area.isAncestorOf(window.widget("Paver_More"))]
        for area in areas:
            self.assertLessEqual(area.widget().minimumSizeHint().width(), area.viewport().width())
        self.assertTrue(areas)
        window.picture("commands_german_options")
        window.click_standard(QtGui.QDialogButtonBox.Cancel)
        dialog = statistics_panel.show(mesh)
        window.wait(lambda: dialog.figures, "for figures")
        window.pause(100)
        self.assertEqual(dialog.table.horizontalScrollBar().maximum(), 0)
        dialog.close()
