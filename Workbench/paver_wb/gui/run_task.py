"""Work beside the window that is no meshing, such as reading and writing files: on a thread, shown in the status bar, where
it can be stopped; what it gives is taken in the main thread."""
import os
import tempfile

import FreeCAD
from PySide import QtCore

from paver_wb import core
from paver_wb.gui import run_status, run_thread
from paver_wb.gui.complaint import complain

PATIENCE = 700  # ms until work that was asked to stop is left to itself
BUSY = 100  # ms between looks at a document that something else is changing
DONE, STOPPED, FAILED = "done", "stopped", "failed"
translate = FreeCAD.Qt.translate
_tasks = []  # those that have not ended


def is_busy(document):
    """Whether something else is changing the document, so that a step of undo of ours would become a part of it."""
    return document.HasPendingTransaction or document.Recomputing or document.Transacting or document.Restoring


class Task(QtCore.QObject):
    """One piece of work. `ended` tells how: `outcome` is DONE, STOPPED or FAILED, `error` the exception or None."""

    progressed = QtCore.Signal(str, float)
    ended = QtCore.Signal(object)

    def __init__(self, text, document, work, take):
        """text: what is done, for users. document: the one it is for. work(task): done on the thread, may use `folder`,
        `stop` and `tell`; what it gives goes to take(result), in the main thread."""
        super().__init__()
        self.text, self.document, self.take, self.outcome, self.error = text, document.Name, take, None, None
        self.fraction = None
        self.folder = tempfile.mkdtemp(prefix="paver", dir=os.path.dirname(document.TransientDir))
        self.thread = run_thread.Background(lambda: work(self))
        self.cancel = self.thread.stop  # the token for the core
        self.thread.done.connect(self.take_back)
        self.progressed.connect(self.show, QtCore.Qt.QueuedConnection)

    def begin(self):
        _tasks.append(self)
        run_status.watch(self)
        self.thread.begin()

    def line(self):
        return self.text

    def percent(self):
        return None if self.fraction is None else int(100 * self.fraction)

    def tell(self, stage, fraction):
        """For the thread: how far it is."""
        self.progressed.emit(stage, fraction)

    @QtCore.Slot(str, float)
    def show(self, _stage, fraction):
        self.fraction = fraction

    def stop(self):
        self.cancel.set()
        QtCore.QTimer.singleShot(PATIENCE, self.leave)

    @QtCore.Slot()
    def leave(self):
        if self.outcome is None:
            self.end(STOPPED)

    @QtCore.Slot()
    def take_back(self):
        if self.outcome is not None:
            return
        if self.cancel.is_set() or isinstance(self.thread.error, core.load().Cancelled):
            self.end(STOPPED)
        elif self.thread.error is not None:
            self.end(FAILED, self.thread.error)
        else:
            self.hand_over()

    def hand_over(self):
        document = FreeCAD.listDocuments().get(self.document)
        if document is not None and is_busy(document):
            QtCore.QTimer.singleShot(BUSY, self.take_back)
            return
        try:
            self.take(self.thread.result)
        except Exception as error:
            return self.end(FAILED, error)
        return self.end(DONE)

    def end(self, outcome, error=None):
        self.outcome, self.error = outcome, error
        if self in _tasks:
            _tasks.remove(self)
        self.thread.drop_folder(self.folder)
        self.thread.result = None
        if outcome == STOPPED:
            FreeCAD.Console.PrintMessage(translate("Paver", "Stopped: {}").format(self.text) + "\n")
        elif error is not None:
            log = getattr(error, "log", "")
            if log:
                FreeCAD.Console.PrintLog(log + "\n")
            complain(str(error) or type(error).__name__)
        self.ended.emit(self)


def begin(text, document, work, take):
    """Starts a Task and gives it."""
    task = Task(text, document, work, take)
    task.begin()
    return task
