"""The statistics of a mesh: a table and histograms, in millimetres and wavelengths."""
from PySide import QtCore, QtGui

from paver_wb import statistics
from paver_wb.base.units import length_text, unit_of
from paver_wb.formats import mesh_file
from paver_wb.gui.base import measuring
from paver_wb.gui.base.histogram import Histogram
from paver_wb.gui.base.widgets import button, named, row, stack, text_label, translate
from paver_wb.gui.panels import fields


class StatisticsPanel(measuring.MeasuringDialog):
    """Stays open beside the window, and follows the mesh. `figures`: those that are shown, None until there are some."""

    figures = base = charts = None

    def __init__(self, obj):
        super().__init__(obj, "StatisticsPanel", translate("Paver", "Statistics of {}").format(obj.Label))
        self.resize(900, 620)

    def build(self):
        self.table = named(QtGui.QTreeWidget(columnCount=3, rootIsDecorated=False, alternatingRowColors=True), "StatisticsTable")
        self.table.setHeaderLabels([translate("Paver", "Figure"), translate("Paver", "Value"),
                                    translate("Paver", "In wavelengths, memory")])
        self.histograms = [Histogram("Paver_Histogram" + name) for name in ("Lengths", "Areas", "SJ")]
        both = QtGui.QHBoxLayout()
        both.addWidget(self.table, 5)
        both.addLayout(stack(QtGui.QVBoxLayout(), *self.histograms), 4)
        self.hints = text_label("StatisticsHints", translate("Paver", "What may trouble a solver"))
        stack(QtGui.QVBoxLayout(self), both, self.hints, self.busy, self.bottom())

    def bottom(self):
        self.frequency = named(fields.QuantityField("frequency", may_be_empty=True, empty_text="\u2013"), "StatisticsFrequency")
        self.frequency.set_tip(translate("Paver", "Frequency for the figures in wavelengths; the mesh stays as it is"))
        wave = statistics.wave_of(self.obj)
        self.frequency.set_value(wave.frequency if wave else None)
        self.frequency.changed.connect(self.show_figures)
        self.note = QtGui.QLabel()
        return row(QtGui.QLabel(translate("Paver", "Frequency")), self.frequency, self.note,
                   button("StatisticsCopy", translate("Paver", "Copy table"), "", self.copy), self.close_button(),
                   shares=(0, 0, 1, 0, 0))

    def refresh(self):
        """Measures the mesh again, on a thread."""
        path, label = self.obj.MeshFile, self.obj.Label

        def work():
            figures = statistics.of_mesh(mesh_file.read(path), label)
            return figures, statistics.charts(figures)
        self.measure(work)

    def show_measured(self, measured):
        self.base, self.charts = measured
        self.show_figures()

    def show_fault(self, text):
        self.note.setText(text)

    def show_figures(self):
        if self.base is None:
            return
        frequency = self.frequency.value() or 0
        wave = statistics.wave_at(frequency, self.obj.EpsR, self.obj.MuR) if frequency > 0 else None
        self.figures = self.base._replace(wave=wave)
        self.note.setText(f"λ = {length_text(wave.length)}" if wave else translate(
            "Paver", "Give a frequency to see wavelengths"))
        self.fill_table()
        hints = statistics.hints(self.figures)
        self.hints.setText("\n".join("\u26a0 " + hint for hint in hints))
        self.hints.setVisible(bool(hints))
        self.draw(wave)

    def unit(self):
        """Of lengths: the user's, for the target length."""
        return unit_of("length", self.figures.target)

    def fill_table(self):
        self.table.clear()
        group = None
        for entry in statistics.rows(self.figures, self.unit()):
            if group is None or group.text(0) != entry.group:
                group = QtGui.QTreeWidgetItem(self.table, [entry.group])
                bold = group.font(0)
                bold.setBold(True)
                group.setFont(0, bold)
            item = QtGui.QTreeWidgetItem(group, [entry.name, entry.value, entry.in_waves])
            for column in (1, 2):
                item.setTextAlignment(column, QtCore.Qt.AlignRight | QtCore.Qt.AlignVCenter)
        self.table.expandAll()
        for column in range(3):
            self.table.resizeColumnToContents(column)
        room = 2 * self.table.frameWidth() + self.table.verticalScrollBar().sizeHint().width()
        self.table.setMinimumWidth(self.table.header().length() + room)  # words are longer in other languages

    def draw(self, wave):
        figures, (lengths, areas, sj), unit = self.figures, self.histograms, self.unit()
        long = wave.length if wave else unit.size
        counts, limits = self.charts.lengths
        lengths.show_counts(translate("Paver", "Edge lengths"), counts, limits / long, "λ" if wave else unit.name,
                            figures.target / long if figures.target else None)
        counts, limits = self.charts.areas
        areas.show_counts(translate("Paver", "Element areas"), counts, limits / long ** 2, "λ²" if wave else unit.name + "²")
        sj.show_counts(translate("Paver", "Scaled Jacobian"), *self.charts.sj, "")

    def copy(self):
        """Into the clipboard. Through a text field: a wrapper of QClipboard makes FreeCAD crash when it ends."""
        if self.figures is None:
            return
        field = QtGui.QPlainTextEdit(statistics.text(self.figures, self.unit()))
        field.selectAll()
        field.copy()


def show(obj):
    """Opens the statistics of a mesh object, or brings them to the front. ValueError when it is not meshed."""
    return measuring.show(StatisticsPanel, obj)
