"""What a check of a mesh finds, as a list; a click shows the elements."""
import FreeCAD
import FreeCADGui
from PySide import QtGui

from paver_wb import mesh_check, mesh_object
from paver_wb.formats import mesh_file
from paver_wb.gui.base import measuring
from paver_wb.gui.base.widgets import button, named, row

translate = FreeCAD.Qt.translate
MOST_SELECTED = 500  # elements that a click selects
COLOURS = {mesh_check.ERROR: "#cc0000", mesh_check.WARNING: "#c17d11", mesh_check.NOTE: "#3465a4",
           mesh_check.GOOD: "#4e9a06"}
MARKS = {mesh_check.ERROR: "\u2716", mesh_check.WARNING: "\u26a0", mesh_check.NOTE: "\u2139", mesh_check.GOOD: "\u2714"}


def verdict_text(level):
    return {mesh_check.ERROR: translate("Paver", "The mesh has errors."),
            mesh_check.WARNING: translate("Paver", "The mesh can be used; look at the warnings."),
            mesh_check.NOTE: translate("Paver", "The mesh is sound."),
            mesh_check.GOOD: translate("Paver", "The mesh is sound.")}[level]


class CheckPanel(measuring.MeasuringDialog):
    """Stays open beside the window. `findings`: those that are shown."""

    findings = ()

    def __init__(self, obj):
        super().__init__(obj, "Paver_CheckPanel", translate("Paver", "Check of {}").format(obj.Label))
        self.resize(560, 320)

    def build(self):
        self.verdict = named(QtGui.QLabel(), "CheckVerdict")
        self.list = named(QtGui.QListWidget(), "CheckList", translate(
            "Paver", "Click on a line to select its elements in the 3D view"))
        font = self.verdict.font()
        font.setBold(True)
        self.verdict.setFont(font)
        self.list.setWordWrap(True)
        self.list.setAlternatingRowColors(True)
        self.list.itemClicked.connect(self.select)
        layout = QtGui.QVBoxLayout(self)
        layout.addWidget(self.verdict)
        layout.addWidget(self.list)
        layout.addWidget(self.busy)
        layout.addLayout(self.bottom())

    def bottom(self):
        return row(None, button("CheckAgain", translate("Paver", "Check again"), "", self.refresh), self.close_button())

    def refresh(self):
        """Checks the mesh again, on a thread."""
        try:
            found, path = mesh_check.of_document(self.obj), mesh_object.path_of(self.obj)
        except (ReferenceError, RuntimeError):  # the object is gone
            self.close()
            return
        except ValueError as error:
            self.show_fault(str(error))
            return
        self.measure(lambda: mesh_check.in_order(found + mesh_check.of_mesh(mesh_file.read(path))))

    def show_fault(self, text):
        self.show_measured([mesh_check.Finding(mesh_check.ERROR, text)])

    def show_measured(self, findings):
        self.findings = findings
        level = mesh_check.verdict(self.findings)
        self.verdict.setText(verdict_text(level))
        self.verdict.setStyleSheet(f"color: {COLOURS[level]}")
        self.list.clear()
        for finding in self.findings:
            item = QtGui.QListWidgetItem(f"{MARKS[finding.level]}  {finding.text}")
            item.setForeground(QtGui.QColor(COLOURS[finding.level]))
            self.list.addItem(item)

    def select(self, item):
        """Selects the elements of a finding."""
        finding = self.findings[self.list.row(item)]
        FreeCADGui.Selection.clearSelection()
        for number in finding.elements[:MOST_SELECTED]:
            FreeCADGui.Selection.addSelection(self.obj.Document.Name, self.obj.Name, f"Elem{number}")


def show(obj):
    """Checks a mesh object and shows what was found. ValueError when it is not meshed."""
    return measuring.show(CheckPanel, obj)
