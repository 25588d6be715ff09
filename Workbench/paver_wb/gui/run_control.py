"""Meshing from the window: on a thread, one run after the other, the result taken into the document when it may be."""
import os
import time
from typing import NamedTuple

import FreeCAD
from PySide import QtCore

from paver_wb import core, mesh_check, mesh_object, meshing, properties
from paver_wb.base import source_shapes
from paver_wb.base.texts import counted, listed
from paver_wb.gui import run_place
from paver_wb.gui.base import background, run_log, run_status, time_left
from paver_wb.gui.base.run_task import DONE, FAILED, RUNNING, STOPPED, WAITING, Task
from paver_wb.gui.display import drawn_mesh, mesh_display
from paver_wb.processes import child_process, mesh_job
from paver_wb.statistics import number

MESHED, CANCELLED = "meshed", "cancelled"
NAMED = 3  # faces in a message
translate = FreeCAD.Qt.translate

_runs = []  # those that have not ended, in order; the first one is at work
offered = background.Offer()  # by the digest of a shape: its paver.Model, which was read before


class Outcome(NamedTuple):
    """How a run ended.

    kind: MESHED, CANCELLED, FAILED. text: one sentence. place: the mesh_job.Place of what could not be meshed, or None. log: further lines, maybe
    empty. seconds: {"hand over": ..., "mesh": ..., "take back": ...}, as far as it came. mesh: the StoredMesh or None.
    """

    kind: str
    text: str
    place: object
    log: str
    seconds: dict
    mesh: object


class MeshThread(background.Background):
    """Does a job, in this process or in one of its own; `result` is the StoredMesh, `path` its file in `folder`, `drawn`
    the DrawnMesh for the 3D view, `told_of_mesh` sentences on what was done to the model and the elements.

    run_in: a value of mesh_object.RUN_IN; from so many `heavy` predicted elements on "Automatic" means an own process.
    subdivision: of the drawing, 0 the one that fits; None: it is not shown, so nothing is made for it.
    """

    moved = QtCore.Signal()  # to a process of its own

    def __init__(self, job, folder, run_in, heavy, model=None, subdivision=None):
        super().__init__()
        self.job, self.folder, self.run_in, self.heavy, self.model = job, folder, run_in, heavy, model
        self.subdivision, self.drawn, self.path, self.told_of_mesh = subdivision, None, None, []

    def is_for_child(self):
        if self.run_in != mesh_object.AUTOMATIC:
            return self.run_in == mesh_object.IN_PROCESS
        if self.job.options.get(properties.RANKS):
            return False  # ranks are processes of their own anyway
        self.model = self.model or self.job.model()
        return core.load().predict(self.model, cancel=self.stop, **self.job.options).elements >= self.heavy

    def work(self):
        made = self.made()
        self.told_of_mesh = what_was_done(made)
        if self.subdivision is not None:
            self.tell(run_status.DRAWING, 0.0)
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
        self.path = os.path.join(self.folder, child_process.MESH)
        return mesh_job.store(self.job, self.path, self.tell, self.stop, self.model)


def what_was_done(mesh):
    """[sentence] on faces, repairs and merges of a StoredMesh, in any thread."""
    faces, repairs = mesh.report["faces"], mesh.report.get("element_repairs", [])
    failed = sum(face["status"] == "failed" for face in faces)
    told = [counted(len(faces) - failed, translate("Paver", "{} face is meshed."), translate(
        "Paver", "{} faces are meshed.")).format(number(len(faces) - failed))]
    told += [counted(failed, translate("Paver", "{} face is not meshed."), translate(
        "Paver", "{} faces are not meshed.")).format(number(failed))] if failed else []
    told += [finding.text for finding in (*mesh_check.repairs(mesh), *mesh_check.merges(mesh))]
    if repairs:
        names = list(dict.fromkeys(repair["entity"] for repair in repairs))
        told.append(counted(len(repairs), translate("Paver", "{} element was repaired: {}."), translate(
            "Paver", "{} elements were repaired: {}.")).format(number(len(repairs)), listed(names, NAMED)))
    return told


