"""Meshing from the window: on a thread, one run after the other, the result taken into the document when it may be."""
import os
import tempfile
import time
from typing import NamedTuple

import FreeCAD
from PySide import QtCore

from paver_wb import core, mesh_job, mesh_object, meshing, source_shapes
from paver_wb.gui import run_place, run_status, run_thread
from paver_wb.gui.run_task import BUSY, PATIENCE, is_busy
from paver_wb.gui.display import drawn_mesh, mesh_display

WAITING, RUNNING, TAKING, ENDED = "waiting", "running", "taking", "ended"
MESHED, CANCELLED, FAILED = "meshed", "cancelled", "failed"
NAMED = 3  # faces in a message
translate = FreeCAD.Qt.translate

_runs = []  # those that have not ended, in order; the first one is at work
_offer = (None, None)  # digest of a shape, its paver.Model


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


class Run(QtCore.QObject):
    """One meshing of a mesh object. Everything of it but its thread is in the main thread."""

    progressed = QtCore.Signal(str, float)
    moved = QtCore.Signal()
    ended = QtCore.Signal(object)

    def __init__(self, obj, run_in, changes):
        super().__init__()
        start = time.monotonic()
        self.obj, self.run_in, self.changes, self.state, self.outcome = obj, run_in, changes, WAITING, None
        self.document, self.name, self.label = obj.Document.Name, obj.Name, obj.Label
        self.stage, self.fraction, self.begun = "", 0.0, start
        self.job, self.shapes = meshing.prepare(obj, **changes), source_shapes.of(mesh_object.sources(obj))
        self.folder = tempfile.mkdtemp(prefix="paver", dir=os.path.dirname(obj.Document.TransientDir))
        self.thread = run_thread.MeshThread(self.job, self.folder, run_in or obj.RunIn, mesh_object.heavy_elements(),
                                            offered(self.job.digest), shown_subdivision(obj))
        self.thread.progressed.connect(self.tell, QtCore.Qt.QueuedConnection)
        self.thread.moved.connect(self.moved)
        self.thread.done.connect(self.take_back)
        self.seconds = {"hand over": time.monotonic() - start}

    def is_of(self, obj):
        return (self.document, self.name) == (obj.Document.Name, obj.Name)

    def line(self):
        return f"{self.label}: {run_status.stage_text(self.stage)}"

    def percent(self):
        return run_status.percent(self.stage, self.fraction)

    def begin(self):
        self.state, self.begun = RUNNING, time.monotonic()
        self.thread.begin()

    def stop(self):
        """Stops it; `ended` comes within a second."""
        self.thread.stop.set()
        if self.state in (WAITING, TAKING):
            self.end(CANCELLED, self.cancelled())
        elif self.state == RUNNING:
            QtCore.QTimer.singleShot(PATIENCE, self.leave)

    def cancelled(self):
        return translate("Paver", "Meshing of '{}' was stopped; it is as before.").format(self.label)

    def abandon(self):
        """Stops it when its mesh object has gone."""
        self.obj = None
        self.thread.stop.set()
        self.end(CANCELLED, translate("Paver", "Meshing of '{}' was stopped, as it was deleted.").format(self.label))

    @QtCore.Slot()
    def leave(self):
        """After a stop that the core has not answered: inside a long call of the CAD kernel it cannot."""
        if self.state == RUNNING:
            self.end(CANCELLED, self.cancelled())

    @QtCore.Slot(str, float)
    def tell(self, stage, fraction):
        if self.state == RUNNING and stage != "done":
            self.stage, self.fraction = stage, fraction
            self.progressed.emit(stage, fraction)

    @QtCore.Slot()
    def take_back(self):
        """Takes the result into the document, as soon as nothing else is changing that."""
        if self.state == ENDED:
            return
        self.seconds.setdefault("mesh", time.monotonic() - self.begun)
        if self.thread.error is not None or self.thread.stop.is_set():
            self.fail(self.thread.error)
        elif is_busy(self.obj.Document):
            self.state = TAKING
            QtCore.QTimer.singleShot(BUSY, self.take_back)
        else:
            self.keep()

    def keep(self):
        start, mesh = time.monotonic(), self.thread.result
        try:
            is_outdated = meshing.has_changed(self.obj, self.job, self.shapes)
            meshing.keep(self.obj, self.job, mesh, self.thread.path, is_outdated, self.run_in,
                         **self.changes)
        except Exception as error:
            return self.fail(error)
        if self.thread.drawn is not None:
            drawn_mesh.offer(self.obj.MeshFile, self.thread.drawn)
        self.seconds["take back"] = time.monotonic() - start
        text = translate("Paver", "'{}' has {} quads and {} triangles").format(self.label, len(mesh.quads),
                                                                               len(mesh.triangles))
        failed = mesh_job.failures(self.job, mesh)
        if not failed:
            return self.end(MESHED, text + ".", mesh=mesh)
        names = ", ".join(place.element for place, _ in failed[:NAMED]) + (", ..." if failed[NAMED:] else "")
        text += translate("Paver", ", but {} could not be meshed: {}.").format(names, failed[0][1])
        return self.end(MESHED, text, failed[0][0], mesh=mesh)

    def fail(self, error):
        if self.thread.stop.is_set() or isinstance(error, core.load().Cancelled):
            return self.end(CANCELLED, self.cancelled())
        text = str(error) or type(error).__name__
        return self.end(FAILED, text, getattr(error, "place", None), getattr(error, "log", ""))

    def end(self, kind, text, place=None, log="", mesh=None):
        self.state = ENDED
        if self in _runs:
            _runs.remove(self)
        self.thread.drop_folder(self.folder)
        self.outcome = Outcome(kind, text, place, log, self.seconds, mesh)
        self.thread.result = self.thread.model = self.thread.drawn = None  # Qt may keep the thread for a while
        report(self)
        self.ended.emit(self.outcome)
        begin_next()


