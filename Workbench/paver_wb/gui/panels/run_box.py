"""The part of the task panel that predicts, meshes, shows the progress, stops, and tells what went wrong."""
import os

from PySide import QtCore, QtGui

from paver_wb import mesh_object, preferences
from paver_wb.base.paths import ICONS
from paver_wb.base.texts import counted
from paver_wb.gui import run_place
from paver_wb.gui.base import run_log, run_status
from paver_wb.gui.base.run_task import FAILED
from paver_wb.gui.base.widgets import FaultBox, button, fold_button, named, part_layout, row, stack, text_label, timer, translate
from paver_wb.gui.panels.options_box import with_labels
from paver_wb.gui.preview.box import PreviewBox
from paver_wb.statistics import memory, number

LOG_HEIGHT, SHOW_LOG = 110, "ShowLog"
SCROLL_DELAY = 50  # ms


def count_text(count):
    """12 345 elements are shown as exactly as a prediction deserves: three digits."""
    return number(round(float(f"{count:.3g}")))


def prediction_text(prediction, run_in, limit):
    """About how much a run will come to; limit: the most elements it may make."""
    text = counted(prediction.elements, translate("Paver", "About {} element, up to {} of memory"), translate(
        "Paver", "About {} elements, up to {} of memory")).format(count_text(prediction.elements),
                                                                           memory(prediction.memory_mib * 2 ** 20))
    if prediction.elements > limit:
        return text + translate("Paver", "; more than 'Most elements' allows, so choose longer elements or raise that")
    is_heavy = run_in == mesh_object.AUTOMATIC and prediction.elements >= mesh_object.heavy_elements()
    return text + (translate("Paver", "; in a process of its own") if is_heavy or run_in == mesh_object.IN_PROCESS
                   else "")


def count_of_mesh(obj):
    """How much the run has come to."""
    count = obj.Quads + obj.Triangles
    return counted(count, translate("Paver", "The mesh has {} element"), translate("Paver", "The mesh has {} elements")).format(
        number(count))


