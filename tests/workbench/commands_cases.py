"""The commands, in FreeCAD's window: toolbar, menu, dialogs, preferences, help. Runs in FreeCAD's window: commands_test.py."""
import os
import tempfile
import unittest

import FreeCAD
import FreeCADGui
from PySide import QtCore, QtGui

import window
from paver_wb import examples, mesh_object, meshing, preferences, refinement, series, statistics
from paver_wb.base import proxies
from paver_wb.gui import commands, statistics_panel
from paver_wb.gui.base import background, first_view, measuring, run_task
from paver_wb.gui.commands import files, view

NEEDS_NOTHING = ["Paver_Import", "Paver_Preferences", "Paver_Help", "Paver_About"]
ON_MESHED = ["Paver_Check", "Paver_Statistics", "Paver_Export"]


def select(*things):
    """Objects, or (object, element)."""
    FreeCADGui.Selection.clearSelection()
    for thing in things:
        FreeCADGui.Selection.addSelection(*(thing if isinstance(thing, tuple) else (thing,)))


class WithCommands(unittest.TestCase):
    def setUp(self):
        window.clear()
        FreeCADGui.activateWorkbench("PaverWorkbench")
        FreeCADGui.getMainWindow().resize(1400, 900)
        self.lines = []  # of the Python console; a wrapper of its widget makes FreeCAD crash when it ends
        do_command = FreeCADGui.doCommand
        FreeCADGui.doCommand = lambda line: (self.lines.append(line), do_command(line))[1]
        self.addCleanup(setattr, FreeCADGui, "doCommand", do_command)
        self.document = FreeCAD.newDocument("PaverCommands")
        self.box = self.document.addObject("Part::Box", "Box")
        self.document.recompute()
        first_view.show_all(FreeCADGui.ActiveDocument.ActiveView)

    def tearDown(self):
        if FreeCADGui.Control.activeDialog():
            window.click_standard(QtGui.QDialogButtonBox.Cancel)
        for name in list(FreeCAD.listDocuments()):
            FreeCAD.closeDocument(name)
        self.wait_for_tasks()

    def console(self):
        return "\n".join(self.lines)

    def is_active(self, name):
        return FreeCADGui.Command.get(name).isActive()

    def active(self):
        return [name for name in commands.COMMANDS if self.is_active(name)]

    def mesh(self, is_meshed=True, **options):
        made = mesh_object.add(self.document, self.box, **(options or {"size": 2}))
        self.document.recompute()
        if is_meshed:
            meshing.mesh(made)
        self.document.clearUndos()
        return made

    def wait_for_tasks(self):
        window.wait(lambda: not run_task._tasks and not background._running, "for tasks")

    def complaint(self):
        """Text of the box with an error, which is closed."""
        window.pause(30)
        box = window.widget("Paver_Complaint", QtGui.QMessageBox)
        text = box.text() if box else ""
        if box:
            box.close()
            window.pause(30)
        return text


