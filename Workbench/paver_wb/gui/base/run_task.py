"""Work beside the window: on a thread, shown in the status bar, where it can be stopped; what it gives is taken in the main
thread."""
import os
import tempfile

import FreeCAD
from PySide import QtCore

from paver_wb.gui.base import background, run_status
from paver_wb.gui.base.widgets import complain, translate

PATIENCE = 700  # ms until work that was asked to stop is left to itself
BUSY = 100  # ms between looks at a document that something else is changing
WAITING, RUNNING, TAKING, ENDED = "waiting", "running", "taking", "ended"
DONE, STOPPED, FAILED = "done", "stopped", "failed"
_tasks = []  # those that have begun and not ended


def is_busy(name):
    """Whether something else is changing a document, so that a step of undo of ours would become a part of it."""
    document = FreeCAD.listDocuments().get(name)
    return document is not None and (document.HasPendingTransaction or document.Recomputing or document.Transacting
                                     or document.Restoring)


class Task(QtCore.QObject):
    """One piece of work. `ended` tells the `outcome`: DONE, STOPPED or FAILED; `error`: the exception or None. Everything of
    it but its thread is in the main thread."""

    progressed = QtCore.Signal(str, float)
    ended = QtCore.Signal(object)

    def __init__(self, text, document=None, work=None, take=None):
        """text: what is done, for users. document: the one it is for, if there is one. work(task): done on the thread, may
        use `folder`, `cancel` and `tell`; what it gives goes to take(result), in the main thread. Subclasses without them
        call follow() and have a method `take`."""
        super().__init__()
        self.text, self.document, self.folder = text, None, None
        if document is not None:
            self.document = document.Name
            self.folder = tempfile.mkdtemp(prefix="paver", dir=os.path.dirname(document.TransientDir))
        self.state, self.outcome, self.error, self.stage, self.fraction = WAITING, None, None, "", None
        if work is not None:
            self.take = take
            self.follow(background.Background(lambda: work(self)))

    def follow(self, thread):
        self.thread, self.cancel, self.tell = thread, thread.stop, thread.tell
        thread.progressed.connect(self.show, QtCore.Qt.QueuedConnection)
        thread.done.connect(self.take_back)

    def begin(self):
        self.state = RUNNING
        _tasks.append(self)
        self.thread.begin()

    def line(self):
        return self.text

    def percent(self):
        return None if self.fraction is None else int(100 * self.fraction)

    def left_text(self):
        """How long it will still take; empty where that cannot be told."""
        return ""

    @QtCore.Slot(str, float)
    def show(self, stage, fraction):
        if self.state == RUNNING and stage != "done":
            self.stage, self.fraction = stage, fraction
            self.progressed.emit(stage, fraction)

    def stop(self):
        """Stops it; `ended` comes within a second."""
        self.cancel.set()
        if self.state in (WAITING, TAKING):
            self.end(STOPPED)
        elif self.state == RUNNING:
            QtCore.QTimer.singleShot(PATIENCE, self.leave)

    @QtCore.Slot()
    def leave(self):
        """After a stop that has not been answered: inside a long call of the CAD kernel the core cannot."""
        if self.state == RUNNING:
            self.end(STOPPED)

    @QtCore.Slot()
    def take_back(self):
        """Takes the result, as soon as nothing else is changing the document."""
        if self.state == ENDED:
            return
        if self.cancel.is_set():
            self.end(STOPPED)
        elif self.thread.error is not None:
            self.end(FAILED, self.thread.error)
        elif is_busy(self.document):
            self.state = TAKING
            QtCore.QTimer.singleShot(BUSY, self.take_back)
        else:
            self.hand_over()

    def hand_over(self):
        try:
            self.take(self.thread.result)
        except Exception as error:
            return self.end(FAILED, error)
        return self.end(DONE)

    def end(self, how, error=None):
        self.state, self.error = ENDED, error
        if self in _tasks:
            _tasks.remove(self)
        if self.folder:
            self.thread.drop_folder(self.folder)
        if getattr(error, "log", ""):
            FreeCAD.Console.PrintLog(error.log + "\n")
        self.outcome = self.told(how)
        self.thread.result = None  # Qt may keep the thread for a while
        self.ended.emit(self.outcome)

    def told(self, how):
        """The outcome; tells the user."""
        if how == STOPPED:
            FreeCAD.Console.PrintMessage(translate("Paver", "Stopped: {}").format(self.text) + "\n")
        elif self.error is not None:
            complain(str(self.error) or type(self.error).__name__)
        return how


def begin(text, document, work, take):
    """Starts a Task, shown in the status bar, and gives it."""
    task = Task(text, document, work, take)
    run_status.watch(task)
    task.begin()
    return task
