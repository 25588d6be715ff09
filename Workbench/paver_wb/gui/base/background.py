"""What is done while the window lives on: by threads, none of which touches a document or the 3D view, or a little later."""
import shutil
import threading

import FreeCAD
from PySide import QtCore

STEP = 0.02  # share of a stage
_running = set()  # Qt ends the program when a thread's object goes before the thread


class Background(QtCore.QThread):
    """Calls `work()` in a thread, then emits `done`: `result` is what it gave, or `error` what it raised.

    `stop` is the cancel token for the core. A thread that is stopped and dropped ends by itself, and removes
    `left_folder` then.
    """

    progressed = QtCore.Signal(str, float)
    done = QtCore.Signal()
    patience = 2000  # ms that the end of the program waits for it

    def __init__(self, work=None, stop=None):
        super().__init__()
        if work is not None:
            self.work = work
        self.stop, self.result, self.error, self.left_folder = stop or threading.Event(), None, None, None
        self.told = ("", 0.0)
        self.finished.connect(self.leave, QtCore.Qt.QueuedConnection)

    def begin(self):
        _running.add(self)
        self.start()

    def run(self):
        try:
            self.result = self.work()
        except Exception as error:
            self.error = error

    def tell(self, stage, fraction):
        """Passes on progress worth showing: another stage, or a step of it that can be seen."""
        if stage != self.told[0] or fraction - self.told[1] >= STEP:
            self.told = (stage, fraction)
            self.progressed.emit(stage, fraction)

    @QtCore.Slot()
    def leave(self):
        _running.discard(self)
        self.done.emit()
        if self.left_folder:
            shutil.rmtree(self.left_folder, ignore_errors=True)

    def drop_folder(self, folder):
        """Removes a folder that the work may write to: now, or when the thread, left to itself, has gone."""
        if self in _running:
            self.left_folder = folder
        else:
            shutil.rmtree(folder, ignore_errors=True)


class Offer:
    """One thing that is ready, under a key, for who takes it first."""

    def __init__(self):
        self.key = self.thing = None

    def put(self, key, thing):
        self.key, self.thing = key, thing

    def has(self, key):
        return key is not None and key == self.key

    def take(self, key):
        """None where it is not there."""
        thing = self.thing if self.has(key) else None
        if thing is not None:
            self.put(None, None)
        return thing


class Latest:
    """Work of which only the last that was asked for counts: show(result) or fail(error) tells how it ended."""

    def __init__(self, show, fail):
        self.show, self.fail, self.thread = show, fail, None

    def ask(self, work):
        """work(cancel) is called on a thread; what was asked for before is dropped."""
        self.drop()
        stop = threading.Event()
        self.thread = Background(lambda: work(stop), stop)
        self.thread.done.connect(self.take)
        self.thread.begin()

    def drop(self):
        if self.thread is not None:
            self.thread.stop.set()
            self.thread.done.disconnect(self.take)
            self.thread = None

    def wait(self):
        """Until there is nothing to wait for."""
        if self.thread is not None:
            self.thread.wait()
            self.thread.done.disconnect(self.take)
            self.take()

    def take(self):
        thread, self.thread = self.thread, None
        if thread is not None:
            self.show(thread.result) if thread.error is None else self.fail(thread.error)


class Later:
    """Calls action(document), after `delay` ms and when FreeCAD is back in its event loop, once for each document that was
    asked for and is still open."""

    def __init__(self, action, delay=0):
        self.action, self.delay, self.names = action, delay, set()

    def ask(self, name):
        if not self.names:
            QtCore.QTimer.singleShot(self.delay, self.act)
        self.names.add(name)

    def act(self):
        names, self.names = self.names, set()
        for name in names & set(FreeCAD.listDocuments()):
            self.action(FreeCAD.getDocument(name))


def end_all():
    """Stops all threads and waits for them, for the end of the program."""
    for thread in list(_running):
        thread.stop.set()
    for thread in list(_running):
        thread.wait(thread.patience)
        if thread.left_folder:
            shutil.rmtree(thread.left_folder, ignore_errors=True)


QtCore.QCoreApplication.instance().aboutToQuit.connect(end_all)
