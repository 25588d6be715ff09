"""What a check of a mesh finds, as a list; a click shows the elements."""
import FreeCAD
import FreeCADGui
from PySide import QtCore, QtGui

from paver_wb import mesh_check, mesh_file
from paver_wb.gui.measuring import MeasuringDialog

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


class CheckPanel(MeasuringDialog):
    """Stays open beside the window. `findings`: those that are shown."""

    def __init__(self, obj):
        super().__init__(FreeCADGui.getMainWindow())
        self.obj, self.findings = obj, []
        self.setObjectName("Paver_CheckPanel")
        self.setAttribute(QtCore.Qt.WA_DeleteOnClose)
        self.setWindowTitle(translate("Paver", "Check of {}").format(obj.Label))
        self.verdict, self.list = QtGui.QLabel(), QtGui.QListWidget()
        font = self.verdict.font()
        font.setBold(True)
        self.verdict.setFont(font)
        self.verdict.setObjectName("Paver_CheckVerdict")
        self.list.setObjectName("Paver_CheckList")
        self.list.setWordWrap(True)
        self.list.setAlternatingRowColors(True)
        self.list.setToolTip(translate("Paver", "Click on a line to select its elements in the 3D view"))
        self.list.itemClicked.connect(self.select)
        layout = QtGui.QVBoxLayout(self)
        layout.addWidget(self.verdict)
        layout.addWidget(self.list)
        layout.addWidget(self.busy)
        layout.addLayout(self.bottom())
        self.resize(560, 320)
        self.refresh()

    def bottom(self):
        again, close = QtGui.QPushButton(translate("Paver", "Check again")), QtGui.QPushButton(translate("Paver", "Close"))
        again.setObjectName("Paver_CheckAgain")
        again.clicked.connect(self.refresh)
        close.setDefault(True)
        close.clicked.connect(self.close)
        row = QtGui.QHBoxLayout()
        row.addStretch()
        row.addWidget(again)
        row.addWidget(close)
        return row

    def refresh(self):
        """Checks the mesh again, on a thread."""
        try:
            path, found = self.obj.MeshFile, mesh_check.of_document(self.obj)
        except (ReferenceError, RuntimeError):  # the object is gone
            self.close()
            return
        if not path:
            self.show_fault(f"'{self.obj.Label}' is not meshed; mesh it first.")
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


_open = {}


def show(obj):
    """Checks a mesh object and shows what was found. ValueError when it is not meshed."""
    if not obj.MeshFile:
        raise ValueError(f"'{obj.Label}' is not meshed; mesh it first.")
    key = (obj.Document.Name, obj.Name)
    if key in _open:
        _open[key].refresh()
    else:
        _open[key] = CheckPanel(obj)
        _open[key].destroyed.connect(lambda _=None: _open.pop(key, None))
    _open[key].show()
    _open[key].raise_()
    return _open[key]