class Run(Task):
    """One meshing of a mesh object."""

    moved = QtCore.Signal()
    thread_kind = MeshThread

    def __init__(self, obj, run_in, changes, like=None):
        """like: a Run of the same objects, whose shape this one takes."""
        start = time.monotonic()
        job, shapes = (meshing.prepare_like(like.job, obj, **changes), like.shapes) if like else (
            meshing.prepare(obj, **changes), source_shapes.of(mesh_object.sources(obj)))
        super().__init__(obj.Label, obj.Document)
        self.begun, self.job, self.shapes = start, job, shapes
        self.obj, self.name, self.run_in, self.changes, self.fraction = obj, obj.Name, run_in, changes, 0.0
        self.follow(self.thread_kind(job, self.folder, run_in or obj.RunIn, mesh_object.heavy_elements(),
                                     offered.take(job.digest), shown_subdivision(obj)))
        self.thread.moved.connect(self.moved)
        self.thread.moved.connect(self.note_moved)
        self.end_text, self.place = "", None
        self.seconds, self.estimate, self.log = {"hand over": time.monotonic() - start}, time_left.TimeLeft(), run_log.new(obj)
        self.log.note(translate("Paver", "Shape of {:.2f} MB handed over in {:.2f} s").format(
            len(job.shape) / 1e6, self.seconds["hand over"]))
        self.progressed.connect(self.note_progress)
        self.ended.connect(self.note_end)

    def is_of(self, obj):
        return (self.document, self.name) == (obj.Document.Name, obj.Name)

    def line(self):
        return f"{self.text}: {self.stage_line()}"

    def stage_line(self):
        return run_status.stage_text(self.stage)

    def percent(self):
        return run_status.percent(self.stage, self.fraction)

    def left_text(self):
        """How long it will still take; empty while that cannot be told."""
        if self.state != RUNNING:
            return ""
        return time_left.text_of(self.estimate.left(run_status.share(self.stage, self.fraction), time.monotonic() - self.begun))

    def begin(self):
        self.begun = time.monotonic()
        super().begin()

    @QtCore.Slot(str, float)
    def note_progress(self, stage, fraction):
        self.log.tell(stage, fraction)

    @QtCore.Slot()
    def note_moved(self):
        self.log.note(translate("Paver", "Meshing in a process of its own"))

    def note_end(self, outcome):
        """Into the log: what has come of it."""
        for line in filter(None, [*(self.thread.told_of_mesh if outcome.kind == MESHED else ()), outcome.text,
                                  *outcome.log.splitlines()]):
            self.log.note(line)
        if outcome.kind == MESHED:
            self.log.note(translate("Paver", "{:.2f} s of meshing, {:.2f} s to take it into the document").format(
                outcome.seconds["mesh"], outcome.seconds["take back"]))

    def abandon(self):
        """Stops it when its mesh object has gone."""
        self.obj = None
        self.cancel.set()
        self.end_text = translate("Paver", "Meshing of '{}' was stopped, as it was deleted.").format(self.text)
        self.end(STOPPED)

    def take_back(self):
        self.seconds.setdefault("mesh", time.monotonic() - self.begun)
        super().take_back()

    def take(self, mesh):
        """Takes the result into the document."""
        start = time.monotonic()
        is_outdated = meshing.has_changed(self.obj, self.job, self.shapes)
        meshing.keep(self.obj, self.job, mesh, self.thread.path, is_outdated, self.run_in, **self.changes)
        if self.thread.drawn is not None:
            drawn_mesh.offered.put(self.obj.MeshFile, self.thread.drawn)
        self.seconds["take back"] = time.monotonic() - start
        self.end_text = translate("Paver", "'{}' has {} quads and {} triangles").format(self.text, len(mesh.quads),
                                                                                        len(mesh.triangles))
        failed = mesh_job.failures(self.job, mesh)
        if not failed:
            self.end_text += "."
            return
        names = listed([place.element for place, _ in failed], NAMED)
        self.end_text += translate("Paver", ", but {} could not be meshed: {}.").format(names, failed[0][1])
        self.place = failed[0][0]

    def told(self, how):
        """The Outcome. Tells the report view, and selects what could not be meshed."""
        kind = {DONE: MESHED, STOPPED: CANCELLED}.get(how, FAILED)
        if kind == FAILED:
            self.end_text = str(self.error) or type(self.error).__name__
            self.place = getattr(self.error, "place", None)
        elif kind == CANCELLED and not self.end_text:
            self.end_text = translate("Paver", "Meshing of '{}' was stopped; it is as before.").format(self.text)
        if kind == FAILED or self.place:
            FreeCAD.Console.PrintError(f"{self.text}: {self.end_text}\n")
        else:
            FreeCAD.Console.PrintMessage(self.end_text + "\n")
        if self.place:
            run_place.select(self.obj, self.place)
        return Outcome(kind, self.end_text, self.place, getattr(self.error, "log", ""), self.seconds,
                       self.thread.result if how == DONE else None)

    def end(self, how, error=None):
        if self in _runs:
            _runs.remove(self)
        super().end(how, error)
        self.thread.model = self.thread.drawn = None
        begin_next()


def shown_subdivision(obj):
    """The view property Subdivision; None where the mesh is not drawn by Paver."""
    view = obj.ViewObject
    return view.Subdivision if view.DisplayMode in mesh_display.MODES else None


class Announcer(QtCore.QObject):
    """`started`: a Run, or a series of them, is there, whoever asked for it."""

    started = QtCore.Signal(object)


announcer = Announcer()


def begin_next():
    if _runs and _runs[0].state == WAITING:
        _runs[0].begin()


def start(obj, run_in=None, **changes):
    """Meshes a mesh object on a thread; gives the Run. One run follows the other.

    run_in, changes: RunIn and options, as properties.put takes them, to be set together with the result; until then the
    object is as before, and it stays so after an error or a stop. ValueError when the object is being meshed already; errors of
    meshing.prepare.
    """
    if run_of(obj):
        raise ValueError(translate("Paver", "'{}' is being meshed; wait for that or stop it first.").format(obj.Label))
    return queue(Run(obj, run_in, changes))


def queue(run):
    """Begins a Run when those before it have ended, and gives it."""
    _runs.append(run)
    run_status.watch(run)
    announcer.started.emit(run)
    begin_next()
    return run


def run_of(obj):
    """The Run of a mesh object that has not ended, or None."""
    return next((run for run in _runs if run.is_of(obj)), None)


class Observer:
    """Stops runs whose mesh object goes away."""

    def slotDeletedObject(self, obj):
        for run in [run for run in _runs if run.is_of(obj)]:
            run.abandon()

    def slotDeletedDocument(self, document):
        run_log.forget(document.Name)
        for run in [run for run in _runs if run.document == document.Name]:
            run.abandon()


_observer = Observer()
FreeCAD.addDocumentObserver(_observer)
