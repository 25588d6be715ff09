"""Threads that work while the window lives on. None of them touches a document or the 3D view."""
import os
import shutil

from PySide import QtCore

from paver_wb import child_process, core, mesh_file, mesh_job, mesh_object, properties
from paver_wb.gui.display import drawn_mesh

STEP = 0.02  # share of a stage
_running = set()  # Qt ends the program when a thread's object goes before the thread


class Background(QtCore.QThread):
    """Calls `work()` in a thread, then emits `done`: `result` is what it gave, or `error` what it raised.

    `stop` is the cancel token for the core. A thread that is stopped and dropped ends by itself, and removes
    `left_folder` then.
    """

    done = QtCore.Signal()

    def __init__(self, work=None):
        super().__init__()
        if work is not None:
            self.work = work
        self.stop, self.result, self.error, self.left_folder = core.load().Cancel(), None, None, None
        self.finished.connect(self.leave, QtCore.Qt.QueuedConnection)

    def begin(self):
        _running.add(self)
        self.start()

    def run(self):
        try:
            self.result = self.work()
        except Exception as error:
            self.error = error

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


def end_all(milliseconds=2000):
    """Stops all threads and waits for them, for the end of the program."""
    for thread in list(_running):
        thread.stop.set()
    for thread in list(_running):
        thread.wait(milliseconds)
        if thread.left_folder:
            shutil.rmtree(thread.left_folder, ignore_errors=True)


class MeshThread(Background):
    """Does a job, in this process or in one of its own; `result` is the StoredMesh, `path` its file in `folder`, `drawn`
    the DrawnMesh for the 3D view.

    run_in: a value of mesh_object.RUN_IN; from so many `heavy` predicted elements on "Automatic" means an own process.
    subdivision: of the drawing, 0 the one that fits; None: it is not shown, so nothing is made for it.
    """

    progressed = QtCore.Signal(str, float)
    moved = QtCore.Signal()  # to a process of its own

    def __init__(self, job, folder, run_in, heavy, model=None, subdivision=None):
        super().__init__()
        self.job, self.folder, self.run_in, self.heavy, self.model = job, folder, run_in, heavy, model
        self.subdivision, self.drawn = subdivision, None
        self.path, self.told = None, ("", 0.0)

    def tell(self, stage, fraction):
        """Passes on progress worth showing: another stage, or a step of it that can be seen."""
        if stage != self.told[0] or fraction - self.told[1] >= STEP:
            self.told = (stage, fraction)
            self.progressed.emit(stage, fraction)

    def is_for_child(self):
        if self.run_in != mesh_object.AUTOMATIC:
            return self.run_in == mesh_object.IN_PROCESS
        if self.job.options.get(properties.RANKS):
            return False  # ranks are processes of their own anyway
        self.model = self.model or self.job.model()
        return core.load().predict(self.model, cancel=self.stop, **self.job.options).elements >= self.heavy

    def work(self):
        made = self.made()
        if self.subdivision is not None:
            self.tell("drawing", 0.0)
            drawn = drawn_mesh.DrawnMesh(made)
            drawn.prepare(self.subdivision)
            self.drawn = drawn
        return made

    def made(self):
        if self.is_for_child():
            self.model = None  # it may be large
            self.moved.emit()
            made, self.path = child_process.run(self.job, self.folder, self.tell, self.stop)
            return made
        made = mesh_job.stored(self.job, mesh_job.run(self.job, self.tell, self.stop, self.model))
        self.tell("write", 0.0)
        self.path = os.path.join(self.folder, child_process.MESH)
        mesh_file.write(made, self.path)
        return made