class Commands(WithCommands):
    def test_toolbar_and_menu_have_every_command_and_each_an_icon_and_a_tip(self):
        bench = FreeCADGui.activeWorkbench()
        self.assertEqual(bench.getToolbarItems()["Paver"], commands.TOOLBAR)
        self.assertEqual(bench.getToolbarItems()["Paver view"], list(view.COMMANDS))
        known = [n for n in FreeCADGui.listCommands() if n.startswith("Paver_") and "Example" not in n]
        self.assertEqual(known, sorted([*commands.COMMANDS, *view.COMMANDS, *view.COLOURS, *view.ISOLATES]))
        keys = []
        for name in known:
            info = FreeCADGui.Command.get(name).getInfo()
            self.assertTrue(info["menuText"] and info["toolTip"], name)
            self.assertFalse(FreeCADGui.getIcon(info["pixmap"]).isNull(), name)
            keys.append(info["shortcut"])
        used = [key for key in keys if key]
        self.assertEqual(len(used), len(set(used)))
        self.assertGreaterEqual(len(used), 8)
        main = FreeCADGui.getMainWindow()
        menus = {menu.title(): menu for menu in window.all_widgets(QtGui.QMenu)}
        shown = [action for action in menus["&Paver"].actions() if not action.isSeparator()]
        self.assertEqual(len(shown), len(commands.COMMANDS) + 2)  # and the 3D view, the examples
        self.assertEqual(len(menus["Examples"].actions()), len(examples.names()))
        self.assertTrue(os.path.isfile(bench.Icon))
        for menu in window.all_widgets(QtGui.QMenu):  # some are of workbenches chosen before
            if menu.title() == "&Paver":
                menu.popup(QtCore.QPoint(300, 150))
                window.pause(300)
                if menu.isVisible():
                    window.picture("commands_menu")
                menu.hide()

    def test_commands_are_active_where_they_apply(self):
        select()
        self.assertEqual(self.active(), NEEDS_NOTHING)
        select(self.box)
        self.assertEqual(self.active(), ["Paver_CreateMesh", *NEEDS_NOTHING])
        mesh = self.mesh(is_meshed=False)
        select(mesh)
        self.assertEqual(self.active(), ["Paver_Series", "Paver_Mesh", "Paver_FillFemMesh", *NEEDS_NOTHING])
        select((self.box, "Face1"))
        self.assertEqual(self.active(), ["Paver_CreateMesh", "Paver_Refine", "Paver_Series", "Paver_Medium", "Paver_Port",
                                         "Paver_Wire", *NEEDS_NOTHING])
        meshing.mesh(mesh)
        select()
        self.assertEqual(sorted(self.active()), sorted(["Paver_Series"] + ON_MESHED + NEEDS_NOTHING), "the only mesh is meant")

    def test_refine_from_the_view_is_one_step_and_is_in_the_console(self):
        mesh = self.mesh(size=3)
        select((self.box, "Face6"), (self.box, "Edge1"))
        FreeCADGui.runCommand("Paver_Refine")
        child, = refinement.of_mesh(mesh)
        self.assertEqual(child.References, [(self.box, ("Face6", "Edge1"))])
        self.assertEqual((child.Length.Value, mesh.Status), (1, "Out of date"))
        self.assertEqual(FreeCADGui.Selection.getSelection(), [child])
        self.assertEqual(mesh.ViewObject.Proxy.claimChildren(), [child])
        self.assertIn("paver_wb.refinement.make(", self.console())
        self.assertEqual(self.document.UndoNames, ["Refine"])
        window.wait(lambda: window.widget("Paver_RefinementLength"), "for its panel")
        window.pause(300)  # until all is drawn
        window.picture("commands_refine")
        self.assertEqual(FreeCADGui.Selection.getSelectionEx()[0].SubElementNames, ("Face6", "Edge1"))
        window.click_standard(QtGui.QDialogButtonBox.Ok)
        self.assertEqual(self.document.UndoNames, ["Refine"])
        self.document.undo()
        self.assertEqual((refinement.of_mesh(mesh), mesh.Status), ([], "Up to date"))

    def test_refine_asks_which_mesh_is_meant_and_no_other_one_keeps_it_from_working(self):
        empty = self.document.addObject("PartDesign::Body", "Empty")
        mesh_object.add(self.document, empty, size=1)
        mesh = self.mesh(is_meshed=False)
        select((self.box, "Face1"))
        FreeCADGui.runCommand("Paver_Refine")
        self.assertEqual(len(refinement.of_mesh(mesh)), 1)
        window.wait(lambda: window.widget("Paver_RefinementLength"), "for its panel")
        window.click_standard(QtGui.QDialogButtonBox.Cancel)
        series.add(mesh, sizes=[1, 2])  # whose steps are not meant
        select((self.box, "Face1"))
        FreeCADGui.runCommand("Paver_Refine")
        self.assertEqual(len(refinement.of_mesh(mesh)), 1)
        window.wait(lambda: window.widget("Paver_RefinementLength"), "for its panel")
        window.click_standard(QtGui.QDialogButtonBox.Cancel)
        fine = self.mesh(is_meshed=False, size=1)
        for command in ("Paver_Refine", "Paver_Port"):
            select((self.box, "Face1"))
            FreeCADGui.runCommand(command)
            self.assertIn("There are several meshes", self.complaint())
        select((self.box, "Face1"), fine)
        FreeCADGui.runCommand("Paver_Refine")
        self.assertEqual((len(refinement.of_mesh(mesh)), len(refinement.of_mesh(fine))), (0, 1))

    def test_a_copy_that_is_deleted_takes_no_children_of_its_original_along(self):
        mesh = self.mesh(is_meshed=False)
        child = refinement.make(mesh, ["Face1"], 1)
        copy = self.document.copyObject(mesh)
        for thing, left in ((copy, [child]), (mesh, [])):
            select(thing)
            FreeCADGui.runCommand("Std_Delete")
            window.pause(50)
            self.assertEqual([other for other in self.document.Objects if proxies.is_child(other)], left)

    def test_refine_without_a_mesh_of_it_says_so(self):
        self.mesh()
        other = self.document.addObject("Part::Sphere", "Sphere")
        self.document.recompute()
        self.document.clearUndos()
        select(other)
        FreeCADGui.runCommand("Paver_Refine")
        self.assertIn("No mesh has", self.complaint())
        self.assertEqual(self.document.UndoNames, [])

    def test_deleting_a_mesh_deletes_its_refinements(self):
        mesh = self.mesh(is_meshed=False)
        refinement.make(mesh, ["Face1"], 1)
        select(mesh)
        self.document.openTransaction("Delete")
        FreeCADGui.runCommand("Std_Delete")
        self.document.commitTransaction()
        self.assertEqual([thing.Name for thing in self.document.Objects], ["Box"])

    def test_about_and_help(self):
        FreeCADGui.runCommand("Paver_About")
        FreeCADGui.runCommand("Paver_Help")
        window.pause(200)
        page = window.widget("Paver_HelpPageText", QtGui.QTextBrowser)
        self.assertIn("A mesh in four steps", page.toPlainText())
        self.assertIn("paver_wb.gui.help_page.show()", self.console())
        window.picture("commands_help")
        for link, words in (("tutorials/README.md", "One closed body"), ("one_body.md", "Create mesh")):
            page.anchorClicked.emit(QtCore.QUrl(link))
            self.assertIn(words, page.toPlainText())
        window.picture("commands_tutorial")
        self.assertFalse(page.loadResource(QtGui.QTextDocument.ImageResource, QtCore.QUrl("pictures/one_body_01.png")).isEmpty())
        FreeCADGui.runCommand("Paver_Help")
        self.assertIn("A mesh in four steps", page.toPlainText())
        window.dock("Paver_HelpPage").close()

    def test_examples_open_in_documents_of_their_own(self):
        FreeCADGui.runCommand("Paver_Example_torus")
        document = FreeCAD.ActiveDocument
        self.assertNotEqual(document, self.document)
        self.assertEqual([(o.Label, len(o.Shape.Faces)) for o in document.Objects], [("Torus", 1)])
        for name in examples.names():
            self.assertTrue(examples.about(name) != name, f"{name} has no description")
            self.assertGreater(len(examples.open_model(name).Shape.Faces), 0)


