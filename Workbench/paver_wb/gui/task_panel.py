"""The task panel of a mesh object.

Options are changed in the fields only, until Apply, OK or Mesh puts them into the mesh object, in one step of undo.
Local sizes are put in at once, each in a step of its own. Cancel drops what was not applied, local sizes too, stops a run,
and takes back a mesh object that was made for this panel and is unused.
"""
import os

import FreeCAD
import FreeCADGui
from PySide import QtCore, QtGui

from paver_wb import core, mesh_object, refinement
from paver_wb.gui import (first_use, run_control, run_predict, task_panel_options, task_panel_result, task_panel_run,
                          task_panel_sizes)
from paver_wb.gui.paths import ICONS
from paver_wb.gui.task_panel_steps import in_step, python_name

translate = FreeCAD.Qt.translate
FRAME = 90  # pixels that FreeCAD puts around a part of a panel, scroll bar included
_open = None  # the panel on screen
_new = None  # the mesh object that the next panel is made with


def button_set():
    return QtGui.QDialogButtonBox.Ok | QtGui.QDialogButtonBox.Apply | QtGui.QDialogButtonBox.Cancel


class TaskPanel:
    """What FreeCAD calls, and what ties the parts together. is_new: the object was made for this panel."""

    def __init__(self, obj, is_new=False):
        self.obj, self.is_new, self.run, self.is_closed = obj, is_new, None, False
        self.document, self.document_name = obj.Document, obj.Document.Name
        self.steps = self.document.UndoCount
        self.options = task_panel_options.OptionsBox(obj)
        self.sizes = task_panel_sizes.SizesBox(obj)
        self.runner = task_panel_run.RunBox(obj)
        self.results = task_panel_result.ResultBox(obj)
        self.predictor = run_predict.Predictor(obj)
        self.form = [self.options, self.sizes, self.runner, self.results]
        for part in self.form:
            part.setWindowIcon(QtGui.QIcon(os.path.join(ICONS, "Paver_CreateMesh.svg")))
        self.options.changed.connect(self.predict)
        self.sizes.failed.connect(self.runner.show_fault)
        self.runner.mesh_asked.connect(self.mesh)
        self.runner.stop_asked.connect(self.stop)
        self.predictor.predicted.connect(self.show_prediction)
        self.predictor.failed.connect(self.show_no_prediction)
        run_control.announcer.started.connect(self.watch)
        self.observer = Observer(self)
        FreeCAD.addDocumentObserver(self.observer)
        self.results.refresh()
        if run_control.run_of(obj):
            self.watch(run_control.run_of(obj))
        self.predict()

    # Predicting

    def predict(self):
        """Tells what the options come to: at once where the mesh has been made with them, else by a prediction."""
        fault = self.options.fault()
        if fault:
            self.predictor.drop()
            self.runner.prediction.setText(fault)
        elif self.obj.Status == mesh_object.UP_TO_DATE and not self.options.changes():
            self.predictor.drop()
            self.runner.prediction.setText(task_panel_run.count_of_mesh(self.obj))
        else:
            self.runner.prediction.setText(translate("Paver", "Predicting..."))
            self.predictor.ask(self.options.changes())
        if self.run is None:
            self.runner.show_status(bool(fault or self.changes()))
        self.runner.mesh.setEnabled(not fault and self.run is None)

    def sizes_changed(self):
        self.sizes.refresh_soon()
        if self.run is None:
            self.predict()

    def show_prediction(self, prediction):
        self.runner.prediction.setText(task_panel_run.prediction_text(
            prediction, self.options.run_in.value(), self.options.fields["max_elements"].value()))

    def show_no_prediction(self, error):
        self.runner.prediction.setText(task_panel_options.with_labels(str(error)))

    # Meshing

    def mesh(self):
        if self.options.fault() or run_control.run_of(self.obj):
            return
        try:
            self.start(self.changes())
        except Exception as error:  # of what cannot be begun at all
            self.runner.show_fault(str(error))

    def changes(self):
        """{argument of run_control.start: value} of what was edited: options, and run_in."""
        changes = self.options.changes()
        if self.options.run_in.value() != self.obj.RunIn:
            changes["run_in"] = self.options.run_in.value()
        return changes

    def start(self, changes):
        """Starts a run as the console would."""
        FreeCADGui.addModule("paver_wb.gui.run_control")
        text = "".join(f", {name}={value!r}" for name, value in changes.items())
        self.predictor.offer()
        FreeCADGui.doCommand(f"paver_wb.gui.run_control.start({python_name(self.obj)}{text})")

    def watch(self, run):
        """Follows a run of the mesh object, also one that a command has started."""
        if not run.is_of(self.obj):
            return
        self.run = run
        run.ended.connect(self.show_end)
        for part in (self.options, self.sizes):
            part.setEnabled(False)
        self.runner.watch(run)

    def show_end(self, outcome):
        self.run = None
        for part in (self.options, self.sizes):
            part.setEnabled(True)
        self.runner.show_end(outcome)
        if outcome.kind == run_control.MESHED:
            self.is_new = False
            self.options.refresh()
            self.sizes.settle()
            if not self.obj.ViewObject.Visibility:
                self.sizes.show_in_view(shows_mesh=True)
            self.results.refresh(outcome.mesh)
        self.predict()

    def stop(self):
        if self.run is not None:
            self.run.stop()

    # Applying

    def apply(self):
        """Puts the options into the mesh object. False when a field has no value."""
        fault = self.options.fault()
        if fault:
            self.runner.show_fault(fault)
            return False
        self.sizes.settle()
        self.is_new = False
        changes = self.changes()
        if self.run is not None and changes == self.run_changes():  # they come with its result
            return True
        self.put(changes)
        self.options.refresh()
        self.runner.show_status()
        return True

    def run_changes(self):
        """changes() with which the run was started."""
        return {**self.run.changes, **({"run_in": self.run.run_in} if self.run.run_in else {})}

    def put(self, changes):
        """Puts changes() into the mesh object as one step of undo."""
        lines, run_in = [], changes.pop("run_in", None)
        if run_in:
            lines.append(f"{python_name(self.obj)}.RunIn = {run_in!r}")
        if changes:
            lines.append(f"paver_wb.properties.put({python_name(self.obj)}, {changes!r})")
        if lines:
            in_step(self.document, translate("Paver", "Options of {}").format(self.obj.Label), ["paver_wb.properties"],
                    lines)

    # What FreeCAD calls

    def getStandardButtons(self):
        return getattr(button_set(), "value", None) or int(button_set())

    def open(self):
        # Not in modifyStandardButtons(): FreeCAD hands out a box there that Python never learns the end of, and takes
        # whatever comes to lie at its place for it.
        tips = {QtGui.QDialogButtonBox.Ok: translate("Paver", "Applies the options and closes; a run goes on"),
                QtGui.QDialogButtonBox.Apply: translate("Paver", "Puts the options into the mesh object; does not mesh"),
                QtGui.QDialogButtonBox.Cancel: translate("Paver", "Drops changes that were not applied, stops a run and "
                                                         "closes")}
        for box in QtGui.QApplication.allWidgets():
            if isinstance(box, QtGui.QDialogButtonBox) and box.standardButtons() == button_set():
                for button, tip in tips.items():
                    box.button(button).setToolTip(tip)

    def clicked(self, button):
        apply = QtGui.QDialogButtonBox.Apply  # which Qt 6 does not take for equal to its number
        if button in (apply, getattr(apply, "value", apply)):
            self.apply()

    def accept(self):
        if not self.apply():
            return False
        self.close()
        return True

    def reject(self):
        run, document, sizes = self.run, self.document, self.sizes
        is_unused = self.is_new and document.UndoCount == self.steps + sizes.steps and not self.obj.MeshFile
        self.forget()
        if not is_unused:
            sizes.drop()
        self.close()
        if run is not None:
            run.stop()
        if is_unused:
            for _ in range(1 + sizes.steps):
                document.undo()
        return True

    def isAllowedAlterSelection(self):
        return True

    def isAllowedAlterView(self):
        return True

    def isAllowedAlterDocument(self):
        return True

    def close(self):
        """Leaves FreeCAD's edit mode, which takes the panel away."""
        self.forget()
        FreeCADGui.getDocument(self.document.Name).resetEdit()
        FreeCADGui.Control.closeDialog()

    def forget(self):
        """Lets go of everything that calls back."""
        global _open
        if self.is_closed:
            return
        self.is_closed = True
        self.predictor.drop()
        self.results.drop()
        run_control.announcer.started.disconnect(self.watch)
        if self.run is not None:
            self.run.ended.disconnect(self.show_end)
            self.runner.leave(self.run)
        FreeCAD.removeDocumentObserver(self.observer)
        if _open is self:
            _open = None


