"""The part of the task panel that shows figures of the mesh."""
from PySide import QtCore, QtGui

from paver_wb import mesh_check, statistics
from paver_wb.base.units import length_text, lengths_text
from paver_wb.formats import mesh_file
from paver_wb.gui.base import run_status, verdict
from paver_wb.gui.base.background import Latest
from paver_wb.gui.base.steps import do, python_name
from paver_wb.gui.base.widgets import named, part_layout, stack, text_label, translate
from paver_wb.statistics import number

NAME, VALUE = range(2)  # columns: where there is no room for both, names are cut and figures are not
NARROWEST = 60  # pixels of a column


def figures(mesh, measured):
    """[(name, value, tooltip)] of a StoredMesh and its statistics.Figures."""
    quality, report, lengths = mesh.report["quality"], mesh.report, measured.lengths
    sj = quality["sj"]["all"]
    count = len(mesh.quads) + len(mesh.triangles)
    rows = [
        (translate("Paver", "Elements"), number(count), translate("Paver", "Quads and triangles")),
        (translate("Paver", "Quads"), number(len(mesh.quads)), translate("Paver", "Elements with four sides")),
        (translate("Paver", "Triangles"), number(len(mesh.triangles)), translate("Paver", "Elements with three sides")),
        (translate("Paver", "Nodes"), number(len(mesh.nodes)), translate("Paver", "Of all orders")),
        (translate("Paver", "Scaled Jacobian"), translate("Paver", "min {}, mean {}").format(
            f"{sj['min']:.3f}", f"{sj['mean']:.3f}"),
         translate("Paver", "Smallest and mean; 1 is a square or an equilateral triangle, 0 a degenerate element")),
        (translate("Paver", "Edge length"), lengths_text([lengths.min(), lengths.max()], " \u2013 "),
         translate("Paver", "Shortest and longest element edge, end to end")),
        (translate("Paver", "Mean edge"), length_text(lengths.mean()), translate("Paver", "Mean length of the element edges")),
        (translate("Paver", "Target length"), length_text(report["target_length"]), translate("Paver", "Away from bends and local sizes")),
        (translate("Paver", "Edges 0.7\u20131.4 target"), percent_text(quality.get("length_in_band")),
         translate("Paver", "Edges between 0.7 and 1.4 of the length wanted there")),
        (translate("Paver", "Irregular nodes"), percent_text(quality.get("irregular_share")),
         translate("Paver", "Nodes inside faces where not four quads meet")),
        (translate("Paver", "Watertight"), translate("Paver", "yes") if quality["watertight"] else translate(
            "Paver", "no, {} free edges").format(number(quality.get("border_edges", int((measured.users == 1).sum())))),
         translate("Paver", "Whether every mesh edge lies in exactly two elements")),
    ]
    return [row for row in rows if row[VALUE]] + wires(mesh) + parts(report) + times(report)


def percent_text(share):
    """Empty where it is not known, as of an imported mesh."""
    return "" if share is None else f"{100 * share:.1f} %"


def wires(mesh):
    """A row for lines of wires; none without them."""
    lines = mesh_file.wires(mesh)
    if not lines:
        return []
    return [(translate("Paver", "Lines of wires"), number(sum(map(len, lines.values()))),
             translate("Paver", "Line elements of edges that bound no face"))]


def parts(report):
    """A row for what touches and how many meshes come of it; none for a single part."""
    contacts, meshes = mesh_check.touching(report), report.get("components", [])
    if not contacts and len(meshes) < 2:
        return []
    return [(translate("Paver", "Contacts"), translate("Paver", "{}; separate meshes: {}").format(
        number(len(contacts)), number(len(meshes))),
        translate("Paver", "Pairs of parts that touch or cross, and how many meshes share no node"))]


def times(report):
    """Rows for the stages that took a share of the time worth telling."""
    seconds = report.get("stage_seconds")
    if not seconds:
        return []
    total = sum(seconds.values())
    rows = [(translate("Paver", "Time"), f"{total:.2f} s", translate("Paver", "Of all stages"))]
    return rows + [("    " + run_status.stage_text(stage), f"{spent:.2f} s",
                    translate("Paver", "Time of this stage")) for stage, spent in seconds.items()
                   if spent >= 0.01 * total]


def looked_at(mesh):
    """(figures, findings) of a StoredMesh."""
    measured = statistics.of_mesh(mesh)
    return figures(mesh, measured), mesh_check.of_mesh(mesh, measured)


class ResultBox(QtGui.QWidget):
    """What a check of a mesh comes to, and a table of its figures. They are worked out on a thread: large meshes take a
    while to read. `found`: the findings in the mesh, None until there are some."""

    def __init__(self, obj):
        super().__init__()
        self.obj, self.latest, self.found = obj, Latest(self.show_figures, self.show_error), None
        self.verdict = verdict.VerdictLine(self.show_details)
        self.text = text_label("ResultText", translate("Paver", "What keeps figures or faces from being here"))
        self.table = named(QtGui.QTableWidget(
            0, 2, wordWrap=False, showGrid=False, alternatingRowColors=True, editTriggers=QtGui.QAbstractItemView.NoEditTriggers,
            horizontalScrollBarPolicy=QtCore.Qt.ScrollBarAlwaysOff, verticalScrollBarPolicy=QtCore.Qt.ScrollBarAlwaysOff),
            "Result", translate("Paver", "Figures of the mesh that the object has"))
        self.table.horizontalHeader().hide()
        self.table.verticalHeader().hide()
        for column, mode in ((NAME, QtGui.QHeaderView.Stretch), (VALUE, QtGui.QHeaderView.ResizeToContents)):
            self.table.horizontalHeader().setSectionResizeMode(column, mode)
        self.table.horizontalHeader().setMinimumSectionSize(NARROWEST)
        stack(part_layout(self, translate("Paver", "Result")), self.verdict, self.text, self.table)

    def refresh(self, mesh=None):
        """Shows the mesh that the object has now; `mesh`: the StoredMesh, where it is at hand."""
        path = self.obj.MeshFile
        self.drop()
        self.found = None
        if not path:
            self.fill([])
            self.verdict.tell([])
            self.text.setText(translate("Paver", "Nothing is meshed yet."))
            return
        self.verdict.tell_busy()
        self.latest.ask(lambda _cancel: looked_at(mesh or mesh_file.read(path)))

    def drop(self):
        """Forgets figures that are being worked out."""
        self.latest.drop()

    def show_figures(self, looked):
        rows, self.found = looked
        self.fill(rows)
        self.show_verdict()

    def show_verdict(self):
        """Also when only the mesh object's state has changed."""
        if self.found is not None:
            self.verdict.tell(mesh_check.in_order(mesh_check.of_document(self.obj, looks=False) + self.found))

    def show_details(self):
        do(f"show({python_name(self.obj)})", "paver_wb.gui.check_panel")

    def show_error(self, error):
        self.fill([])
        self.verdict.tell([mesh_check.Finding(mesh_check.ERROR, str(error))])
        self.text.hide()

    def fill(self, rows):
        self.text.setVisible(not rows)
        self.table.setVisible(bool(rows))
        self.table.setRowCount(len(rows))
        for at, (name, value, tip) in enumerate(rows):
            for column, text in enumerate((name, value)):
                item = QtGui.QTableWidgetItem(text)
                item.setToolTip(f"{name}: {tip}")
                self.table.setItem(at, column, item)
        self.table.resizeColumnToContents(VALUE)
        self.table.resizeRowsToContents()
        height = sum(self.table.rowHeight(i) for i in range(len(rows))) + 2 * self.table.frameWidth()
        self.table.setFixedHeight(height)
