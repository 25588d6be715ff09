"""The task panel of a refinement: its length or medium, and the elements it refers to, chosen in the 3D view.

Everything is put into the refinement by OK, in one step of undo; Cancel drops it, and takes back a refinement that was made
for this panel.
"""

from paver_wb import refinement
from paver_wb.base.units import example
from paver_wb.gui.base.steps import call_text, python_name
from paver_wb.gui.base.widgets import named, text_label, translate
from paver_wb.gui.panels import fields
from paver_wb.gui.panels.child_panel import ChildBox, ChildPanel


class RefinementBox(ChildBox):
    """The fields."""

    name = "Refinement"

    def build(self):
        self.length = self.first = fields.QuantityField("length")
        self.eps_r, self.mu_r = fields.NumberField(), fields.NumberField()
        first = refinement.first_length(self.mesh()) if self.mesh() else 1.0
        for name, field, tip, value in (
                ("RefinementLength", self.length, translate("Paver", "Target length there, such as {}").format(
                    example("length")), self.obj.Length.Value or first),
                ("RefinementEpsR", self.eps_r, translate("Paver", "Relative permittivity of the medium there"),
                 self.obj.EpsR),
                ("RefinementMuR", self.mu_r, translate("Paver", "Relative permeability of the medium there"),
                 self.obj.MuR)):
            named(field, name)
            field.set_tip(tip)
            field.set_value(value)
            field.changed.connect(self.edited)
        self.by = named(fields.by_field(self.obj), "RefinementBy")
        self.by.changed.connect(self.show_what_counts)
        self.by.changed.connect(self.edited)
        self.note = text_label("RefinementNote", translate("Paver", "Whether elements become shorter"))
        for text, field in ((translate("Paver", "By"), self.by), (translate("Paver", "Length"), self.length),
                            (translate("Paver", "Medium \u03b5r"), self.eps_r), (translate("Paver", "\u03bcr"), self.mu_r)):
            self.form.addRow(text, field)
        self.form.addRow(self.note)
        self.show_what_counts()
        self.edited()

    def show_what_counts(self):
        is_length = self.by.value() == refinement.LENGTH
        for field, is_shown in ((self.length, is_length), (self.eps_r, not is_length), (self.mu_r, not is_length)):
            field.setVisible(is_shown)
            self.form.labelForField(field).setVisible(is_shown)

    def edited(self):
        """Says when the value changes nothing; an error may have lost its cause."""
        text = "" if self.value_fault() or not self.mesh() else fields.effect_text(
            self.value(), *refinement.target_of(self.mesh()))
        self.note.setText(text)
        self.note.setVisible(bool(text))
        self.fault.tell("")

    def checked(self, references):
        """[(object, elements)] as they are; ReferenceMissing where the mesh does not have one."""
        mesh = self.mesh()
        refinement.check_references([mesh] if mesh else [], references)
        return references

    def value_fault(self):
        """Empty, or a sentence on what is no value."""
        used = (self.length,) if self.by.value() == refinement.LENGTH else (self.eps_r, self.mu_r)
        for field in used:
            if field.fault():
                return field.fault()
            if not field.value() > 0:
                return translate("Paver", "{} is not above 0; write a larger number.").format(field.text())
        return ""

    def text_fault(self):
        """The same, or one that nothing is refined."""
        return self.value_fault() or ("" if self.where.references else translate(
            "Paver", "Nothing is refined; add faces, edges, vertices or objects."))

    def value(self):
        """Arguments of refinement.set_value."""
        if self.by.value() == refinement.LENGTH:
            return {"length": self.length.value()}
        return {"eps_r": self.eps_r.value(), "mu_r": self.mu_r.value()}

    def line(self):
        """What OK does, as Python."""
        return call_text("paver_wb.refinement.change", python_name(self.obj), self.where.text(), **self.value())


class RefinementPanel(ChildPanel):
    """The panel of a refinement."""

    box_class, module = RefinementBox, "paver_wb.refinement"

    def step(self):
        return translate("Paver", "Size of {}").format(self.obj.Label)
