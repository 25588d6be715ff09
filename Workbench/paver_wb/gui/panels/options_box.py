"""The part of the task panel that has the options of a mesh object."""
import re

from PySide import QtCore, QtGui

from paver_wb import core, mesh_object, properties
from paver_wb.base.units import length_text
from paver_wb.base.waves import wavelength
from paver_wb.gui.base.widgets import SPACING, fold_button, named, part_layout, row, stack, translate
from paver_wb.gui.panels import fields

BY_FREQUENCY = ("frequency", "divisions", "eps_r", "mu_r")
SHAPE_OF_ELEMENTS = ("elements", "order")
RUN_IN = "RunIn"


def labels():
    """{option: what users read before its field}; others get their own name."""
    return {"size": translate("Paver", "Target length"), "frequency": translate("Paver", "Frequency"),
            "divisions": translate("Paver", "Elements per \u03bb"), "eps_r": translate("Paver", "Medium \u03b5r"),
            "mu_r": translate("Paver", "\u03bcr"), "max_turn": translate("Paver", "Turn per edge"),
            "aspect": translate("Paver", "Narrower at ridges by"), "gradation": translate("Paver", "Gradation"),
            "tip": translate("Paver", "Finer at tips by"), "grade_edges": translate("Paver", "Finer at edges by"),
            "gap": translate("Paver", "Narrow gaps"),
            "merge": translate("Paver", "Merge edges below"), "merge_width": translate("Paver", "Merge faces below"),
            "chord_error": translate("Paver", "Largest distance"), "max_elements": translate("Paver", "Most elements"),
            "order": translate("Paver", "Order"), "elements": translate("Paver", "Elements"),
            "multilevel": translate("Paver", "Coarse mesh first"), "threads": translate("Paver", "Threads"),
            "ranks": translate("Paver", "MPI processes"), "sew_tolerance": translate("Paver", "Sew gaps up to"),
            "connect": translate("Paver", "Parts that touch"), "strict": translate("Paver", "Clean models only")}


def with_labels(text):
    """A message of the core with the options called as in the panel: 'Most elements' for max_elements."""
    for name, label in labels().items():
        if "_" in name:
            text = re.sub(rf"\b{name}\b", f"'{label}'", text)
    return text


def new_form():
    form = QtGui.QFormLayout(verticalSpacing=SPACING, fieldGrowthPolicy=QtGui.QFormLayout.AllNonFixedFieldsGrow)
    form.setContentsMargins(0, 0, 0, 0)
    return form