class RunBox(QtGui.QWidget):
    """`mesh_asked`, `stop_asked`: the buttons. watch(run) follows a run until it ends."""

    mesh_asked = QtCore.Signal()
    stop_asked = QtCore.Signal()

    def __init__(self, obj):
        super().__init__()
        self.obj, self.run, self.lines, self.place, self.in_sight = obj, None, None, None, self
        self.scrolling = timer(self, self.scroll, SCROLL_DELAY)
        self.ticking = timer(self, self.tell, run_status.TICK, is_single=False)
        self.status = text_label("Status", translate("Paver", "Whether the mesh fits the options and the shapes of its objects"))
        self.prediction = text_label("Prediction", translate(
            "Paver", "What meshing with these options comes to, or has come to"))
        self.preview = PreviewBox(obj)
        self.bar = named(QtGui.QProgressBar(), "Progress", translate(
            "Paver", "Stage of the work, and how much of all work is done"))
        stack(part_layout(self, translate("Paver", "Mesh")), self.buttons(), self.status, self.prediction, self.preview, self.bar,
              self.fault_box(), self.log_box())
        self.follow_log(run_log.of(obj))
        self.idle()

    def buttons(self):
        self.mesh = button("MeshButton", translate("Paver", "Mesh"), translate(
            "Paver", "Meshes with these options, as Apply does; FreeCAD can be used meanwhile"), self.mesh_asked.emit)
        self.mesh.setIcon(QtGui.QIcon(os.path.join(ICONS, "Paver_Mesh.svg")))
        self.stop = button("StopButton", translate("Paver", "Stop"), translate(
            "Paver", "Stops meshing within a second; the mesh stays as it was"), self.stop_asked.emit)
        return row(self.mesh, self.stop, shares=(2, 1))

    def fault_box(self):
        self.fault = FaultBox()
        self.show_place = button("ShowPlace", "", translate("Paver", "Selects it in the 3D view and brings it into sight"),
                                 self.go_to_place)
        self.fault.layout().addWidget(self.show_place)
        return self.fault

    def log_box(self):
        self.fold = fold_button("LogFold", translate("Paver", "Log"), translate(
            "Paver", "What the last run has done and is doing"), self.show_log)
        self.log = named(QtGui.QPlainTextEdit(readOnly=True), "Log", translate(
            "Paver", "Stages of the last run and their seconds, and what came of it"))
        self.log.setFixedHeight(LOG_HEIGHT)
        self.fold.setChecked(preferences.parameters().GetBool(SHOW_LOG, True))
        return stack(QtGui.QVBoxLayout(), self.fold, self.log)

    @QtCore.Slot(bool)
    def show_log(self, is_open):
        self.log.setVisible(is_open and self.lines is not None)  # the options stand below it
        preferences.parameters().SetBool(SHOW_LOG, is_open)

    def follow_log(self, lines):
        """Shows a RunLog, or None, in place of the one before."""
        if self.lines is not None:
            self.lines.changed = lambda: None
        self.lines = lines
        if lines is not None:
            lines.changed = self.refresh_log
        self.refresh_log()

    def refresh_log(self):
        self.log.setPlainText(self.lines.text() if self.lines else "")
        self.log.setVisible(self.fold.isChecked() and self.lines is not None)
        self.log.moveCursor(QtGui.QTextCursor.End)

    def bring_into_sight(self, part):
        """Scrolls the panel to a part of it, when that has got its size."""
        self.in_sight = part
        self.scrolling.start()

    @QtCore.Slot()
    def scroll(self):
        area = self.parent()
        while area is not None and not isinstance(area, QtGui.QScrollArea):
            area = area.parent()
        if area is not None:
            area.ensureWidgetVisible(self.in_sight)

    def go_to_place(self):
        import FreeCADGui
        if run_place.select(self.obj, self.place):
            FreeCADGui.SendMsgToActiveView("ViewSelection")

    def show_status(self, has_edits=False):
        """has_edits: fields differ from what the mesh object has."""
        if has_edits:
            self.status.setText(translate("Paver", "Options have been edited; Apply meshes with them"))
            return
        texts = {mesh_object.NOT_MESHED: translate("Paver", "Not meshed yet"),
                 mesh_object.UP_TO_DATE: translate("Paver", "The mesh is up to date"),
                 mesh_object.FACES_FAILED: translate("Paver", "The mesh has holes: faces could not be meshed"),
                 mesh_object.OUT_OF_DATE: translate("Paver", "Options or shapes have changed since meshing")}
        self.status.setText(texts[mesh_object.state_of(self.obj)])

    def show_fault(self, text, place=None):
        """A sentence, or none; with a place a button goes there."""
        self.place = place
        self.fault.tell(with_labels(text))
        if text:
            self.bring_into_sight(self.fault)
        self.show_place.setVisible(place is not None)
        if place is not None:
            self.show_place.setText(translate("Paver", "Show {}").format(place.element))

    def idle(self):
        self.mesh.setEnabled(True)
        self.stop.setEnabled(False)
        self.ticking.stop()
        self.bar.hide()
        self.show_fault("")
        self.show_status()

    def watch(self, run):
        """Follows a run; show() of its end is the panel's."""
        self.run = run
        self.show_fault("")
        self.status.setText(translate("Paver", "Meshing; FreeCAD can be used meanwhile"))
        self.mesh.setEnabled(False)
        self.stop.setEnabled(True)
        self.bar.show()
        self.bring_into_sight(self.log)
        self.follow_log(run.log)
        run.progressed.connect(self.tell)
        self.ticking.start()
        self.tell()

    def leave(self, run):
        """Follows it no longer."""
        self.ticking.stop()
        run.progressed.disconnect(self.tell)

    @QtCore.Slot()
    def tell(self, *_):
        self.bar.setFormat(run_status.bar_text(self.run, run_status.stage_text(self.run.stage)))
        self.bar.setValue(self.run.percent())

    def show_end(self, outcome):
        self.idle()
        if outcome.kind == FAILED or outcome.place:
            self.show_fault(outcome.text, outcome.place)