class Observer:
    """Keeps a panel in step with its mesh object; takes it away with the object."""

    def __init__(self, panel):
        self.panel = panel

    def slotDeletedObject(self, obj):
        if obj == self.panel.obj:
            self.vanish()
        elif refinement.is_refinement(obj) and not self.panel.is_closed:
            self.panel.sizes_changed()

    def slotDeletedDocument(self, document):
        if document.Name == self.panel.document_name:
            self.vanish()

    def vanish(self):
        self.panel.forget()
        QtCore.QTimer.singleShot(0, lambda: FreeCADGui.Control.closeDialog())

    def slotChangedObject(self, obj, name):
        panel = self.panel
        if panel.is_closed or mesh_object.is_restoring(obj):
            return
        if name == mesh_object.REFINEMENTS or refinement.is_refinement(obj):
            panel.sizes_changed()
        elif obj != panel.obj:
            return
        elif name == "Status" and panel.run is None:
            panel.predict()
        elif panel.options.show_property(name) or name in mesh_object.LINKS:
            panel.predict()

    def slotUndoDocument(self, document):
        panel = self.panel
        if document.Name == panel.document_name and panel.run is None and not panel.is_closed:
            panel.options.refresh()
            panel.sizes.refresh()
            panel.runner.idle()
            panel.results.refresh()
            panel.predict()

    slotRedoDocument = slotUndoDocument


