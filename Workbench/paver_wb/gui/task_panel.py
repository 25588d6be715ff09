"""The task panel of a mesh object.

Options are changed in the fields only. Apply meshes with them, as the button Mesh does, and puts them into the mesh object
together with the mesh, in one step of undo; OK puts them in without meshing and closes. Local sizes are put in at once, each
in a step of its own. Cancel drops what no mesh and no OK has confirmed, local sizes too, stops a run, and takes back a mesh
object that was made for this panel and is unused.
"""
import os

import FreeCADGui
from PySide import QtCore, QtGui

from paver_wb import mesh_object
from paver_wb.base import proxies
from paver_wb.base.paths import ICONS
from paver_wb.children import named_parts
from paver_wb.gui import run_control
from paver_wb.gui.base import edit_panel
from paver_wb.gui.base.steps import call_text, do, in_step, python_name
from paver_wb.gui.base.widgets import translate
from paver_wb.gui.panels import options_box, result_box, run_box, run_predict, sizes_box
from paver_wb.gui.setup import first_use

FRAME = 90  # pixels that FreeCAD puts around a part of a panel, scroll bar included


class TaskPanel(edit_panel.EditPanel):
    """The panel of a mesh object: what ties its parts together."""

    buttons = QtGui.QDialogButtonBox.Ok | QtGui.QDialogButtonBox.Apply | QtGui.QDialogButtonBox.Cancel
    without_core = staticmethod(first_use.show)

    def __init__(self, obj, is_new):
        super().__init__(obj, is_new)
        self.run = None
        self.options = options_box.OptionsBox(obj)
        self.sizes = sizes_box.SizesBox(obj, self.options.target)
        self.runner = run_box.RunBox(obj)
        self.results = result_box.ResultBox(obj)
        self.predictor = run_predict.Predictor(obj)
        self.form = [self.runner, self.options, self.sizes, self.results]
        for part in self.form:
            part.setWindowIcon(QtGui.QIcon(os.path.join(ICONS, "Paver_CreateMesh.svg")))
        self.options.changed.connect(self.edited)
        self.options.more.toggled.connect(lambda _is_open: self.shown())
        self.sizes.failed.connect(self.runner.show_fault)
        self.runner.mesh_asked.connect(self.mesh)
        self.runner.stop_asked.connect(self.stop)
        self.predictor.predicted.connect(self.show_prediction)
        self.predictor.failed.connect(self.show_no_prediction)
        run_control.announcer.started.connect(self.watch)
        self.results.refresh()
        if run_control.run_of(obj):
            self.watch(run_control.run_of(obj))
        self.predict()

    # Predicting

    def edited(self):
        """What kept a run from its end may no longer be so."""
        if self.run is None:
            self.runner.show_fault("")
        self.sizes.show_effects()
        self.predict()

    def predict(self):
        """Tells what the options come to: at once where the mesh has been made with them, else by a prediction."""
        fault = self.options.fault()
        if fault:
            self.predictor.drop()
            self.runner.prediction.setText(fault)
        elif self.obj.Status == mesh_object.UP_TO_DATE and not self.options.changes():
            self.predictor.drop()
            self.runner.prediction.setText(run_box.count_of_mesh(self.obj))
        else:
            self.runner.prediction.setText(translate("Paver", "Predicting..."))
            self.predictor.ask(self.options.changes())
        self.runner.preview.ask(None if fault or self.run else self.options.changes())
        if self.run is None:
            self.runner.show_status(bool(fault or self.changes()))
        self.enable(not fault and self.run is None)

    def sizes_changed(self):
        self.sizes.refresh_soon()
        if self.run is None:
            self.edited()

    def show_prediction(self, prediction):
        self.runner.prediction.setText(run_box.prediction_text(
            prediction, self.options.run_in.value(), self.options.fields["max_elements"].value()))

    def show_no_prediction(self, error):
        self.runner.prediction.setText(options_box.with_labels(str(error)))

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
        run_control.offered.put(*self.predictor.offered())
        do(call_text("start", python_name(self.obj), **changes), "paver_wb.gui.run_control")

    def watch(self, run):
        """Follows a run of the mesh object, also one that a command has started."""
        if not run.is_of(self.obj):
            return
        self.run = run
        run.ended.connect(self.show_end)
        for part in (self.options, self.sizes):
            part.setEnabled(False)
        self.runner.watch(run)
        self.enable(False)

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
                sizes_box.show_in_view(self.obj, True)
            self.results.refresh(outcome.mesh)
            if outcome.place is None:  # else what is wrong is in sight
                self.runner.bring_into_sight(self.results.verdict)
        self.predict()

    def stop(self):
        if self.run is not None:
            self.run.stop()

    # Applying

    def apply(self):
        """Puts the options into the mesh object, without meshing. False when a field has no value."""
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

    def open(self):
        # Not in modifyStandardButtons(): FreeCAD hands out a box there that Python never learns the end of, and takes
        # whatever comes to lie at its place for it.
        tips = {QtGui.QDialogButtonBox.Ok: translate("Paver", "Puts the options into the mesh object, without meshing, and "
                                                     "closes; a run goes on"),
                QtGui.QDialogButtonBox.Apply: translate("Paver", "Meshes with these options, like the button Mesh; the panel "
                                                        "stays open"),
                QtGui.QDialogButtonBox.Cancel: translate("Paver", "Drops changes that were neither meshed with nor confirmed "
                                                         "by OK, stops a run and closes")}
        for box in self.button_boxes():
            for button, tip in tips.items():
                box.button(button).setToolTip(tip)

    def button_boxes(self):
        """FreeCAD's box of OK, Apply and Cancel, where it is there yet."""
        return [box for box in QtGui.QApplication.allWidgets()
                if isinstance(box, QtGui.QDialogButtonBox) and box.standardButtons() == self.buttons]

    def enable(self, may_mesh):
        """The buttons that mesh."""
        self.runner.mesh.setEnabled(may_mesh)
        for box in self.button_boxes():
            box.button(QtGui.QDialogButtonBox.Apply).setEnabled(may_mesh)

    def clicked(self, button):
        apply = QtGui.QDialogButtonBox.Apply  # which Qt 6 does not take for equal to its number
        if button in (apply, getattr(apply, "value", apply)):
            self.mesh()

    def accept(self):
        if not self.apply():
            return False
        self.close()
        return True

    def reject(self):
        run, sizes = self.run, self.sizes
        is_unused = self.is_unused(sizes.steps) and not self.obj.MeshFile
        self.forget()
        if not is_unused:
            sizes.drop()
        self.close()
        if run is not None:
            run.stop()
        if is_unused:
            self.take_back(sizes.steps)
        return True

    def forget(self):
        if not super().forget():
            return
        self.predictor.drop()
        self.results.drop()
        self.runner.follow_log(None)
        self.runner.preview.close_preview()
        run_control.announcer.started.disconnect(self.watch)
        if self.run is not None:
            self.run.ended.disconnect(self.show_end)
            self.runner.leave(self.run)

    def shown(self):
        """When it is on screen, and when it has unfolded more of itself."""
        QtCore.QTimer.singleShot(0, self.widen)

    def widen(self):
        """Makes the dock wide enough for the panel: FreeCAD cuts off what a new profile's has no room for."""
        self.resize_dock(lambda dock: max(part.minimumSizeHint().width() for part in self.form) + FRAME)
        QtCore.QTimer.singleShot(0, lambda: self.resize_dock(self.width_without_scrolling))  # themes have other frames

    def enclosing(self, kind):
        """The next widget around the panel of a kind, or None."""
        found = None if self.is_closed else self.options
        while found is not None and not isinstance(found, kind):
            found = found.parentWidget()
        return found

    def width_without_scrolling(self, dock):
        area = self.enclosing(QtGui.QScrollArea)
        return dock.width() + (area.horizontalScrollBar().maximum() if area is not None else 0)

    def resize_dock(self, wanted):
        """wanted(dock): its least width."""
        dock = self.enclosing(QtGui.QDockWidget)
        if dock is not None and not dock.isFloating() and dock.width() < wanted(dock):
            FreeCADGui.getMainWindow().resizeDocks([dock], [wanted(dock)], QtCore.Qt.Horizontal)

    # What changes in the document

    def slotDeletedObject(self, obj):
        super().slotDeletedObject(obj)
        if proxies.is_child(obj) and not self.is_closed:
            self.sizes_changed()

    def slotChangedObject(self, obj, name):
        if self.is_closed or mesh_object.is_restoring(obj):
            return
        if name in (mesh_object.REFINEMENTS, *named_parts.LINKS) or proxies.is_child(obj):
            self.sizes_changed()
        elif name == "Shape" and obj in mesh_object.sources(self.obj):
            self.edited()
        elif obj != self.obj:
            return
        elif name == "Status":
            self.results.show_verdict()
            if self.run is None:
                self.predict()
        elif self.options.show_property(name) or name in mesh_object.LINKS:
            self.edited()

    def slotUndoDocument(self, document):
        if document.Name == self.document_name and self.run is None and not self.is_closed:
            self.options.refresh_changed()
            self.sizes.refresh()
            self.runner.idle()
            self.results.refresh()
            self.predict()

    slotRedoDocument = slotUndoDocument
