"""The part of the task panel that has the local sizes: the refinements of a mesh object.

They are objects of their own: what is done here is done at once, each in a step of undo. drop() brings back what there was
when the panel was opened or its options were last put into effect.
"""
import FreeCADGui
from PySide import QtCore, QtGui

from paver_wb import refinement
from paver_wb.base.units import example, unit_of
from paver_wb.gui.base.steps import call_text, do, in_step, python_name, references_text
from paver_wb.gui.base.widgets import button, named, part_layout, row, stack, text_label, timer, translate
from paver_wb.gui.display import selection
from paver_wb.gui.panels import fields

WHERE, BY, VALUE = range(3)
MOST_ROWS = 5  # that are seen without scrolling
VALUE_WIDTH = 70


def where_text(obj):
    """"Face1, Face3 of Box" of a refinement; what the column has no room for is the object."""
    texts = []
    for thing, elements in obj.References:
        names = ", ".join(filter(None, elements)) or translate("Paver", "all")
        texts.append(translate("Paver", "{} of {}").format(names, thing.Label))
    return "; ".join(texts)


def value_text(obj):
    if obj.By == refinement.LENGTH:
        return fields.quantity_text("length", obj.Length.Value)
    return f"{fields.number_text(obj.EpsR)}, {fields.number_text(obj.MuR)}"


def value_of(obj, text):
    """Arguments of refinement.set_value for what the user wrote. ValueError, in one sentence."""
    if obj.By == refinement.LENGTH:
        return {"length": fields.parsed("length", text, unit_of("length", obj.Length.Value))}
    try:
        numbers = [float(number) for number in text.replace(";", ",").split(",")]
        if len(numbers) > 2 or min(numbers) <= 0:
            raise ValueError
    except ValueError:
        raise ValueError(translate("Paver", "'{}' is no medium; write its \u03b5r, or \u03b5r and \u03bcr, such as 4, 1."
                                   ).format(text)) from None
    return {"eps_r": numbers[0], "mu_r": numbers[1] if len(numbers) > 1 else 1.0}


def as_arguments(obj):
    """(references as text for Python, {argument: value}) of a refinement, for refinement.change."""
    return references_text(obj.References), refinement.value_of(obj)


def show_in_view(obj, shows_mesh):
    """One of mesh and model: together they lie in each other. No step of undo, as always with what is seen."""
    if obj:
        do(f"show({python_name(obj)}, mesh={shows_mesh})", "paver_wb.gui.run_place")


def view_buttons(name, mesh):
    """Buttons that show the model of a mesh object, whose faces can be selected, or the mesh. mesh(): the object, or None."""
    return (button(name + "Model", translate("Paver", "Show model"), translate(
        "Paver", "Shows what is meshed, to select from it"), lambda: show_in_view(mesh(), False)),
        button(name + "Mesh", translate("Paver", "Show mesh"), translate("Paver", "Shows the mesh"),
               lambda: show_in_view(mesh(), True)))


