"""Predictions while options are edited: on a thread, a moment after the last edit."""
from PySide import QtCore

from paver_wb import core, mesh_object, meshing
from paver_wb.base import source_shapes
from paver_wb.gui.base.background import Latest
from paver_wb.gui.base.widgets import timer

DELAY = 300  # ms without an edit


class Predictor(QtCore.QObject):
    """ask() for a prediction of a mesh object with other options; `predicted` or `failed` tells the last one asked for.

    The shape is handed over once and read once, until it changes.
    """

    predicted = QtCore.Signal(object)
    failed = QtCore.Signal(object)

    def __init__(self, obj):
        super().__init__()
        self.obj, self.changes = obj, {}
        self.latest = Latest(self.predicted.emit, self.failed.emit)
        self.shapes, self.shape_job, self.model = None, None, None
        self.timer = timer(self, self.begin, DELAY)

    def ask(self, changes):
        self.drop()
        self.changes = changes
        self.timer.start()

    def drop(self):
        """Asks for nothing any more."""
        self.timer.stop()
        self.latest.drop()

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
        self.latest.ask(lambda cancel: core.load().predict(model, cancel=cancel, **options))

    def offered(self):
        """(digest of the shape, its paver.Model, which may be read already) for the next run; (None, None) without one."""
        return (self.shape_job.digest, self.model) if self.model is not None else (None, None)
