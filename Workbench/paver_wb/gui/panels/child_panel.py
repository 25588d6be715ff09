"""What the panels of children of a mesh object share."""
from paver_wb.gui.base import edit_panel
from paver_wb.gui.base.steps import in_step


class ChildPanel(edit_panel.EditPanel):
    """box_class: a widget with `where` (a ReferencesBox), `fault` (a FaultBox), text_fault(): empty, or a sentence on what is
    no value, and line(): what OK does, as Python; module: that the line needs."""

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
        is_unused = self.is_new and self.document.UndoCount == self.steps
        self.close()
        if is_unused:
            self.document.undo()
        return True

    def slotDeletedObject(self, obj):
        if obj == self.obj or any(obj == thing for thing, _ in self.box.where.references):
            self.vanish()
