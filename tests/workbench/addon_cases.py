"""The add-on as FreeCAD sees it. Run inside FreeCAD: freecadcmd -t TestPaver."""
import glob
import os
import sys
import unittest
import xml.etree.ElementTree

import FreeCAD

import paver_wb
from paver_wb import core

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.realpath(__file__))))


class AddOn(unittest.TestCase):
    def test_package_file_is_what_freecad_reads(self):
        package = FreeCAD.Metadata(os.path.join(ROOT, "package.xml"))
        self.assertEqual((package.Name, package.Version), ("Paver", "0.1.0"))
        bench, = package.Content["workbench"]
        self.assertEqual(bench.Classname, "PaverWorkbench")
        self.assertTrue(bench.supportsCurrentFreeCAD())
        self.assertTrue(package.Maintainer[0]["name"])
        for icon in (package.Icon, bench.Icon):
            self.assertTrue(os.path.isfile(os.path.join(ROOT, icon)), icon)

    def test_package_and_core_have_one_version(self):
        self.assertEqual(FreeCAD.Metadata(os.path.join(ROOT, "package.xml")).Version, core.load().__version__)

    def test_icons_are_svg_files(self):
        icons = glob.glob(os.path.join(ROOT, "Resources", "icons", "*.svg"))
        self.assertGreater(len(icons), 1)
        for icon in icons:
            self.assertTrue(xml.etree.ElementTree.parse(icon).getroot().tag.endswith("}svg"), icon)

    def test_modules_come_from_this_add_on(self):
        self.assertTrue(os.path.realpath(paver_wb.__file__).startswith(ROOT))
        self.assertIn("TestPaver", FreeCAD.__unit_test__)

    def test_app_modules_need_no_window(self):
        """None of them loads FreeCADGui, PySide or the Gui package."""
        folder = os.path.dirname(paver_wb.__file__)
        names = [name[:-3] for name in sorted(os.listdir(folder)) if name.endswith(".py") and name != "__init__.py"]
        before = set(sys.modules)
        for name in names:
            __import__("paver_wb." + name)
        loaded = set(sys.modules) - before
        self.assertEqual([n for n in loaded if n.startswith(("FreeCADGui", "PySide", "paver_wb.gui", "pivy"))], [])

    def test_what_is_told_about_versions(self):
        text = "\n".join(core.about())
        self.assertIn("Paver " + core.load().__version__, text)
        self.assertIn("FreeCAD " + FreeCAD.Version()[0], text)
