"""Runs and tasks in the status bar: which one, how far, and a button that stops it."""
import FreeCAD
import FreeCADGui
from PySide import QtCore, QtGui

translate = FreeCAD.Qt.translate
BAR_WIDTH, LABEL_WIDTH = 160, 220
_box = None

# Share of each stage in the time of a common run, in percent: a bar that never goes back needs some.
SHARES = (("read", 8), ("topology", 2), ("sizing", 2), ("boundary", 12), ("regions", 4), ("paving", 48), ("repair", 4),
          ("join", 3), ("curving", 9), ("quality", 4), ("write", 2), ("drawing", 2))


def percent(stage, fraction):
    """Part of a whole run that is done."""
    done = 0
    for name, share in SHARES:
        if name == stage:
            return int(done + share * fraction)
        done += share
    return 100 if stage == "done" else 0


def stage_text(stage):
    """A stage of the core, as users read it."""
    return {"": translate("Paver", "Starting"), "read": translate("Paver", "Reading the shape"),
            "topology": translate("Paver", "Joining faces"), "sizing": translate("Paver", "Sizes"),
            "boundary": translate("Paver", "Dividing edges"), "regions": translate("Paver", "Regions"),
            "paving": translate("Paver", "Paving"), "repair": translate("Paver", "Repairing elements"),
            "join": translate("Paver", "Joining meshes"), "curving": translate("Paver", "Curving"),
            "quality": translate("Paver", "Measuring quality"), "write": translate("Paver", "Storing"),
            "drawing": translate("Paver", "Drawing")}.get(stage, stage)


class Box(QtGui.QWidget):
    """The permanent widget of the status bar; hidden when nothing runs."""

    def __init__(self):
        super().__init__()
        self.runs = []
        layout = QtGui.QHBoxLayout(self)
        layout.setContentsMargins(0, 0, 0, 0)
        self.label, self.bar, self.button = QtGui.QLabel(), QtGui.QProgressBar(), QtGui.QToolButton()
        self.bar.setFixedWidth(BAR_WIDTH)
        self.label.setFixedWidth(LABEL_WIDTH)  # another one at each stage would lay out the whole status bar again
        self.label.setAlignment(QtCore.Qt.AlignRight | QtCore.Qt.AlignVCenter)
        self.button.setText(translate("Paver", "Stop"))
        self.button.setObjectName("PaverStatusStop")
        self.button.setToolTip(translate("Paver", "Stops it; the document stays as it was"))
        self.button.clicked.connect(self.stop)
        for widget in (self.label, self.bar, self.button):
            layout.addWidget(widget)

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
            return
        run = self.runs[0]
        text = run.line() + (f" (+{len(self.runs) - 1})" if len(self.runs) > 1 else "")
        if text != self.label.toolTip():
            self.label.setToolTip(text)
            self.label.setText(self.label.fontMetrics().elidedText(text, QtCore.Qt.ElideMiddle, LABEL_WIDTH))
        share = run.percent()
        self.bar.setRange(0, 0 if share is None else 100)  # without a share it only shows that something goes on
        if share is not None:
            self.bar.setValue(share)


def watch(run):
    """Shows a run in the status bar until it ends."""
    global _box
    if _box is None:
        _box = Box()
        FreeCADGui.getMainWindow().statusBar().addPermanentWidget(_box)
    _box.watch(run)