def show(obj, is_new=False):
    """Opens the panel of a mesh object; False when another panel is open."""
    global _open
    if FreeCADGui.Control.activeDialog():
        FreeCAD.Console.PrintError(translate("Paver", "Another task panel is open; close it first.") + "\n")
        return False
    _open = TaskPanel(obj, is_new)
    FreeCADGui.Control.showDialog(_open)
    QtCore.QTimer.singleShot(0, widen)
    return True


def widen():
    """Makes the dock of the open panel wide enough for it: FreeCAD cuts off what a new profile's has no room for."""
    dock = _open.options if _open is not None else None
    while dock is not None and not isinstance(dock, QtGui.QDockWidget):
        dock = dock.parentWidget()
    if dock is not None and not dock.isFloating():
        wanted = max(part.minimumSizeHint().width() for part in _open.form) + FRAME
        if dock.width() < wanted:
            FreeCADGui.getMainWindow().resizeDocks([dock], [wanted], QtCore.Qt.Horizontal)


def edit_new(obj):
    """Opens the panel of a mesh object that was made for it: Cancel takes the object back.

    Opens it when the command that calls this has ended: FreeCAD would keep its step of undo open for the whole panel.
    """
    global _new
    _new, document, name = obj, obj.Document.Name, obj.Name
    QtCore.QTimer.singleShot(0, lambda: FreeCADGui.getDocument(document).setEdit(name))


def set_edit(obj):
    """What the view provider does when the object is to be edited."""
    global _new
    is_new, _new = _new == obj, None
    problem = core.problem()
    if problem:
        FreeCAD.Console.PrintError(f"{obj.Label}: {problem}\n")
        first_use.show()
    return not problem and show(obj, is_new)


def unset_edit():
    """What it does at the end, whoever asked for that."""
    if _open is not None:
        _open.forget()
        FreeCADGui.Control.closeDialog()