def shown_subdivision(obj):
    """The view property Subdivision; None where the mesh is not drawn by Paver."""
    view = obj.ViewObject
    return view.Subdivision if view.DisplayMode in mesh_display.MODES else None


class Announcer(QtCore.QObject):
    """`started`: a Run is there, whoever asked for it."""

    started = QtCore.Signal(object)


announcer = Announcer()


def report(run):
    """Tells the report view, and selects what could not be meshed."""
    outcome = run.outcome
    if outcome.log:
        FreeCAD.Console.PrintLog(outcome.log + "\n")
    if outcome.kind == FAILED or outcome.place:
        FreeCAD.Console.PrintError(f"{run.label}: {outcome.text}\n")
    else:
        FreeCAD.Console.PrintMessage(outcome.text + "\n")
    if outcome.place:
        run_place.select(run.obj, outcome.place)


def begin_next():
    if _runs and _runs[0].state == WAITING:
        _runs[0].begin()


def offer(digest, model):
    """Names a paver.Model that was read before, for the next run to use if its shape has that digest."""
    global _offer
    _offer = (digest, model)


def offered(digest):
    global _offer
    (known, model), _offer = _offer, (None, None)
    return model if known == digest else None


def start(obj, run_in=None, **changes):
    """Meshes a mesh object on a thread; gives the Run. One run follows the other.

    run_in, changes: RunIn and options, as properties.put takes them, to be set together with the result; until then the
    object is as before, and it stays so after an error or a stop. ValueError when the object is being meshed already; errors of
    meshing.prepare.
    """
    if run_of(obj):
        raise ValueError(f"'{obj.Label}' is being meshed; wait for that or stop it first.")
    run = Run(obj, run_in, changes)
    _runs.append(run)
    run_status.watch(run)
    announcer.started.emit(run)
    begin_next()
    return run


def run_of(obj):
    """The Run of a mesh object that has not ended, or None."""
    return next((run for run in _runs if run.is_of(obj)), None)


def stop(obj):
    """Stops the run of a mesh object, if there is one."""
    run = run_of(obj)
    if run:
        run.stop()


class Observer:
    """Stops runs whose mesh object goes away."""

    def slotDeletedObject(self, obj):
        for run in [run for run in _runs if run.is_of(obj)]:
            run.abandon()

    def slotDeletedDocument(self, document):
        for run in [run for run in _runs if run.document == document.Name]:
            run.abandon()


_observer = Observer()
FreeCAD.addDocumentObserver(_observer)
QtCore.QCoreApplication.instance().aboutToQuit.connect(run_thread.end_all)
