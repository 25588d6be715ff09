"""The workbench in German. Runs in FreeCAD's window: commands_test.py."""
import os
import xml.etree.ElementTree as ElementTree

import FreeCAD
import FreeCADGui
from PySide import QtGui

import window
from commands_cases import WithCommands
from paver_wb import examples, mesh_check
from paver_wb.gui import statistics_panel, check_panel
from paver_wb.gui.paths import TRANSLATIONS


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
        titles = [menu.title() for menu in FreeCADGui.getMainWindow().findChildren(QtGui.QMenu)]
        self.assertIn("Beispiele", titles)
        window.picture("commands_german")
        check.close()
        statistics.close()
        FreeCADGui.getMainWindow().findChild(QtGui.QDockWidget, "Paver_HelpPage").close()
