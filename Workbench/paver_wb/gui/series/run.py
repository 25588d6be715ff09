"""Series in the window: one step after the other, beside it, each as any run of a mesh object."""
import time

import FreeCAD
import FreeCADGui
from PySide import QtCore

from paver_wb import meshing, series
from paver_wb.base import proxies
from paver_wb.gui import run_control, run_place
from paver_wb.gui.base.run_task import DONE, STOPPED, WAITING
from paver_wb.gui.base.widgets import complain, translate

_at_work = []  # SeriesRuns that have not ended


class StepThread(run_control.MeshThread):
    """Also measures the mesh and writes its files: `row` has what came of it."""

    row, plan = None, series.Plan()

    def work(self):
        start = time.monotonic()
        made = self.made()
        self.told_of_mesh = run_control.what_was_done(made)
        self.row = series.row_of(made, self.path, time.monotonic() - start, self.plan, self.folder, self.stop)
        return made


class StepRun(run_control.Run):
    """One step of a series: of its mesh object, else with the options of the series' own."""

    thread_kind = StepThread

    def __init__(self, obj, step, first=None):
        """first: the StepRun of another step, where there is one."""
        child = series.mesh_of(obj, step.number)
        mesh = child or obj.Mesh
        like = first if first and proxies.sources(first.obj) == proxies.sources(mesh) else None
        super().__init__(mesh, None, {} if child else step.changes, like)
        self.series, self.series_name, self.step, self.is_kept = obj, obj.Name, step, child is not None
        self.text = f"{obj.Label} {step.text}"
        self.thread.plan, self.thread.subdivision = series.plan_of(obj, step), None  # nothing is shown yet

    def is_of(self, obj):
        is_series = (self.document, self.series_name) == (obj.Document.Name, obj.Name)
        return is_series or self.is_kept and super().is_of(obj)

    def take(self, mesh):
        is_outdated = self.is_kept and meshing.has_changed(self.obj, self.job, self.shapes)
        start = time.monotonic()
        series.keep(self.series, self.step, self.thread.row, self.job, mesh, self.thread.path, is_outdated)
        self.seconds["take back"] = time.monotonic() - start
        self.end_text = translate("Paver", "'{}' has {} quads and {} triangles").format(
            self.text, len(mesh.quads), len(mesh.triangles)) + "."
        FreeCAD.Console.PrintMessage(self.end_text + "\n")

    def told(self, how):
        """Errors are told in the row; the next step goes on."""
        kind = {DONE: run_control.MESHED, STOPPED: run_control.CANCELLED}.get(how, run_control.FAILED)
        if kind == run_control.FAILED:
            row = series.failed_row(self.error, self.seconds.get("mesh", 0.0))
            self.end_text = row.error
            put(self.series, self.step, row)
            FreeCAD.Console.PrintError(f"{self.text}: {self.end_text}\n")
        return run_control.Outcome(kind, self.end_text, getattr(self.error, "place", None), getattr(self.error, "log", ""),
                                   self.seconds, self.thread.result if how == DONE else None)


def put(obj, step, row):
    """The row of a step without a mesh, where the series is still there."""
    try:
        series.keep(obj, step, row)
    except (ReferenceError, RuntimeError):
        pass


class SeriesRun(QtCore.QObject):
    """All steps of a series that are to be done. `told`: something has changed; `ended`: nothing of it runs any more."""

    told = QtCore.Signal()
    ended = QtCore.Signal()

    def __init__(self, obj):
        super().__init__()
        self.obj, self.document, self.name, self.runs = obj, obj.Document.Name, obj.Name, []
        for step in series.steps_to_do(obj):
            self.add(step)

    def add(self, step):
        try:
            run = StepRun(self.obj, step, self.runs[0] if self.runs else None)
        except Exception as error:  # of a step that cannot be begun at all
            put(self.obj, step, series.failed_row(error))
            return
        run.progressed.connect(self.tell)
        run.ended.connect(self.next)
        self.runs.append(run)

    def begin(self):
        _at_work.append(self)
        for run in list(self.runs):
            run_control.queue(run)
        self.next()

    @QtCore.Slot()
    def tell(self, *_):
        self.told.emit()

    def next(self, _outcome=None):
        self.runs = [run for run in self.runs if run.outcome is None]
        self.told.emit()
        if not self.runs and self in _at_work:
            _at_work.remove(self)
            self.write_table()
            self.ended.emit()

    def write_table(self):
        try:
            if self.obj.Formats and self.obj.Mesh and any(series.rows_of(self.obj)):
                series.write_csv(self.obj, series.table_path(self.obj))
        except (ReferenceError, RuntimeError):  # the series is gone
            pass
        except ValueError as error:
            complain(str(error))

    def stop(self):
        """Keeps what is done. The last ones first: none begins meanwhile."""
        for run in reversed(self.runs):
            run.stop()

    def state(self, number):
        """What a step is doing, for users; empty where it is not at work."""
        run = next((run for run in self.runs if run.step.number == number), None)
        if run is None:
            return ""
        return translate("Paver", "Waiting") if run.state == WAITING else f"{run.stage_line()}  {run.percent()} %"


announcer = run_control.Announcer()


def start(mesh, frequencies=None, divisions=None, sizes=None, formats=(), folder=""):
    """Makes a series of a mesh object and meshes its steps beside the window; gives the SeriesRun. Arguments and errors as
    those of series.add."""
    return go_on(series.add(mesh, frequencies, divisions, sizes, formats, folder))


def go_on(obj):
    """Meshes the steps of a series that have not been done. ValueError when it is at work already, or has no mesh object."""
    if run_of(obj):
        raise ValueError(translate("Paver", "'{}' is being meshed; wait for that or stop it first.").format(obj.Label))
    if obj.Mesh is None and not obj.Meshes:
        raise ValueError(translate("Paver", "The mesh object of '{}' is gone; make a series of another one.").format(obj.Label))
    run = SeriesRun(obj)
    announcer.started.emit(run)
    run.begin()
    return run


def run_of(obj):
    """The SeriesRun of a series that has not ended, or None."""
    return next((run for run in _at_work if (run.document, run.name) == (obj.Document.Name, obj.Name)), None)


def show(obj, number):
    """Shows the mesh of a step, from 0, alone, and selects it. ValueError where the document has none."""
    child = series.mesh_of(obj, number)
    if child is None or not child.MeshFile:
        raise ValueError(translate("Paver", "Step {} of '{}' has no mesh in the document; mesh it first.").format(
            number + 1, obj.Label))
    for other in filter(None, (obj.Mesh, *obj.Meshes)):
        if other != child and other.ViewObject.Visibility:
            other.ViewObject.Visibility = False
    run_place.show(child, mesh=True)
    FreeCADGui.Selection.clearSelection()
    FreeCADGui.Selection.addSelection(child)
