"""What a check of a mesh finds, as a list: a click goes to the place, Next through all elements of a finding."""
import FreeCADGui
from PySide import QtCore, QtGui

from paver_wb import mesh_check, mesh_object, meshing
from paver_wb.formats import mesh_file
from paver_wb.gui.base import measuring, verdict
from paver_wb.gui.base.steps import do, in_step, python_name
from paver_wb.gui.base.widgets import button, complain, named, row, stack, text_label, translate
from paver_wb.gui.display import actions, report
from paver_wb.gui.display.emphasis import isolation

MOST_SELECTED = 500  # elements that a click selects, and that a line in the console names
WIDTH, HEIGHT, COUNT_WIDTH = 540, 380, 120
ABOVE = 40  # pixels between the dialog and the window's lower rim: its title bar and the status bar
ACTIONS = "paver_wb.gui.display.actions"


def verdict_text(level):
    return {mesh_check.ERROR: translate("Paver", "The mesh has errors."),
            mesh_check.WARNING: translate("Paver", "The mesh can be used; look at the warnings."),
            mesh_check.NOTE: translate("Paver", "The mesh is sound."),
            mesh_check.GOOD: translate("Paver", "The mesh is sound.")}[level]


class CheckPanel(measuring.MeasuringDialog):
    """Stays open beside the window, and follows the mesh. `findings`: those that are shown; `finding`: the one that was
    clicked, or None; `at`: which of its elements was gone to, -1 for none."""

    findings, finding, at = (), None, -1
    followed = ("MeshFile", "Status")

    def __init__(self, obj):
        super().__init__(obj, "CheckPanel", translate("Paver", "Check of {}").format(obj.Label))
        self.resize(WIDTH, HEIGHT)

    def stand_aside(self):
        """Leaves the middle of the 3D view free, where places are shown: in its lower right corner, else in the window's lower
        left one."""
        window = FreeCADGui.getMainWindow()
        area = window.centralWidget()
        frame = window.frameGeometry().intersected(QtGui.QApplication.primaryScreen().availableVirtualGeometry())
        middle = area.mapToGlobal(area.rect().center()).x()
        self.resize(self.size().expandedTo(self.minimumSizeHint()))
        right = frame.right() - self.width()
        self.move(right if right > middle else frame.left(), frame.bottom() - self.height() - ABOVE)

    def build(self):
        self.verdict, self.sign = named(QtGui.QLabel(), "CheckVerdict"), QtGui.QLabel()
        self.list = named(QtGui.QListWidget(
            wordWrap=True, iconSize=QtCore.QSize(verdict.SIZE, verdict.SIZE),
            horizontalScrollBarPolicy=QtCore.Qt.ScrollBarAlwaysOff), "CheckList", translate(
            "Paver", "Click on a line to go to its elements in the 3D view, which get rings"))
        font = self.verdict.font()
        font.setBold(True)
        self.verdict.setFont(font)
        self.list.itemClicked.connect(self.select)
        self.figures = text_label("CheckFigures", translate("Paver", "Figures of the element in the middle of the view"))
        stack(QtGui.QVBoxLayout(self), row(self.sign, self.verdict, shares=(0, 1)), self.list, self.busy, self.walk(),
              self.figures, self.bottom())
        self.show_walk()

    def walk(self):
        self.back = button("CheckPrevious", translate("Paver", "Previous"), translate(
            "Paver", "Goes to the previous element of the finding"), lambda: self.step(-1))
        self.forward = button("CheckNext", translate("Paver", "Next"), translate(
            "Paver", "Goes to the next element of the finding"), lambda: self.step(1))
        self.count = named(QtGui.QLabel(), "CheckCount")
        self.count.setMinimumWidth(COUNT_WIDTH)  # else the dialog grows at a click
        self.isolate = named(QtGui.QCheckBox(translate("Paver", "Only these")), "CheckIsolate", translate(
            "Paver", "Shows the elements of the finding alone"))
        self.isolate.toggled.connect(self.isolate_finding)
        self.element = named(QtGui.QLineEdit(), "CheckElement", translate(
            "Paver", "Number of an element; Return goes to it"))
        self.element.setFixedWidth(90)
        self.element.setValidator(QtGui.QIntValidator(1, 2 ** 31 - 1, self.element))
        self.element.returnPressed.connect(self.go_to_number)
        return row(self.back, self.forward, self.count, self.isolate, None, QtGui.QLabel(translate("Paver", "Element")),
                   self.element)

    def bottom(self):
        again, close = button("CheckAgain", translate("Paver", "Check again"), "", self.refresh), self.close_button()
        for one in (self.back, self.forward, again, close):  # else Return in the field of an element clicks one
            one.setAutoDefault(False)
            one.setDefault(False)
        return row(None, again, close)

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
        self.findings, self.finding, self.at = findings, None, -1
        level = mesh_check.verdict(self.findings)
        self.verdict.setText(verdict_text(level))
        self.sign.setPixmap(verdict.sign(level).pixmap(verdict.SIZE, verdict.SIZE))
        self.list.clear()
        for finding in self.findings:
            self.list.addItem(QtGui.QListWidgetItem(verdict.sign(finding.level), finding.text))
        self.show_walk()

    # ---- going to places

    def select(self, item):
        """Goes to the elements of a finding: selects them, with rings."""
        self.finding, self.at = self.findings[self.list.row(item)], -1
        self.isolate.setChecked(False)
        FreeCADGui.Selection.clearSelection()
        names = self.names()
        try:
            if names:
                actions.look_at(self.obj, names)
                actions.ring(self.obj, names)
                actions.select(self.obj, names[:MOST_SELECTED])
            elif self.finding.places:
                actions.look_at_place(self.obj, self.finding.places[0])
        except ValueError as error:
            complain(str(error))
        self.show_walk()

    def names(self):
        return [f"Elem{number}" for number in self.finding.elements] if self.finding else []

    def step(self, by):
        """Goes to the next element of the finding, or the one before; from the last to the first."""
        count = len(self.finding.elements)
        self.at = (self.at + by) % count if self.at >= 0 or by > 0 else count - 1
        self.show_walk()
        self.go_to(self.finding.elements[self.at])

    def go_to_number(self):
        if self.element.text():
            self.at = -1
            self.show_walk()
            self.go_to(int(self.element.text()))

    def go_to(self, number):
        try:
            do(f"go_to({python_name(self.obj)}, 'Elem{number}')", ACTIONS)
            self.figures.setText(report.line(actions.element(self.obj, f"Elem{number}")))
        except ValueError as error:
            self.figures.setText(str(error))
        if self.obj.ViewObject.Isolate != isolation.LISTED:  # it was hidden
            self.isolate.setChecked(False)

    def isolate_finding(self, is_wanted):
        names = self.names()
        if is_wanted and len(names) > MOST_SELECTED:
            with meshing.transaction(self.obj.Document, translate("Paver", "Isolate")):
                actions.isolate(self.obj, names)
            return
        if is_wanted:
            line = f"{ACTIONS}.isolate({python_name(self.obj)}, {names})"
        elif self.obj.ViewObject.Isolate == isolation.LISTED:
            line = f"{python_name(self.obj)}.ViewObject.Isolate = {isolation.EVERYTHING!r}"
        else:
            return
        in_step(self.obj.Document, translate("Paver", "Isolate"), [ACTIONS], [line])

    def show_walk(self):
        count = len(self.finding.elements) if self.finding else 0
        for part in (self.back, self.forward, self.isolate):
            part.setEnabled(bool(count))
        text = report.elements_text(count) if count else ""
        self.count.setText(translate("Paver", "{} of {}").format(self.at + 1, count) if self.at >= 0 else text)
        self.figures.setText("")

    def leave(self, result):
        try:
            self.isolate.setChecked(False)
            actions.display_of(self.obj).ring(())
        except (ReferenceError, RuntimeError, AttributeError, NameError):  # the mesh object, or its document, has gone before
            pass
        super().leave(result)


def show(obj):
    """Checks a mesh object and shows what was found. ValueError when it is not meshed."""
    is_new = measuring.opened(CheckPanel, obj) is None
    panel = measuring.show(CheckPanel, obj)
    if is_new:
        panel.stand_aside()
    return panel
