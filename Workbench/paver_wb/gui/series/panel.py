"""The dialog of series: what to vary, and the table that fills while the steps are meshed."""
import os

from PySide import QtCore, QtGui

from paver_wb import mesh_check, mesh_object, series, statistics
from paver_wb.gui.base import measuring, verdict
from paver_wb.gui.base.steps import call_text, do, python_name
from paver_wb.gui.base.widgets import FaultBox, button, named, row, stack, timer, translate
from paver_wb.gui.series import run as series_run
from paver_wb.gui.series.values_box import ValuesBox, shown

STEP, ELEMENTS, UNKNOWNS, MATRIX, TIME, SJ, VERDICT = range(7)
ROOM = 8  # pixels between columns


def headers():
    return [translate("Paver", "Step"), translate("Paver", "Elements"), translate("Paver", "Unknowns"),
            translate("Paver", "Full matrix"), translate("Paver", "Time"), translate("Paver", "Least SJ"),
            translate("Paver", "Verdict")]


def header_tips():
    return ["", translate("Paver", "Quads and triangles"),
            translate("Paver", "Of an electric-field integral equation on a conductor, with rooftops and RWG functions"),
            translate("Paver", "Memory of the matrix of all these unknowns, in double precision"),
            translate("Paver", "Of meshing"), translate("Paver", "Smallest scaled Jacobian of all elements"),
            translate("Paver", "What Check mesh finds, the worst first")]


def figures_of(found):
    """Texts of a Row's columns, ELEMENTS to SJ; empty where nothing is meshed."""
    if found is None or not found.is_meshed:
        return [""] * 5
    return [statistics.number(found.elements), statistics.number(found.unknowns), statistics.memory(found.matrix_bytes),
            f"{found.seconds:.2f} s", f"{found.least_sj:.3f}"]


def verdict_of(found):
    """(text, level) of a Row."""
    if found.error:
        return found.error, mesh_check.ERROR
    return found.reason, found.verdict


