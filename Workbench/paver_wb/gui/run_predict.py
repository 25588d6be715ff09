"""Predictions while options are edited: on a thread, a moment after the last edit."""
from PySide import QtCore

from paver_wb import core, mesh_object, meshing, source_shapes
from paver_wb.gui import run_control, run_thread

DELAY = 300  # ms without an edit


class Predictor(QtCore.QObject):
    """ask() for a prediction of a mesh object with other options; `predicted` or `failed` tells the last one asked for.

    The shape is handed over once and read once, until it changes.
    """

    predicted = QtCore.Signal(object)
    failed = QtCore.Signal(object)

    def __init__(self, obj):
        super().__init__()
        self.obj, self.changes, self.thread = obj, {}, None
        self.shapes, self.shape_job, self.model = None, None, None
        self.timer = QtCore.QTimer(self)
        self.timer.setSingleShot(True)
        self.timer.setInterval(DELAY)
        self.timer.timeout.connect(self.begin)

    def ask(self, changes):
        self.drop()
        self.changes = changes
        self.timer.start()

    def drop(self):
        """Asks for nothing any more."""
        self.timer.stop()
        if self.thread is not None:
            self.thread.stop.set()
            self.thread.done.disconnect(self.tell)
            self.thread = None

    def job(self):
        """The Job, with the shape of before where it is the same."""
        shapes = source_shapes.of(mesh_object.sources(self.obj))
        if self.shapes is None or not source_shapes.are_same(shapes, self.shapes):
            self.shape_job = meshing.prepare(self.obj, **self.changes)
            self.model, self.shapes = self.shape_job.model(), shapes
        return self.shape_job._replace(options=meshing.options_of(self.obj, self.changes))

    @QtCore.Slot()
    def begin(self):
        try:
            options = self.job().options
        except Exception as error:
            self.failed.emit(error)
            return
        model = self.model
        thread = run_thread.Background(lambda: core.load().predict(model, cancel=thread.stop, **options))
        self.thread = thread
        thread.done.connect(self.tell)
        thread.begin()

    @QtCore.Slot()
    def tell(self):
        if self.thread is None:
            return
        thread, self.thread = self.thread, None
        if thread.error is None:
            self.predicted.emit(thread.result)
        elif not isinstance(thread.error, core.load().Cancelled):
            self.failed.emit(thread.error)

    def offer(self):
        """Offers the model, which may be read already, to the next run."""
        if self.model is not None:
            run_control.offer(self.shape_job.digest, self.model)
