"""Fields for options. Each has `value()`, `set_value(v)` and the signal `changed`, which only the user's edits emit."""
from PySide import QtCore, QtGui

from paver_wb import refinement
from paver_wb.base import units
from paver_wb.base.units import number_text, quantity_text  # noqa: F401, for the parts of the panels
from paver_wb.gui.base.widgets import translate

# Both colours, as themes choose theirs.
BAD = "QLineEdit { color: #ffffff; background-color: #c01c28; selection-color: #c01c28; selection-background-color: #ffffff }"


def parsed(kind, text, unit=None):
    """units.parsed. ValueError, a sentence."""
    try:
        return units.parsed(kind, text, unit)
    except (ValueError, ArithmeticError, SyntaxError):
        raise ValueError(translate("Paver", "'{}' cannot be read; write a number and a unit, such as {}.").format(
            text, units.example(kind))) from None


class QuantityField(QtGui.QLineEdit):
    """A length, frequency or angle with a unit; empty is "not given" where that is allowed. A number without a unit has the
    one that was shown before the edit."""

    changed = QtCore.Signal()

    def __init__(self, kind, may_be_empty=False, empty_text=""):
        super().__init__()
        self.kind, self.may_be_empty, self.stored, self.tip = kind, may_be_empty, None, ""
        self.unit = self.shown_unit()
        self.setPlaceholderText(empty_text)
        self.textEdited.connect(self.read)
        self.editingFinished.connect(self.tidy)

    def set_tip(self, text):
        self.tip = text
        self.setToolTip(text)

    def value(self):
        return self.stored

    def set_value(self, value):
        self.stored = value
        self.mark("")
        self.show_stored()

    def show_stored(self):
        self.unit = self.shown_unit()
        self.setText(self.shown(self.stored))

    def shown_unit(self):
        return units.unit_of(self.kind, self.stored)

    def shown(self, value):
        return quantity_text(self.kind, value)

    def parse(self, text):
        """The value of a text. ValueError, a sentence, when it has none."""
        if not text.strip():
            raise ValueError(translate("Paver", "A value is missing; write one, such as {}.").format(
                units.example(self.kind)))
        return parsed(self.kind, text, self.unit)

    def fault(self):
        """Empty, or the sentence that says why the text is no value."""
        try:
            self.written()
        except ValueError as error:
            return str(error)
        return ""

    def written(self):
        """The value of what the user wrote, None where nothing is. ValueError as in parse."""
        is_empty = self.may_be_empty and not self.text().strip()
        return None if is_empty else self.parse(self.text())

    def read(self):
        fault = self.fault()
        self.mark(fault)
        if not fault:
            self.stored = self.written()
        self.changed.emit()

    def keyPressEvent(self, event):
        """Enter ends an edit here; passed on it would press the panel's OK."""
        if event.key() in (QtCore.Qt.Key_Return, QtCore.Qt.Key_Enter):
            self.tidy()
            self.selectAll()
            event.accept()
        else:
            super().keyPressEvent(event)

    def tidy(self):
        if not self.fault():
            self.show_stored()

    def mark(self, fault):
        self.setStyleSheet(BAD if fault else "")
        self.setToolTip(fault or self.tip)


class NumberField(QuantityField):
    """A number without a unit; `is_whole`: a whole one."""

    def __init__(self, is_whole=False, may_be_empty=False, empty_text=""):
        super().__init__("number", may_be_empty, empty_text)
        self.is_whole = is_whole

    def shown_unit(self):
        return None

    def shown(self, value):
        return "" if value is None else str(value) if self.is_whole else number_text(value)

    def parse(self, text):
        try:
            value = float(text.replace(",", "."))
            if not self.is_whole or value == int(value):
                return int(value) if self.is_whole else value
        except (ValueError, OverflowError):
            pass
        what = translate("Paver", "a whole number") if self.is_whole else translate("Paver", "a number")
        raise ValueError(translate("Paver", "'{}' cannot be read; write {}.").format(text, what))


class ChoiceField(QtGui.QComboBox):
    """One of some texts; `labels` are what users see of `values`."""

    changed = QtCore.Signal()

    def __init__(self, values, labels):
        super().__init__()
        for value, label in zip(values, labels):
            self.addItem(label, value)
        self.activated.connect(lambda _index: self.changed.emit())

    def set_tip(self, text):
        self.setToolTip(text)

    def value(self):
        return self.itemData(self.currentIndex())

    def set_value(self, value):
        if self.findData(value) < 0:  # one that only the property editor offers
            self.addItem(str(value), value)
        self.setCurrentIndex(self.findData(value))

    def fault(self):
        return ""


def by_field(obj):
    """The choice of what gives a refinement its target length."""
    field = ChoiceField(refinement.BY, [translate("Paver", "Length"), translate("Paver", "Medium")])
    field.set_tip(translate("Paver", "A length, or the wavelength in a medium, which needs a frequency"))
    field.set_value(obj.By)
    return field


def effect_text(value, target, medium):
    """Empty, or a sentence that arguments of refinement.set_value change nothing in a mesh with that target_of()."""
    if refinement.has_effect(value, target, medium):
        return ""
    asked = refinement.asked_length(value, target, medium)
    return translate("Paver", "No effect: {} is not below the target length of the mesh, {}.").format(
        units.length_text(asked), units.length_text(target))


def field_for(info):
    """The field for an option of the core's table."""
    may_be_empty = info["default"] == ""
    empty = translate("Paver", "automatic") if may_be_empty else ""
    if info["kind"] == "choice":
        names = {"quad-dominant": translate("Paver", "Quad-dominant"), "all-quad": translate("Paver", "All quads"),
                 "all-triangle": translate("Paver", "All triangles"), "off": translate("Paver", "No"),
                 "auto": translate("Paver", "Automatic"), "one": translate("Paver", "One element across"),
                 "imprint": translate("Paver", "imprint"), "union": translate("Paver", "union"), "none": translate("Paver", "none")}
        labels = [names.get(choice, choice) for choice in info["choices"]]
        if info["name"] == "multilevel":
            labels = [translate("Paver", "{} times as long").format(label) if label.isdigit() else label
                      for label in labels]
        elif info["name"] == "gap":
            labels = [translate("Paver", "{} elements across").format(label.partition(":")[2]) if ":" in label else label
                      for label in labels]
        return ChoiceField(info["choices"], labels)
    if info["kind"] == "flag":
        return ChoiceField([False, True], [translate("Paver", "No"), translate("Paver", "Yes")])
    if info["name"] == "order":
        return ChoiceField([1, 2], [translate("Paver", "1 (straight)"), translate("Paver", "2 (curved)")])
    if info["kind"] in units.UNITS:
        return QuantityField(info["kind"], may_be_empty, empty)
    return NumberField(info["kind"] == "integer", may_be_empty, empty)