class SeriesDialog(measuring.BesideDialog):
    """Stays open beside the window. `series`: the one that the table shows, or None."""

    def __init__(self, mesh, obj):
        super().__init__(mesh or obj, "SeriesDialog", translate("Paver", "Series of {}").format((mesh or obj).Label))
        self.mesh, self.series, self.run = mesh, None, None
        self.resize(860, 460)
        self.build()
        self.refreshing = timer(self, self.refresh)
        series_run.announcer.started.connect(self.watch)
        self.show_series(obj)

    def build(self):
        self.box = ValuesBox(self.mesh) if self.mesh else None
        self.fault = FaultBox()
        if self.box:
            self.box.failed.connect(self.fault.tell)
        stack(QtGui.QVBoxLayout(self), *filter(None, [self.box]), self.fault, self.new_table(), self.bottom())
        self.fault.tell("")

    def new_table(self):
        self.table = named(QtGui.QTableWidget(
            0, len(headers()), wordWrap=False, showGrid=False, alternatingRowColors=True,
            selectionBehavior=QtGui.QAbstractItemView.SelectRows, selectionMode=QtGui.QAbstractItemView.SingleSelection,
            editTriggers=QtGui.QAbstractItemView.NoEditTriggers), "SeriesTable", translate("Paver", "Click on a row to see its mesh"))
        self.table.setHorizontalHeaderLabels(headers())
        for column, tip in enumerate(header_tips()):
            self.table.horizontalHeaderItem(column).setToolTip(tip)
        self.table.horizontalHeader().setStretchLastSection(True)
        self.table.horizontalHeader().setHighlightSections(False)
        self.table.horizontalHeaderItem(VERDICT).setTextAlignment(QtCore.Qt.AlignLeft | QtCore.Qt.AlignVCenter)
        self.table.verticalHeader().hide()
        self.table.cellClicked.connect(self.show_step)
        return self.table

    def bottom(self):
        self.run_button = button("SeriesRun", translate("Paver", "Run"), translate(
            "Paver", "Meshes a new series with these values, one step after the other; FreeCAD can be used meanwhile"),
            self.start)
        self.more = button("SeriesContinue", translate("Paver", "Continue"), translate(
            "Paver", "Meshes the steps of this series that have not been done, and those of before a change"), self.go_on)
        self.stop_button = button("SeriesStop", translate("Paver", "Stop"), translate(
            "Paver", "Stops within a second; what is done stays"), self.stop)
        self.save = button("SeriesSave", translate("Paver", "Save table..."), translate(
            "Paver", "Writes the table to a file, as CSV"), self.choose_file)
        self.close_button = button("SeriesClose", translate("Paver", "Close"), translate(
            "Paver", "A series that runs goes on"), self.close)
        for made in (self.run_button, self.more, self.stop_button, self.save, self.close_button):
            made.setAutoDefault(False)
        return row(self.run_button, self.more, self.stop_button, None, self.save, self.close_button)

    # What the buttons do

    def attempt(self, line, module="paver_wb.gui.series.run"):
        """Runs a line of Python as the console would; what goes wrong is told here."""
        self.fault.tell("")
        try:
            do(line, module)
        except Exception as error:
            self.fault.tell(str(error))

    def start(self):
        try:
            arguments = self.box.arguments()
        except ValueError as error:
            self.fault.tell(str(error))
            return
        self.attempt(call_text("start", python_name(self.mesh), **arguments))

    def go_on(self):
        self.attempt(f"go_on({python_name(self.series)})")

    def stop(self):
        if self.run:
            self.run.stop()

    def show_step(self, number, _column=0):
        found = series.rows_of(self.series)[number]
        self.fault.tell(found.error if found else "")
        if series.mesh_of(self.series, number) and found and found.is_meshed:
            self.attempt(f"show({python_name(self.series)}, {number})")

    def choose_file(self):
        start = os.path.join(self.series.Folder, self.series.Label + ".csv")
        path, _ = QtGui.QFileDialog.getSaveFileName(self, translate("Paver", "Save table"), start, "CSV (*.csv)")
        if path:
            self.attempt(f"write_csv({python_name(self.series)}, {path!r})", "paver_wb.series")

    # What it shows

    def show_series(self, obj):
        """Fills the table from a series, or empties it."""
        self.series = obj
        if obj is not None and self.box:
            self.box.show_series(obj)
        if obj is not None and series_run.run_of(obj):
            self.watch(series_run.run_of(obj))
        self.refresh()

    def watch(self, run):
        """Follows a series of the mesh object, also one that the console has started."""
        if self.run is run or run.document != self.document or (run.obj.Mesh != self.mesh and run.obj != self.series):
            return
        self.series, self.run = run.obj, run
        run.told.connect(self.refresh_soon)
        run.ended.connect(self.run_ended)
        self.refresh_soon()

    def run_ended(self):
        self.run = None
        self.refresh_soon()

    def refresh_soon(self):
        """When what is going on in the document is over."""
        self.refreshing.start()

    @QtCore.Slot()
    def refresh(self):
        steps = rows = ()
        try:
            if self.series is not None:
                steps, rows = series.steps_of(self.series), series.rows_of(self.series)
        except (ReferenceError, RuntimeError):
            self.series = None
        self.table.setRowCount(len(steps))
        for step, found in zip(steps, rows):
            self.fill_row(step, found)
        for column in range(VERDICT):
            self.table.resizeColumnToContents(column)
            self.table.setColumnWidth(column, self.table.columnWidth(column) + ROOM)
        is_running = self.run is not None
        self.run_button.setEnabled(not is_running and self.box is not None)
        self.more.setEnabled(not is_running and self.series is not None and bool(series.steps_to_do(self.series)))
        self.stop_button.setEnabled(is_running)
        self.save.setEnabled(any(rows))

    def fill_row(self, step, found):
        text, level = verdict_of(found) if found else (self.run.state(step.number) if self.run else "", None)
        if found is None and not text:
            text = translate("Paver", "Not done")
        for column, content in enumerate([shown(step.option, step.value), *figures_of(found), text]):
            item = QtGui.QTableWidgetItem(content)
            if column != VERDICT:
                item.setTextAlignment(QtCore.Qt.AlignRight | QtCore.Qt.AlignVCenter)
            else:
                item.setToolTip("\n".join([text, *(found.files if found else ())]))
                if level:
                    item.setIcon(verdict.sign(level))
            self.table.setItem(step.number, column, item)

    # What FreeCAD calls

    def slotChangedObject(self, obj, name):
        is_shown = self.series is not None and self.run is None and not mesh_object.is_restoring(obj)
        if name == series.ROWS and obj == self.series or is_shown and self.is_about(obj, name):
            self.refresh_soon()

    def is_about(self, obj, name):
        """Whether rows may be of before after a change of a property."""
        mesh = self.series.Mesh
        return name == "Status" and obj in self.series.Meshes or mesh is not None and (
            obj == mesh or name == "Shape" and obj in mesh_object.parts_of(mesh))

    def slotDeletedObject(self, obj):
        if obj == self.series:
            self.series = None
            self.refresh_soon()
        if obj == self.mesh or (self.mesh is None and self.series is None):
            self.close()

    def leave(self, result):
        super().leave(result)
        series_run.announcer.started.disconnect(self.watch)
        self.refreshing.stop()
        if self.run:
            self.run.told.disconnect(self.refresh_soon)
            self.run.ended.disconnect(self.run_ended)


def show(obj):
    """Opens the dialog of a series, or of a mesh object, with its last series, or brings it to the front."""
    mesh = obj.Mesh if series.is_series(obj) else obj
    if obj == mesh:
        known = [made for made in series.of_document(obj.Document) if made.Mesh == mesh]
        obj = known[-1] if known else None
    dialog = measuring.opened(SeriesDialog, mesh or obj)
    if dialog and obj is not None and dialog.run is None:
        dialog.show_series(obj)
    return measuring.front(dialog or SeriesDialog(mesh, obj))
