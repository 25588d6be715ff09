"""Commands about Paver itself."""
import FreeCADGui

from paver_wb.gui.commands.common import QT_TRANSLATE_NOOP, Command, do, run, shown_as


class Preferences(Command):
    resources = shown_as("Paver_Preferences", QT_TRANSLATE_NOOP("Paver_Preferences", "Preferences..."), QT_TRANSLATE_NOOP(
        "Paver_Preferences", "What new mesh objects start with, and from what size on work is done differently"))

    def Activated(self):
        do('FreeCADGui.showPreferences("Paver", 0)')


class Help(Command):
    resources = shown_as("Paver_Help", QT_TRANSLATE_NOOP("Paver_Help", "Help"), QT_TRANSLATE_NOOP(
        "Paver_Help", "How to make a mesh, what the options mean, what to do when something goes wrong"), "Q, H")

    def Activated(self):
        run("show()", "paver_wb.gui.help_page")


class About(Command):
    resources = shown_as("Paver_About", QT_TRANSLATE_NOOP("Paver_About", "About Paver"), QT_TRANSLATE_NOOP(
        "Paver_About", "Shows versions in the report view, for a report of a fault"))

    def Activated(self):
        FreeCADGui.addModule("paver_wb.core")
        do('FreeCAD.Console.PrintMessage("\\n".join(paver_wb.core.about()) + "\\n")')
