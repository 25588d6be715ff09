"""Dialogs that show what is worked out on a thread: large meshes take a second to read and to measure."""
import FreeCAD
from PySide import QtCore, QtGui

from paver_wb.gui import run_thread

translate = FreeCAD.Qt.translate
BAR_HEIGHT = 14


class MeasuringDialog(QtGui.QDialog):
    """Subclasses put the bar `busy` somewhere, call measure() and have show_measured(result), show_fault(sentence)."""

    def __init__(self, parent):
        super().__init__(parent)
        self.thread = None
        self.busy = QtGui.QProgressBar()
        self.busy.setObjectName("Paver_Measuring")
        self.busy.setRange(0, 0)
        self.busy.setTextVisible(False)
        self.busy.setFixedHeight(BAR_HEIGHT)
        self.busy.setToolTip(translate("Paver", "The mesh is being measured; the window can be used meanwhile"))
        self.busy.hide()

    def measure(self, work):
        """Calls work() on a thread; what was being worked out before is dropped."""
        self.drop()
        self.thread = run_thread.Background(work)
        self.thread.done.connect(self.take)
        self.busy.show()
        self.thread.begin()

    def drop(self):
        """Forgets what is being worked out."""
        if self.thread is not None:
            self.thread.done.disconnect(self.take)
            self.thread = None
        self.busy.hide()

    def closeEvent(self, event):
        self.drop()
        super().closeEvent(event)

    @QtCore.Slot()
    def take(self):
        if self.thread is None:
            return
        thread, self.thread = self.thread, None
        self.busy.hide()
        if thread.error is None:
            self.show_measured(thread.result)
        else:
            self.show_fault(str(thread.error) or type(thread.error).__name__)
