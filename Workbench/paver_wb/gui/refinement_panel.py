"""The task panel of a refinement: its length or medium, and the elements it refers to, chosen in the 3D view.

Everything is put into the refinement by OK, in one step of undo; Cancel drops it, and takes back a refinement that was made
for this panel.
"""
import os

import FreeCAD
import FreeCADGui
from PySide import QtGui

from paver_wb import refinement
from paver_wb.base.paths import ICONS
from paver_wb.gui.base import edit_panel
from paver_wb.gui.base.edit_panel import edit_new, unset_edit  # noqa: F401, for commands and the view provider
from paver_wb.gui.base.steps import in_step, python_name
from paver_wb.gui.base.widgets import FaultBox, button, named
from paver_wb.gui.panels import fields
from paver_wb.gui.panels.sizes_box import references_text, selected_references, view_buttons

translate = FreeCAD.Qt.translate
LIST_HEIGHT = 120  # pixels


class RefinementBox(QtGui.QWidget):
    """The fields. references: [[object, element]] as they shall be."""

    def __init__(self, obj):
        super().__init__()
        self.obj = obj
        self.references = [[thing, element] for thing, elements in obj.References for element in elements or ("",)]
        self.setWindowTitle(obj.Label)
        self.setWindowIcon(QtGui.QIcon(os.path.join(ICONS, "Paver_Refine.svg")))
        layout = QtGui.QVBoxLayout(self)
        layout.addLayout(self.values())
        layout.addWidget(QtGui.QLabel(translate("Paver", "Where")))
        layout.addWidget(self.make_list())
        layout.addLayout(self.buttons())
        self.fault = FaultBox()
        layout.addWidget(self.fault)
        self.refresh()

    def values(self):
        self.length = fields.QuantityField("length")
        self.eps_r, self.mu_r = fields.NumberField(), fields.NumberField()
        first = refinement.first_length(self.mesh()) if self.mesh() else 1.0
        for name, field, tip, value in (
                ("RefinementLength", self.length, translate("Paver", "Target length there, such as 2 mm"),
                 self.obj.Length.Value or first),
                ("RefinementEpsR", self.eps_r, translate("Paver", "Relative permittivity of the medium there"),
                 self.obj.EpsR),
                ("RefinementMuR", self.mu_r, translate("Paver", "Relative permeability of the medium there"),
                 self.obj.MuR)):
            named(field, name)
            field.set_tip(tip)
            field.set_value(value)
        self.by = named(fields.by_field(self.obj), "RefinementBy")
        self.by.changed.connect(self.show_what_counts)
        form = QtGui.QFormLayout()
        form.setFieldGrowthPolicy(QtGui.QFormLayout.AllNonFixedFieldsGrow)
        form.addRow(translate("Paver", "By"), self.by)
        form.addRow(translate("Paver", "Length"), self.length)
        form.addRow(translate("Paver", "Medium \u03b5r"), self.eps_r)
        form.addRow(translate("Paver", "\u03bcr"), self.mu_r)
        self.form = form
        self.show_what_counts()
        return form

    def show_what_counts(self):
        is_length = self.by.value() == refinement.LENGTH
        for field, is_shown in ((self.length, is_length), (self.eps_r, not is_length), (self.mu_r, not is_length)):
            field.setVisible(is_shown)
            self.form.labelForField(field).setVisible(is_shown)

    def make_list(self):
        self.list = named(QtGui.QListWidget(), "RefinementWhere", translate(
            "Paver", "What is refined; a click shows it in the 3D view"))
        self.list.setSelectionMode(QtGui.QAbstractItemView.ExtendedSelection)
        self.list.setFixedHeight(LIST_HEIGHT)
        self.list.itemSelectionChanged.connect(self.show_chosen)
        return self.list

    def buttons(self):
        rows = QtGui.QGridLayout()
        rows.addWidget(button("RefinementAdd", translate("Paver", "Add selection"), translate(
            "Paver", "Adds what is selected in the 3D view"), self.add_selected), 0, 0)
        rows.addWidget(button("RefinementRemove", translate("Paver", "Remove"), translate(
            "Paver", "Removes the chosen lines"), self.remove_chosen), 0, 1)
        for column, shown in enumerate(view_buttons("Refinement", self.mesh)):
            rows.addWidget(shown, 1, column)
        return rows

    def mesh(self):
        meshes = refinement.meshes_of(self.obj)
        return meshes[0] if meshes else None

    def refresh(self):
        """Shows the references, none of them chosen."""
        self.list.blockSignals(True)
        self.list.clear()
        for thing, element in self.references:
            self.list.addItem(f"{thing.Label}: {element or translate('Paver', 'all')}")
        self.list.blockSignals(False)
        self.fault.tell("")

    def select(self, numbers):
        """Selects references in the 3D view."""
        FreeCADGui.Selection.clearSelection()
        for thing, element in [self.references[number] for number in numbers]:
            FreeCADGui.Selection.addSelection(thing, element)

    def chosen(self):
        return sorted(index.row() for index in self.list.selectedIndexes())

    def show_chosen(self):
        self.select(self.chosen())

    def add_selected(self):
        found = [[thing, element] for thing, elements in selected_references() for element in elements]
        new = [entry for entry in found if entry not in self.references]
        mesh = self.mesh()
        try:
            if not found:
                raise ValueError(translate("Paver", "Nothing of the model is selected; select faces, edges, vertices or "
                                                    "objects in the 3D view."))
            refinement.check_references([mesh] if mesh else [], [(thing, [element]) for thing, element in new])
        except ValueError as error:
            self.fault.tell(str(error))
            return
        self.references += new
        self.refresh()

    def remove_chosen(self):
        gone = self.chosen()
        self.references = [entry for number, entry in enumerate(self.references) if number not in gone]
        self.refresh()

    def grouped(self):
        """[(object, elements)] of the references."""
        things = list(dict.fromkeys(thing for thing, _ in self.references))
        return [(thing, [element for other, element in self.references if other == thing]) for thing in things]

    def text_fault(self):
        """Empty, or a sentence on what is no value."""
        used = (self.length,) if self.by.value() == refinement.LENGTH else (self.eps_r, self.mu_r)
        for field in used:
            if field.fault():
                return field.fault()
            if not field.value() > 0:
                return translate("Paver", "{} is not above 0; write a larger number.").format(field.text())
        return "" if self.references else translate("Paver", "Nothing is refined; add faces, edges, vertices or objects.")

    def line(self):
        """What OK does, as Python."""
        if self.by.value() == refinement.LENGTH:
            value = f"length={self.length.value()!r}"
        else:
            value = f"eps_r={self.eps_r.value()!r}, mu_r={self.mu_r.value()!r}"
        return f"paver_wb.refinement.change({python_name(self.obj)}, {references_text(self.grouped())}, {value})"


class RefinementPanel(edit_panel.EditPanel):
    """The panel of a refinement."""

    def __init__(self, obj, is_new):
        super().__init__(obj, is_new)
        self.box = RefinementBox(obj)
        self.form, self.before = [self.box], self.box.line()

    def shown(self):
        self.box.select(range(len(self.box.references)))
        self.box.length.setFocus()
        self.box.length.selectAll()

    def accept(self):
        fault = self.box.text_fault()
        try:
            if not fault and self.box.line() != self.before:
                in_step(self.document, translate("Paver", "Size of {}").format(self.obj.Label), ["paver_wb.refinement"],
                        [self.box.line()])
        except ValueError as error:
            fault = str(error)
        if fault:
            self.box.fault.tell(fault)
            return False
        self.close()
        return True

    def reject(self):
        is_unused = self.is_new and self.document.UndoCount == self.steps
        self.close()
        if is_unused:
            self.document.undo()
        return True

    def slotDeletedObject(self, obj):
        if obj == self.obj or any(obj == thing for thing, _ in self.box.references):
            self.vanish()


def set_edit(obj):
    """What the view provider does when the object is to be edited."""
    return edit_panel.set_edit(obj, RefinementPanel, obj.Label + ": ")
