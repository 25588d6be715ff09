"""Runs and tasks in the status bar: which one, how far, and a button that stops it."""
import FreeCADGui
from PySide import QtCore, QtGui

from paver_wb import core
from paver_wb.gui.base.widgets import stack, timer, translate

BAR_WIDTH, LABEL_WIDTH = 190, 220
TICK = 1000  # ms, in which the time left goes on while nothing else is told
_box = None

DRAWING = "drawing"  # what the window does after the core's stages
SHARE_OF_DRAWING = 2


def share(stage, fraction):
    """Part of a whole run that is done, 0 to 1."""
    done = 0
    for name, _, percents in [*core.stages(), (DRAWING, "", SHARE_OF_DRAWING)]:
        if name == stage:
            return (done + percents * fraction) / 100
        done += percents
    return 0.0


def percent(stage, fraction):
    return int(100 * share(stage, fraction) + 1e-9)


def stage_text(stage):
    """A stage, as users read it."""
    if stage in ("", DRAWING):
        return translate("Paver", "Drawing") if stage else translate("Paver", "Starting")
    text = next((text for name, text, _ in core.stages() if name == stage), stage)
    return translate("Paver", text)


def bar_text(run, stage=""):
    """Format of a progress bar: the stage, the share, how long it will still take."""
    return "  ".join(filter(None, [stage, "%p %", run.left_text()]))


class Box(QtGui.QWidget):
    """The permanent widget of the status bar; hidden when nothing runs."""

    def __init__(self):
        super().__init__()
        self.runs = []
        layout = QtGui.QHBoxLayout(self)
        layout.setContentsMargins(0, 0, 0, 0)
        self.label, self.bar = QtGui.QLabel(alignment=QtCore.Qt.AlignRight | QtCore.Qt.AlignVCenter), QtGui.QProgressBar()
        self.button = QtGui.QToolButton(text=translate("Paver", "Stop"), objectName="PaverStatusStop", toolTip=translate(
            "Paver", "Stops it; the document stays as it was"))
        self.bar.setFixedWidth(BAR_WIDTH)
        self.label.setFixedWidth(LABEL_WIDTH)  # another one at each stage would lay out the whole status bar again
        self.button.clicked.connect(self.stop)
        self.ticking = timer(self, self.refresh, TICK, is_single=False)
        stack(layout, self.label, self.bar, self.button)

    def watch(self, run):
        self.runs.append(run)
        run.progressed.connect(self.refresh)
        run.ended.connect(self.drop)
        self.refresh()

    @QtCore.Slot()
    def stop(self):
        for run in list(self.runs):
            run.stop()

    def drop(self, _outcome):
        self.runs = [run for run in self.runs if run.outcome is None]
        self.refresh()

    def refresh(self, *_):
        self.setVisible(bool(self.runs))
        if not self.runs:
            self.ticking.stop()
            return
        if not self.ticking.isActive():
            self.ticking.start()
        run = self.runs[0]
        text = run.line() + (f" (+{len(self.runs) - 1})" if len(self.runs) > 1 else "")
        if text != self.label.toolTip():
            self.label.setToolTip(text)
            self.label.setText(self.label.fontMetrics().elidedText(text, QtCore.Qt.ElideMiddle, LABEL_WIDTH))
        done = run.percent()
        self.bar.setRange(0, 0 if done is None else 100)  # without a share it only shows that something goes on
        if done is not None:
            self.bar.setFormat(bar_text(run))
            self.bar.setValue(done)


def watch(run):
    """Shows a run in the status bar until it ends."""
    global _box
    if _box is None:
        _box = Box()
        FreeCADGui.getMainWindow().statusBar().addPermanentWidget(_box)
    _box.watch(run)
