"""The preview of contacts and small features in the panel. Runs in FreeCAD's window: panel_test.py."""
import FreeCAD
import FreeCADGui
from PySide import QtGui

import window
from child_cases import children
from panel_cases import PanelCase
from panel_run_cases import folders
from paver_wb import preferences
from paver_wb.gui.preview import box, drawing


class Previews(PanelCase):
    def setUp(self):
        super().setUp()
        self.addCleanup(preferences.parameters().RemBool, "ShowPreview")
        self.other = self.document.addObject("Part::Box", "Other")
        self.other.Placement.Base = FreeCAD.Vector(3, 3, 10)
        self.other.Length = self.other.Width = self.other.Height = 4
        self.document.recompute()
        self.scene = FreeCADGui.ActiveDocument.ActiveView.getSceneGraph()

    def drawn(self):
        names = [str(self.scene.getChild(i).getName()) for i in range(self.scene.getNumChildren())]
        return names.count(drawing.NAME)

    def open_with_preview(self, *parts):
        mesh = self.add_mesh(*(parts or (self.box, self.other)))
        self.open(mesh)
        self.assertEqual(self.drawn(), 0)
        window.click(window.widget("Paver_Preview"))
        self.wait_for("touch")
        return mesh

    def wait_for(self, words):
        window.wait(lambda: window.widget("Paver_PreviewText") and words in self.text("PreviewText"), f"for '{words}'")

    def test_it_is_drawn_and_goes_with_its_check_box_and_the_panel(self):
        mesh = self.open_with_preview()
        self.assertIn("1 pair of parts touches", self.text("PreviewText"))
        self.assertEqual(self.drawn(), 1)
        window.picture("panel_preview")
        self.assertEqual(self.document.UndoNames, [])
        window.click(window.widget("Paver_Preview"))
        self.assertEqual((self.drawn(), window.widget("Paver_PreviewText")), (0, None))
        window.click(window.widget("Paver_Preview"))
        window.wait(self.drawn, "for the drawing")
        window.click(self.button(QtGui.QDialogButtonBox.Cancel))
        window.wait(lambda: window.widget("Paver_MeshButton") is None, "for the panel to go")
        self.assertEqual((self.drawn(), children(), folders(self.document)), (0, [], []))
        self.open(mesh)  # the check box stays as it was
        window.wait(self.drawn, "for the drawing")

    def test_it_follows_the_options_and_the_shapes(self):
        self.open_with_preview()
        window.type_into(window.widget("Paver_size"), "90 mm")
        self.wait_for("90 mm")
        window.type_into(window.widget("Paver_size"), "fast")
        self.assertEqual(self.drawn(), 0)
        window.type_into(window.widget("Paver_size"), "2 mm")
        window.wait(self.drawn, "for the drawing")
        self.other.Placement.Base.x = 50
        self.document.recompute()
        self.wait_for("No parts touch")

    def test_it_stays_over_a_mesh_and_goes_with_the_document(self):
        self.open_with_preview()
        self.mesh_and_wait()
        window.wait(self.drawn, "for the drawing")
        name, self.document = self.document.Name, None
        FreeCAD.closeDocument(name)
        window.pause(300)
        self.assertEqual(children(), [])

    def test_scripts_draw_it_too(self):
        shown = box.show(self.add_mesh(self.box, self.other), size=3)
        self.assertEqual(self.drawn(), 1)
        shown.clear()
        self.assertEqual(self.drawn(), 0)

    def test_what_cannot_be_looked_at_is_told(self):
        mesh = self.add_mesh(self.box)
        mesh.Part = self.document.addObject("Part::Feature", "Empty")
        self.open(mesh)
        window.click(window.widget("Paver_Preview"))
        self.wait_for("has no shape")
        self.assertEqual(self.drawn(), 0)
