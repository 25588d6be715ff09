"""The task panel of a refinement: its length or medium, and the elements it refers to, chosen in the 3D view.

Everything is put into the refinement by OK, in one step of undo; Cancel drops it, and takes back a refinement that was made
for this panel.
"""
import os

import FreeCAD
import FreeCADGui
from PySide import QtCore, QtGui

from paver_wb import core, refinement
from paver_wb.gui import task_panel_fields as fields
from paver_wb.gui.paths import ICONS
from paver_wb.gui.task_panel_run import FAULT_STYLE
from paver_wb.gui.task_panel_sizes import references_text, selected_references
from paver_wb.gui.task_panel_steps import in_step, python_name

translate = FreeCAD.Qt.translate
LIST_HEIGHT = 120  # pixels
_open = None  # the panel on screen
_new = None  # the refinement that the next panel is made for


def button(name, text, tip, action):
    made = QtGui.QPushButton(text)
    made.setObjectName("Paver_" + name)
    made.setToolTip(tip)
    made.clicked.connect(action)
    return made


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
        layout.addWidget(self.fault_box())
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
            field.setObjectName("Paver_" + name)
            field.set_tip(tip)
            field.set_value(value)
        self.by = fields.ChoiceField(refinement.BY, [translate("Paver", "Length"), translate("Paver", "Medium")])
        self.by.setObjectName("Paver_RefinementBy")
        self.by.set_tip(translate("Paver", "A length, or the wavelength in a medium, which needs a frequency"))
        self.by.set_value(self.obj.By)
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
        self.list = QtGui.QListWidget()
        self.list.setObjectName("Paver_RefinementWhere")
        self.list.setToolTip(translate("Paver", "What is refined; a click shows it in the 3D view"))
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
        rows.addWidget(button("RefinementModel", translate("Paver", "Show model"), translate(
            "Paver", "Shows what is meshed, to select from it"), lambda: self.show_in_view(False)), 1, 0)
        rows.addWidget(button("RefinementMesh", translate("Paver", "Show mesh"), translate("Paver", "Shows the mesh"),
                              lambda: self.show_in_view(True)), 1, 1)
        return rows

    def fault_box(self):
        self.fault = QtGui.QFrame()
        self.fault.setObjectName("Paver_Fault")
        self.fault.setStyleSheet(FAULT_STYLE)
        layout = QtGui.QVBoxLayout(self.fault)
        self.fault_text = QtGui.QLabel()
        self.fault_text.setObjectName("Paver_FaultText")
        self.fault_text.setWordWrap(True)
        self.fault_text.setToolTip(translate("Paver", "What went wrong, and what to do"))
        layout.addWidget(self.fault_text)
        return self.fault

    def mesh(self):
        meshes = refinement.meshes_of(self.obj)
        return meshes[0] if meshes else None

    def show_fault(self, text):
        self.fault_text.setText(text)
        self.fault.setVisible(bool(text))

    def refresh(self):
        """Shows the references, none of them chosen."""
        self.list.blockSignals(True)
        self.list.clear()
        for thing, element in self.references:
            self.list.addItem(f"{thing.Label}: {element or translate('Paver', 'all')}")
        self.list.blockSignals(False)
        self.show_fault("")

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
            self.show_fault(str(error))
            return
        self.references += new
        self.refresh()

    def remove_chosen(self):
        gone = self.chosen()
        self.references = [entry for number, entry in enumerate(self.references) if number not in gone]
        self.refresh()

    def show_in_view(self, shows_mesh):
        if self.mesh():
            FreeCADGui.addModule("paver_wb.gui.run_place")
            FreeCADGui.doCommand(f"paver_wb.gui.run_place.show({python_name(self.mesh())}, mesh={shows_mesh})")

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


class RefinementPanel:
    """What FreeCAD calls. is_new: the refinement was made for this panel."""

    def __init__(self, obj, is_new):
        self.obj, self.is_new, self.document, self.steps = obj, is_new, obj.Document, obj.Document.UndoCount
        self.box = RefinementBox(obj)
        self.form, self.before = [self.box], self.box.line()
        self.is_closed = False
        FreeCAD.addDocumentObserver(self)

    def getStandardButtons(self):
        buttons = QtGui.QDialogButtonBox.Ok | QtGui.QDialogButtonBox.Cancel
        return getattr(buttons, "value", None) or int(buttons)

    def isAllowedAlterSelection(self):
        return True

    def isAllowedAlterView(self):
        return True

    def isAllowedAlterDocument(self):
        return True

    def accept(self):
        fault = self.box.text_fault()
        try:
            if not fault and self.box.line() != self.before:
                in_step(self.document, translate("Paver", "Size of {}").format(self.obj.Label), ["paver_wb.refinement"],
                        [self.box.line()])
        except ValueError as error:
            fault = str(error)
        if fault:
            self.box.show_fault(fault)
            return False
        self.close()
        return True

    def reject(self):
        is_unused = self.is_new and self.document.UndoCount == self.steps
        document = self.document
        self.close()
        if is_unused:
            document.undo()
        return True

    def close(self):
        self.forget()
        FreeCADGui.getDocument(self.document.Name).resetEdit()
        FreeCADGui.Control.closeDialog()

    def forget(self):
        global _open
        if not self.is_closed:
            self.is_closed = True
            FreeCAD.removeDocumentObserver(self)
            _open = None

    def slotDeletedObject(self, obj):
        if obj == self.obj or any(obj == thing for thing, _ in self.box.references):
            self.vanish()

    def slotDeletedDocument(self, document):
        if document == self.document:
            self.vanish()

    def vanish(self):
        """The refinement, or what it refers to, goes away."""
        self.forget()
        QtCore.QTimer.singleShot(0, lambda: FreeCADGui.Control.closeDialog())


def edit_new(obj):
    """Opens the panel of a refinement that was made for it, when the command that calls this has ended."""
    global _new
    _new, document, name = obj, obj.Document.Name, obj.Name
    QtCore.QTimer.singleShot(0, lambda: FreeCADGui.getDocument(document).setEdit(name))


def set_edit(obj):
    """What the view provider does when the object is to be edited."""
    global _open, _new
    is_new, _new = _new == obj, None
    fault = core.problem()
    if not fault and FreeCADGui.Control.activeDialog():
        fault = translate("Paver", "Another task panel is open; close it first.")
    if fault:
        FreeCAD.Console.PrintError(f"{obj.Label}: {fault}\n")
        return False
    _open = RefinementPanel(obj, is_new)
    FreeCADGui.Control.showDialog(_open)
    _open.box.select(range(len(_open.box.references)))
    _open.box.length.setFocus()
    _open.box.length.selectAll()
    return True


def unset_edit():
    """What it does at the end, whoever asked for that."""
    if _open is not None:
        _open.forget()
        FreeCADGui.Control.closeDialog()