class SizesBox(QtGui.QWidget):
    """`steps`: how many steps of undo were made here. `failed`: a sentence on what could not be done. target(): the mesh's
    refinement.target_of(), as it will be."""

    failed = QtCore.Signal(str)

    def __init__(self, obj, target=None):
        super().__init__()
        self.obj, self.shown, self.steps = obj, [], 0
        self.target = target or (lambda: refinement.target_of(obj))
        self.settle()
        self.table = named(QtGui.QTableWidget(0, 3, selectionBehavior=QtGui.QAbstractItemView.SelectRows), "Sizes", translate(
            "Paver", "Target lengths of parts of the model; elements grow from there on"))
        self.table.setHorizontalHeaderLabels([translate("Paver", "Where"), translate("Paver", "By"),
                                              translate("Paver", "Value")])
        self.table.horizontalHeader().setSectionResizeMode(WHERE, QtGui.QHeaderView.Stretch)
        self.table.setColumnWidth(VALUE, VALUE_WIDTH)
        self.table.verticalHeader().hide()
        self.table.itemChanged.connect(self.edited)
        self.table.itemSelectionChanged.connect(self.show_chosen)
        self.add = button("AddSize", translate("Paver", "Add from selection"), translate(
            "Paver", "A shorter length on the faces, edges, vertices or objects that are selected in the 3D view, "
            "or on the faces under selected elements"),
            self.add_selected)
        self.remove = button("RemoveSize", translate("Paver", "Remove"),
                             translate("Paver", "Deletes the chosen local sizes"), self.remove_chosen)
        self.note = text_label("SizesNote", translate("Paver", "Local sizes that are not shorter than the rest"))
        stack(part_layout(self, translate("Paver", "Local sizes")), self.table, self.note,
              row(self.add, self.remove, shares=(2, 1)), row(*view_buttons("View", lambda: self.obj), shares=(1, 1)))
        self.timer = timer(self, self.refresh)
        self.refresh()

    def refresh_soon(self):
        """When what is going on in the document is over."""
        self.timer.start()

    @QtCore.Slot()
    def refresh(self):
        self.shown = refinement.of_mesh(self.obj)
        self.table.blockSignals(True)
        self.table.setRowCount(len(self.shown))
        for number, obj in enumerate(self.shown):
            self.fill_row(number, obj)
        self.table.resizeColumnToContents(BY)
        self.table.blockSignals(False)
        self.table.setVisible(bool(self.shown))
        self.remove.setVisible(bool(self.shown))
        height = sum(self.table.rowHeight(i) for i in range(min(len(self.shown), MOST_ROWS)))
        self.table.setFixedHeight(height + self.table.horizontalHeader().sizeHint().height() + 4)
        self.show_effects()

    def show_effects(self):
        """Says which local sizes change nothing, which the mesh's target length decides too."""
        self.table.blockSignals(True)
        notes = []
        for number, obj in enumerate(self.shown):
            text = fields.effect_text(refinement.value_of(obj), *self.target())
            for item in (self.table.item(number, WHERE), self.table.item(number, VALUE)):
                font = item.font()
                font.setStrikeOut(bool(text))
                item.setFont(font)
            if text:
                notes.append(f"{where_text(obj)}: {text}")
        self.note.setText("\n".join(notes))
        self.note.setVisible(bool(notes))
        self.table.blockSignals(False)

    def fill_row(self, number, obj):
        where = QtGui.QTableWidgetItem(where_text(obj))
        where.setFlags(where.flags() & ~QtCore.Qt.ItemIsEditable)
        where.setToolTip(f"{obj.Label}: {where_text(obj)}")
        value = QtGui.QTableWidgetItem(value_text(obj))
        value.setToolTip(translate("Paver", "Target length there, such as {}").format(example("length")) if obj.By == refinement.LENGTH else
                         translate("Paver", "\u03b5r, \u03bcr of the medium there, whose wavelength counts"))
        self.table.setItem(number, WHERE, where)
        self.table.setItem(number, VALUE, value)
        choice = fields.by_field(obj)
        choice.changed.connect(lambda: self.choose(obj, choice.value()))
        self.table.setCellWidget(number, BY, choice)

    def do(self, name, line):
        try:
            in_step(self.obj.Document, name, ["paver_wb.refinement"], [line])
        except Exception as error:
            self.failed.emit(str(error))
            self.refresh()
            return False
        self.steps += 1
        return True

    def settle(self):
        """What there is now is what drop() brings back."""
        self.settled = {obj.Name: (obj.Label, *as_arguments(obj)) for obj in refinement.of_mesh(self.obj)}

    def drop(self):
        """Takes back what was done since settle(), as one step of undo."""
        lines = []
        for obj in refinement.of_mesh(self.obj):
            if obj.Name not in self.settled:
                lines.append(f'FreeCAD.getDocument("{obj.Document.Name}").removeObject("{obj.Name}")')
            elif as_arguments(obj) != self.settled[obj.Name][1:]:
                _, references, value = self.settled[obj.Name]
                lines.append(call_text("paver_wb.refinement.change", python_name(obj), references, **value))
        there = {obj.Name for obj in refinement.of_mesh(self.obj)}
        for name, (label, references, value) in self.settled.items():
            if name not in there:
                lines += ["refinement = " + call_text("paver_wb.refinement.make", python_name(self.obj), references, **value,
                                                      name=name), f"refinement.Label = {label!r}"]
        if lines:
            in_step(self.obj.Document, translate("Paver", "Drop local sizes"), ["paver_wb.refinement"], lines)

    def add_selected(self):
        try:
            listed = references_text(selection.references())
        except ValueError as error:
            self.failed.emit(str(error))
            return
        self.do(translate("Paver", "Refine"), f"paver_wb.refinement.make({python_name(self.obj)}, {listed}, "
                                              f"{refinement.first_length(self.obj)!r})")

    def chosen(self):
        return [self.shown[number] for number in sorted({index.row() for index in self.table.selectedIndexes()})]

    def show_chosen(self):
        """Selects in the 3D view what the chosen rows refer to."""
        FreeCADGui.Selection.clearSelection()
        for obj in self.chosen():
            for thing, elements in obj.References:
                for element in elements or ("",):
                    FreeCADGui.Selection.addSelection(thing, element)

    def remove_chosen(self):
        for obj in self.chosen():
            self.do(translate("Paver", "Delete {}").format(obj.Label),
                    f'FreeCAD.getDocument("{obj.Document.Name}").removeObject("{obj.Name}")')

    def edited(self, item):
        obj = self.shown[item.row()]
        try:
            arguments = value_of(obj, item.text())
        except ValueError as error:
            self.failed.emit(str(error))
            self.refresh()
            return
        self.set(obj, arguments)

    def choose(self, obj, way):
        """Changes between length and medium, beginning with what there was or with a length that refines."""
        if way == refinement.LENGTH:
            self.set(obj, {"length": obj.Length.Value or refinement.first_length(self.obj)})
        else:
            self.set(obj, {"eps_r": obj.EpsR, "mu_r": obj.MuR})

    def set(self, obj, arguments):
        self.do(translate("Paver", "Size of {}").format(obj.Label),
                call_text("paver_wb.refinement.set_value", python_name(obj), **arguments))
