"""What the panels of children of a mesh object share."""
from PySide import QtGui

from paver_wb.children.references import meshes_of
from paver_wb.gui.base import edit_panel
from paver_wb.gui.base.steps import in_step
from paver_wb.gui.base.widgets import FaultBox, stack, translate
from paver_wb.gui.panels.references_box import ReferencesBox


class ChildBox(QtGui.QWidget):
    """The fields of a child in `form`, what it refers to in `where`, and what is wrong. Subclasses have name: what names of
    widgets begin with; build(): adds the fields, of which `first` gets the cursor; checked(references): what they become,
    ReferenceMissing for what cannot be referred to; text_fault(): empty, or a sentence on what is no value; line(): what OK
    does, as Python."""

    name = ""

    def __init__(self, obj):
        super().__init__()
        self.obj, self.fault = obj, FaultBox()
        self.form = QtGui.QFormLayout(fieldGrowthPolicy=QtGui.QFormLayout.AllNonFixedFieldsGrow)
        self.setWindowTitle(obj.Label)
        self.setWindowIcon(QtGui.QIcon(obj.ViewObject.Proxy.getIcon()))
        self.build()
        self.where = ReferencesBox(obj, self.name, self.mesh, self.checked)
        self.where.failed.connect(self.fault.tell)
        self.fault.tell("")
        stack(QtGui.QVBoxLayout(self), self.form, QtGui.QLabel(translate("Paver", "Where")), self.where, self.fault)

    def mesh(self):
        return next(iter(meshes_of(self.obj)), None)


class ChildPanel(edit_panel.EditPanel):
    """box_class: a ChildBox; module: that its line() needs."""

    box_class, module = None, ""

    def __init__(self, obj, is_new):
        super().__init__(obj, is_new)
        self.box = self.box_class(obj)
        self.form, self.before = [self.box], self.box.line()

    def step(self):
        """The name of what OK does, as a step of undo."""
        raise NotImplementedError

    def shown(self):
        self.box.where.select_all()
        self.box.first.setFocus()
        self.box.first.selectAll()

    def accept(self):
        fault = self.box.text_fault()
        try:
            if not fault and self.box.line() != self.before:
                in_step(self.document, self.step(), [self.module], [self.box.line()])
        except ValueError as error:
            fault = str(error)
        if fault:
            self.box.fault.tell(fault)
            return False
        self.close()
        return True

    def reject(self):
        is_unused = self.is_unused()
        self.close()
        if is_unused:
            self.take_back()
        return True

    def slotDeletedObject(self, obj):
        if obj == self.obj or any(obj == thing for thing, _ in self.box.where.references):
            self.vanish()