class OptionsBox(QtGui.QWidget):
    """Fields for all options of the core's table. `changed`: the user has edited one."""

    changed = QtCore.Signal()

    def __init__(self, obj):
        super().__init__()
        self.obj, self.known = obj, {}  # what the fields showed last, by option
        self.table = {info["name"]: info for info in core.load().options() if info["kind"] not in properties.REPEATED}
        self.fields = {name: fields.field_for(info) for name, info in self.table.items()}
        for name, field in self.fields.items():
            tooltip = properties.tooltip(self.table[name])
            named(field, name).set_tip(translate("App::Property", tooltip))
            field.changed.connect(self.edited)
        for name in ("size", "frequency"):
            self.fields[name].may_be_empty = False
            self.fields[name].setPlaceholderText("")
        self.build()
        self.refresh()

    def build(self):
        layout = part_layout(self, translate("Paver", "Options"))
        form = new_form()
        self.by_length = self.radio("ByLength", labels()["size"], translate("Paver", "Elements of one target length"))
        self.by_frequency = self.radio("ByFrequency", labels()["frequency"],
                                       translate("Paver", "Elements as long as a part of the wavelength"))
        self.wavelength = named(QtGui.QLabel(), "Wavelength", translate("Paver", "Wavelength in the medium, at the frequency"))
        form.addRow(self.by_length, self.fields["size"])
        form.addRow(self.by_frequency, self.fields["frequency"])
        self.add_row(form, "divisions", self.wavelength)
        self.add_row(form, "eps_r", self.label("mu_r"), self.fields["mu_r"])
        form.addRow(QtGui.QFrame(frameShape=QtGui.QFrame.HLine, frameShadow=QtGui.QFrame.Sunken))
        for name in SHAPE_OF_ELEMENTS:
            self.add_row(form, name)
        layout.addLayout(form)
        self.build_more(layout)

    def label(self, name):
        label = QtGui.QLabel(labels().get(name, name.replace("_", " ").capitalize()))
        label.setToolTip(self.fields[name].toolTip())
        return label

    def add_row(self, form, name, *further):
        """A row for an option, with further widgets behind its field."""
        if not further:
            form.addRow(self.label(name), self.fields[name])
            return
        shares = [1 if isinstance(widget, QtGui.QLineEdit) else 0 for widget in further]
        form.addRow(self.label(name), row(self.fields[name], *further, shares=(1, *shares)))

    def build_more(self, layout):
        """The rest, folded up: common meshes do without."""
        self.rest = QtGui.QWidget()
        self.more = fold_button("More", translate("Paver", "More options"), translate(
            "Paver", "Curvature, gradation, limits, sewing, where to mesh"), self.rest.setVisible)
        main = ("size",) + BY_FREQUENCY + SHAPE_OF_ELEMENTS
        form = new_form()
        for name in self.table:
            if name not in main:
                self.add_row(form, name)
        self.run_in_row(form)
        self.rest.setLayout(form)
        self.rest.hide()
        stack(layout, self.more, self.rest)

    def radio(self, name, text, tip):
        button = named(QtGui.QRadioButton(text), name, tip)
        button.clicked.connect(self.switch)
        return button

    def run_in_row(self, layout):
        names = {"Automatic": translate("Paver", "Automatic"), "FreeCAD": translate("Paver", "FreeCAD"),
                 "Own process": translate("Paver", "Own process")}
        self.run_in = fields.ChoiceField(mesh_object.RUN_IN, [names[choice] for choice in mesh_object.RUN_IN])
        named(self.run_in, "RunIn").set_tip(translate(
            "Paver", "In a process of its own a crash cannot harm FreeCAD; automatic: from {} predicted elements on").format(mesh_object.heavy_elements()))
        self.run_in.changed.connect(self.edited)
        layout.addRow(QtGui.QLabel(translate("Paver", "Mesh in")), self.run_in)

    def refresh(self):
        """Shows the mesh object's properties."""
        for name in self.table:
            self.show_option(name)
        self.show_run_in()
        is_by_frequency = self.fields["frequency"].value() is not None
        (self.by_frequency if is_by_frequency else self.by_length).setChecked(True)
        self.link()

    def refresh_changed(self):
        """Shows those that have changed since they were shown, and leaves what the user has typed into the others."""
        for name, info in self.table.items():
            if properties.value_of(self.obj, info) != self.known[name]:
                self.show_property(properties.property_name(name))
        if self.obj.RunIn != self.known[RUN_IN]:
            self.show_run_in()

    def show_option(self, name):
        self.known[name] = properties.value_of(self.obj, self.table[name])
        self.fields[name].set_value(self.known[name])

    def show_run_in(self):
        self.known[RUN_IN] = self.obj.RunIn
        self.run_in.set_value(self.known[RUN_IN])

    def show_property(self, name):
        """Shows one property after a change of it elsewhere; False when it is no option."""
        option = next((option for option in self.table if properties.property_name(option) == name), None)
        if name == RUN_IN:
            self.show_run_in()
        if option is None:
            return name == RUN_IN
        self.show_option(option)
        if option in ("size", "frequency") and self.known[option] is not None:
            (self.by_length if option == "size" else self.by_frequency).setChecked(True)
        self.link()
        return True

    def switch(self):
        """The user has chosen another way to give the size: starts with one that comes to the same."""
        if self.by_frequency.isChecked() and not self.fields["frequency"].value():
            size, divisions = self.fields["size"].value(), self.fields["divisions"].value()
            unit_wavelength = wavelength(1.0, self.fields["eps_r"].value(), self.fields["mu_r"].value())
            if size and divisions and unit_wavelength:
                self.fields["frequency"].set_value(float(fields.number_text(unit_wavelength / (divisions * size))))
        self.edited()

    def edited(self):
        self.link()
        self.changed.emit()

    def link(self):
        """Makes the wavelength, and the length where that follows from the frequency, fit the fields."""
        is_by_frequency = self.by_frequency.isChecked()
        for name in BY_FREQUENCY:
            self.fields[name].setEnabled(is_by_frequency)
        self.fields["size"].setEnabled(not is_by_frequency)
        length = None
        if is_by_frequency and not any(self.fields[name].fault() for name in BY_FREQUENCY):
            length = wavelength(*(self.fields[name].value() for name in ("frequency", "eps_r", "mu_r")))
        text = length_text(length) if length else "\u2013"
        self.wavelength.setText(f"\u03bb = {text}")
        self.wavelength.setVisible(is_by_frequency)
        divisions = self.fields["divisions"].value()
        if is_by_frequency:
            self.fields["size"].set_value(length / divisions if length and divisions else None)

    def fault(self):
        """Empty, or a sentence on the first field that has no value."""
        unused = ("size",) if self.by_frequency.isChecked() else BY_FREQUENCY
        faults = [(name, field.fault()) for name, field in self.fields.items() if name not in unused]
        return next((f"{labels().get(name, name)}: {text}" for name, text in faults if text), "")

    def target(self):
        """refinement.target_of() a mesh with what the fields have."""
        if self.by_length.isChecked():
            return self.fields["size"].value(), None
        medium = [self.fields[name].value() for name in ("eps_r", "mu_r")]
        return self.fields["size"].value(), medium[0] * medium[1] if all(medium) else None

    def values(self):
        """{option: value or None}: what the mesh object has after Apply. Needs fields without a fault."""
        values = {name: field.value() for name, field in self.fields.items()}
        if self.by_frequency.isChecked():
            values["size"] = None
        else:
            values.update({"frequency": None, **{name: properties.value_of(self.obj, self.table[name])
                                                 for name in BY_FREQUENCY[1:]}})
        return values

    def changes(self):
        """{option: value} of values() that differ from the mesh object."""
        return {name: value for name, value in self.values().items()
                if value != properties.value_of(self.obj, self.table[name])}
