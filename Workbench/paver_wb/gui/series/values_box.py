"""What a series varies, its values, and what becomes of the meshes: the fields above the table."""
from PySide import QtCore, QtGui

from paver_wb import export_mesh, preferences, properties, series
from paver_wb.base import proxies
from paver_wb.gui.base.widgets import button, named, row, translate
from paver_wb.gui.panels import fields

KINDS = {series.FREQUENCY: "frequency", series.SIZE: "length"}
MOST_IN_RANGE = 50
RANGE_WIDTH = 110


def parsed(option, text):
    """Number of what the user wrote. ValueError, in one sentence."""
    if option in KINDS:
        return fields.parsed(KINDS[option], text)
    return fields.NumberField().parse(text)


def texts_of(text):
    """Its values: between semicolons where there are some, as commas may be decimal ones; else between commas."""
    return [part.strip() for part in text.split(";" if ";" in text else ",") if part.strip()]


def shown(option, value):
    return fields.quantity_text(KINDS[option], value) if option in KINDS else fields.number_text(value)


def python_value(option, value):
    """As text where that says the same, for the console."""
    text = shown(option, value)
    return text if option in KINDS and text.isascii() and parsed(option, text) == value else value


def first_values(mesh, option):
    """A series to begin with, about what the mesh object has."""
    if option == series.DIVISIONS:
        return [6, 8, 10, 14]
    given = properties.given(mesh).get(option)
    if given is None:
        given = 1e9 if option == series.FREQUENCY else preferences.first_size(proxies.sources(mesh), preferences.FACETS_ALONG)
    return sorted(float(f"{given * factor:.4g}") for factor in (0.5, 1, 2))


class ValuesBox(QtGui.QWidget):
    """`arguments()`: those of series.add for what is in the fields. `failed`: a sentence on what could not be done."""

    failed = QtCore.Signal(str)

    def __init__(self, mesh):
        super().__init__()
        self.mesh = mesh
        form = QtGui.QFormLayout(self, fieldGrowthPolicy=QtGui.QFormLayout.AllNonFixedFieldsGrow)
        form.setContentsMargins(0, 0, 0, 0)
        names = [translate("Paver", "Frequency"), translate("Paver", "Elements per \u03bb"), translate("Paver", "Target length")]
        self.option = named(fields.ChoiceField(series.VARIED, names), "SeriesOption",
                            translate("Paver", "What differs from mesh to mesh; all else is as in the mesh object"))
        self.values = named(QtGui.QLineEdit(), "SeriesValues", translate(
            "Paver", "Values with commas between them, or semicolons, such as 1 GHz, 2 GHz, 4 GHz"))
        form.addRow(translate("Paver", "Vary"), row(self.option, self.values, shares=(0, 1)))
        form.addRow(translate("Paver", "Range"), self.range_row())
        form.addRow(translate("Paver", "Results"), self.result_row())
        self.option.changed.connect(self.begin)
        self.option.set_value(series.FREQUENCY if mesh.Frequency.Value > 0 else series.SIZE)
        self.begin()

    def range_row(self):
        self.first, self.last = (named(QtGui.QLineEdit(maximumWidth=RANGE_WIDTH), "Series" + name) for name in ("First", "Last"))
        self.count = named(QtGui.QSpinBox(minimum=2, maximum=MOST_IN_RANGE, value=5), "SeriesCount", translate(
            "Paver", "How many values"))
        self.how = named(fields.ChoiceField(series.SPREADS, [translate("Paver", "evenly"), translate("Paver", "logarithmic")]),
                         "SeriesSpread", translate("Paver", "By equal steps, or by equal factors"))
        self.fill_in = button("SeriesFillIn", translate("Paver", "Fill in"),
                              translate("Paver", "Writes the values of the range into the field above"), self.fill)
        self.fill_in.setAutoDefault(False)
        return row(self.first, QtGui.QLabel("\u2013"), self.last, QtGui.QLabel(translate("Paver", "values")), self.count,
                   self.how, self.fill_in, None)

    def result_row(self):
        self.kept = named(QtGui.QRadioButton(translate("Paver", "Meshes in the document")), "SeriesKept", translate(
            "Paver", "A mesh object for each value, below the series in the tree"))
        self.as_files = named(QtGui.QRadioButton(translate("Paver", "Files only")), "SeriesFiles", translate(
            "Paver", "A file for each value and format, and the table as CSV, in the folder; nothing large in the document"))
        self.kept.setChecked(True)
        names = {**export_mesh.OWN, **export_mesh.FEM}
        self.formats = {ending: named(QtGui.QCheckBox(ending), "SeriesFormat_" + ending, translate(
            "Paver", names[ending])) for ending in series.FORMATS}
        self.formats["msh"].setChecked(True)
        self.folder = named(QtGui.QLineEdit(preferences.parameters().GetString(preferences.LAST_FOLDER, "")),
                            "SeriesFolder", translate("Paver", "Where the files are written"))
        self.folder.setPlaceholderText(translate("Paver", "Folder"))
        self.browse = button("SeriesBrowse", "\u2026", translate("Paver", "Chooses the folder"), self.choose_folder)
        self.browse.setMaximumWidth(36)
        self.browse.setAutoDefault(False)
        self.of_files = [*self.formats.values(), self.folder, self.browse]
        self.as_files.toggled.connect(self.link)
        self.link(False)
        return row(self.kept, self.as_files, *self.formats.values(), self.folder, self.browse,
                   shares=(0, 0, *[0] * len(self.formats), 1, 0))

    @QtCore.Slot(bool)
    def link(self, is_files):
        for widget in self.of_files:
            widget.setEnabled(is_files)

    def begin(self):
        """Values to begin with, for what is chosen."""
        option = self.option.value()
        start = first_values(self.mesh, option)
        self.values.setText(", ".join(shown(option, value) for value in start))
        self.first.setText(shown(option, start[0]))
        self.last.setText(shown(option, start[-1]))

    def fill(self):
        """Writes the values of the range into the field above."""
        option = self.option.value()
        try:
            values = series.spread(parsed(option, self.first.text()), parsed(option, self.last.text()), self.count.value(),
                                   self.how.value())
        except ValueError as error:
            self.failed.emit(str(error))
            return
        self.values.setText("; ".join(shown(option, value) for value in values))

    def choose_folder(self):
        chosen = QtGui.QFileDialog.getExistingDirectory(self, translate("Paver", "Folder"), self.folder.text())
        if chosen:
            self.folder.setText(chosen)

    def arguments(self):
        """ValueError, in one sentence, where a field has no value."""
        option = self.option.value()
        values = [parsed(option, text) for text in texts_of(self.values.text())]
        if not values:
            raise ValueError(translate("Paver", "A series needs values; write some, such as 1 GHz, 2 GHz, 4 GHz."))
        made = {series.ARGUMENTS[option]: [python_value(option, value) for value in values]}
        if self.as_files.isChecked():
            endings = [ending for ending, box in self.formats.items() if box.isChecked()]
            if not endings:
                raise ValueError(translate("Paver", "No format is chosen for the files; choose one, or keep the meshes in "
                                           "the document."))
            made.update(formats=endings, folder=self.folder.text())
        return made

    def show_series(self, obj):
        """What a series was made with."""
        self.option.set_value(obj.Varied)
        self.begin()
        self.values.setText("; ".join(shown(obj.Varied, value) for value in obj.Values))
        (self.as_files if obj.Formats else self.kept).setChecked(True)
        if obj.Formats:
            self.folder.setText(obj.Folder)
            for ending, box in self.formats.items():
                box.setChecked(ending in obj.Formats)