class Dialogs(WithCommands):
    def test_statistics(self):
        mesh = self.mesh(frequency="30 GHz", divisions=8)
        FreeCADGui.runCommand("Paver_Statistics")
        panel = window.widget("Paver_StatisticsPanel", QtGui.QDialog)
        self.assertIsNone(panel.figures, "the window goes on while the mesh is measured")
        self.assertTrue(panel.busy.isVisible())
        panel.copy()
        window.wait(lambda: panel.figures, "for the figures")
        self.assertFalse(panel.busy.isVisible())
        table = panel.findChild(QtGui.QTreeWidget)
        texts = {}
        for i in range(table.topLevelItemCount()):
            group = table.topLevelItem(i)
            for k in range(group.childCount()):
                texts[group.text(0), group.child(k).text(0)] = (group.child(k).text(1), group.child(k).text(2))
        self.assertEqual(texts["Elements", "Quads"][0], str(mesh.Quads))
        self.assertEqual(texts["Edge length", "Target"][1], "0.125 λ")
        self.assertEqual(texts["Unknowns (conductor)", "Basis order 1 (rooftops, RWG)"],
                         (str(2 * mesh.Quads), statistics.memory(16 * (2 * mesh.Quads) ** 2)))
        window.picture("commands_statistics")
        field = window.widget("Paver_StatisticsFrequency")
        window.type_into(field, "1.25 MHz")
        self.assertEqual((panel.figures.wave.frequency, field.text()), (1.25e6, "1.25 MHz"))
        field.selectAll()
        window.QTest.keyClick(field, QtCore.Qt.Key_Delete)
        self.assertIsNone(panel.figures.wave)
        panel.copy()
        field = QtGui.QPlainTextEdit()
        field.paste()
        self.assertIn("Quads\t" + str(mesh.Quads), field.toPlainText())
        mesh.Divisions = 4
        meshing.mesh(mesh)
        window.wait(lambda: panel.figures.quads == mesh.Quads, "for the new figures")
        self.assertIn("paver_wb.gui.statistics_panel.show(", self.console())
        self.document.removeObject(mesh.Name)
        window.wait(lambda: not measuring._open, "for the panel to close")

    def test_statistics_go_with_a_mesh_that_is_undone(self):
        mesh = self.mesh(is_meshed=False)
        meshing.mesh(mesh)
        statistics_panel.show(mesh)
        self.document.undo()
        self.assertEqual(mesh.MeshFile, "")
        window.wait(lambda: not measuring._open, "for the panel to close")

    def test_check(self):
        sheet = self.document.addObject("Part::Plane", "Sheet")
        sheet.Length, sheet.Width = 20, 10
        self.document.recompute()
        mesh = mesh_object.add(self.document, sheet, size=2, elements="all-triangle")
        meshing.mesh(mesh)
        mesh.Size = 3
        FreeCADGui.runCommand("Paver_Check")
        panel = window.widget("Paver_CheckPanel", QtGui.QDialog)
        window.wait(lambda: panel.findings, "for the check")
        lines = [panel.list.item(i).text() for i in range(panel.list.count())]
        self.assertIn("out of date", lines[0])
        self.assertTrue(any("are free" in line for line in lines))
        window.picture("commands_check")
        mesh.Size = 2
        window.click(window.widget("Paver_CheckAgain", QtGui.QPushButton))
        window.wait(lambda: not panel.busy.isVisible(), "for another check")
        self.assertEqual(window.widget("Paver_CheckVerdict", QtGui.QLabel).text(), "The mesh is sound.")
        panel.close()

    def test_export_and_import(self):
        mesh = self.mesh()
        with tempfile.TemporaryDirectory() as folder:
            for text, (ending, more) in files.export_filters().items():
                files.Export.write(mesh, files.with_ending(os.path.join(folder, "mesh"), ending), more)
                self.wait_for_tasks()
                self.assertIn("mesh." + ending, os.listdir(folder), text)
            self.assertEqual(self.complaint(), "")
            self.assertEqual(self.document.UndoNames, [])
            path = os.path.join(folder, "mesh.msh")
            files.Import.read(path)
            self.assertEqual(self.document.UndoNames, [], "the window goes on while the file is read")
            self.wait_for_tasks()
            self.assertIn("paver_wb.gui.file_tasks.export(", self.console())
            self.assertIn("paver_wb.gui.file_tasks.import_file(", self.console())
            self.assertEqual(self.document.UndoNames, ["Import mesh"])
            read = mesh_object.meshes_of(self.document)[-1]
            self.assertEqual((read.Label, read.Quads), ("mesh", mesh.Quads))
            files.Import.read(os.path.join(folder, "nowhere.msh"))
            self.wait_for_tasks()
            self.assertIn("cannot be read", self.complaint())
            self.assertEqual(self.document.UndoNames, ["Import mesh"])
            for ending in ("msh", "unv"):
                files.Export.write(mesh, os.path.join(folder, "no", "mesh." + ending), {})
                self.wait_for_tasks()
                self.assertRegex(self.complaint(), "^Cannot write|cannot be written")
            FreeCAD.closeDocument(self.document.Name)
            files.Import.read(path)
            self.wait_for_tasks()
            self.assertEqual(len(mesh_object.meshes_of(FreeCAD.ActiveDocument)), 1)

    def test_the_file_is_the_one_that_the_dialog_and_its_filter_mean(self):
        mesh, asked, proposed = self.mesh(), [], []
        mesh.Label = "Mesh 8 / λ"
        filters = {ending: text for text, (ending, more) in files.export_filters().items() if not more}
        self.addCleanup(setattr, QtGui.QMessageBox, "question", QtGui.QMessageBox.question)
        self.addCleanup(setattr, QtGui.QFileDialog, "getSaveFileName", QtGui.QFileDialog.getSaveFileName)
        QtGui.QMessageBox.question = lambda *_: asked.append(1) or QtGui.QMessageBox.No
        with tempfile.TemporaryDirectory() as folder:
            for name, chosen, made in (("a", "msh", "a.msh"), ("a.x", "unv", "a.x.unv"), ("b.msh", "vtu", "b.vtu"),
                                       ("c.inp", "msh", "c.inp"), ("a", "msh", "")):
                QtGui.QFileDialog.getSaveFileName = lambda _window, _title, start, _filters: (
                    proposed.append(os.path.basename(start)), (os.path.join(folder, name), filters[chosen]))[1]
                before = set(os.listdir(folder))
                FreeCADGui.runCommand("Paver_Export")
                self.wait_for_tasks()
                self.assertEqual(set(os.listdir(folder)) - before, {made} - {""}, name)
        self.assertEqual((len(asked), set(proposed)), (1, {"Mesh 8 - λ.msh"}))

    def test_the_dialogs_of_export_and_import_open(self):
        self.mesh()
        seen = []

        def close():
            dialogs = window.all_widgets(QtGui.QFileDialog)
            seen.extend(d.windowTitle() for d in dialogs)
            for dialog in dialogs:
                dialog.reject()
        for name in ("Paver_Export", "Paver_Import"):
            QtCore.QTimer.singleShot(700, close)
            FreeCADGui.runCommand(name)
        self.assertEqual(seen, ["Export mesh", "Import mesh"])


