"""The list of what a child of a mesh object refers to, with buttons that add what is selected in the 3D view."""
import FreeCADGui
from PySide import QtCore, QtGui

from paver_wb.children import references
from paver_wb.gui.base.steps import references_text
from paver_wb.gui.base.widgets import button, named, stack, translate
from paver_wb.gui.display import selection
from paver_wb.gui.panels.sizes_box import view_buttons

LIST_HEIGHT = 120  # pixels


class ReferencesBox(QtGui.QWidget):
    """references: [[object, element]] as they shall be. `failed`: a sentence on what could not be added, empty when all is
    well again."""

    failed = QtCore.Signal(str)

    def __init__(self, obj, name, mesh, check):
        """name: what names of widgets begin with; mesh(): the mesh object, or None; check(references): what they become,
        ReferenceMissing for what cannot be referred to."""
        super().__init__()
        self.name, self.mesh, self.check = name, mesh, check
        self.references = [[thing, element] for thing, elements in obj.References for element in elements or ("",)]
        layout = QtGui.QVBoxLayout(self)
        layout.setContentsMargins(0, 0, 0, 0)
        stack(layout, self.make_list(), self.buttons())
        self.refresh()

    def make_list(self):
        self.list = named(QtGui.QListWidget(selectionMode=QtGui.QAbstractItemView.ExtendedSelection), self.name + "Where", translate(
            "Paver", "What it refers to; a click shows it in the 3D view"))
        self.list.setFixedHeight(LIST_HEIGHT)
        self.list.itemSelectionChanged.connect(self.show_chosen)
        return self.list

    def buttons(self):
        rows = QtGui.QGridLayout()
        rows.addWidget(button(self.name + "Add", translate("Paver", "Add selection"), translate(
            "Paver", "Adds what is selected in the 3D view"), self.add_selected), 0, 0)
        rows.addWidget(button(self.name + "Remove", translate("Paver", "Remove"), translate(
            "Paver", "Removes the chosen lines"), self.remove_chosen), 0, 1)
        for column, shown in enumerate(view_buttons(self.name, self.mesh)):
            rows.addWidget(shown, 1, column)
        return rows

    def refresh(self):
        """Shows the references, none of them chosen."""
        self.list.blockSignals(True)
        self.list.clear()
        for thing, element in self.references:
            self.list.addItem(f"{thing.Label}: {element or translate('Paver', 'all')}")
        self.list.blockSignals(False)
        self.failed.emit("")

    def select(self, numbers):
        """Selects references in the 3D view."""
        FreeCADGui.Selection.clearSelection()
        for thing, element in [self.references[number] for number in numbers]:
            FreeCADGui.Selection.addSelection(thing, element)

    def select_all(self):
        self.select(range(len(self.references)))

    def chosen(self):
        return sorted(index.row() for index in self.list.selectedIndexes())

    def show_chosen(self):
        self.select(self.chosen())

    def add_selected(self):
        try:
            found = self.check(selection.references())
            if not found:
                raise ValueError(translate("Paver", "Nothing of the model is selected; select faces, edges, vertices or "
                                                    "objects in the 3D view."))
        except ValueError as error:
            self.failed.emit(str(error))
            return
        for entry in [[thing, element] for thing, elements in found for element in elements]:
            if entry not in self.references:
                self.references.append(entry)
        self.refresh()

    def remove_chosen(self):
        gone = self.chosen()
        self.references = [entry for number, entry in enumerate(self.references) if number not in gone]
        self.refresh()

    def text(self):
        """The references as text for Python."""
        return references_text(references.grouped(self.references))