class Preferences(WithCommands):
    def setUp(self):
        super().setUp()
        self.parameters = FreeCAD.ParamGet(mesh_object.PREFERENCES)

    def tearDown(self):
        for remove, names in ((self.parameters.RemInt, ("NewOrder", "NewElements", "NewFacetsAlong")),
                              (self.parameters.RemFloat, ("NewFrequency", "NewDivisions", "NewGradation"))):
            for name in names:
                remove(name)
        super().tearDown()

    def test_the_page(self):
        seen = {}

        def look():
            page = window.widget("PaverPreferences")
            if page is None:  # FreeCAD is still making the dialog
                QtCore.QTimer.singleShot(200, look)
                return
            for name in ("FillLimit", "HeavyElements", "NewFrequency", "NewDivisions", "NewGradation", "NewFacetsAlong"):
                seen[name] = page.findChild(QtGui.QAbstractSpinBox, "Paver" + name).value()
            seen["NewOrder"] = page.findChild(QtGui.QComboBox, "PaverNewOrder").currentIndex()
            page.findChild(QtGui.QSpinBox, "PaverNewFacetsAlong").setValue(7)
            window.picture("commands_preferences")
            page.window().accept()
        QtCore.QTimer.singleShot(500, look)
        FreeCADGui.runCommand("Paver_Preferences")
        self.assertEqual(seen, {"FillLimit": mesh_object.FILL_LIMIT, "HeavyElements": mesh_object.HEAVY_ELEMENTS,
                                "NewFrequency": 0, "NewDivisions": 10, "NewGradation": 0.6,
                                "NewFacetsAlong": preferences.FACETS_ALONG, "NewOrder": 1})
        self.assertEqual(self.parameters.GetInt("NewFacetsAlong"), 7)

    def test_new_mesh_objects_start_with_them(self):
        self.parameters.SetFloat("NewFrequency", 2.5)
        self.parameters.SetFloat("NewDivisions", 12)
        self.parameters.SetInt("NewOrder", 0)
        self.parameters.SetInt("NewElements", 2)
        self.parameters.SetFloat("NewGradation", 0.3)
        select(self.box)
        FreeCADGui.runCommand("Paver_CreateMesh")
        window.wait(FreeCADGui.Control.activeDialog, "for the panel")
        mesh, = mesh_object.meshes_of(self.document)
        self.assertEqual((mesh.Frequency.Value, mesh.Divisions, mesh.Order, mesh.Elements, mesh.Gradation),
                         (2.5e9, 12, 1, "all-triangle", 0.3))
        self.assertIn("frequency='2.5 GHz'", self.console())
