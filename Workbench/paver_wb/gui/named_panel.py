"""The task panel of a medium, a port or a wire: its name, its values, and what it refers to, chosen in the 3D view.

Everything is put into it by OK, in one step of undo; Cancel drops it, and takes back what was made for this panel.
"""
from PySide import QtGui

from paver_wb.base import proxies
from paver_wb.children import named_parts
from paver_wb.gui.base.steps import call_text, python_name
from paver_wb.gui.base.widgets import named, translate
from paver_wb.gui.panels import fields
from paver_wb.gui.panels.child_panel import ChildBox, ChildPanel


def labels():
    """{property: (label, tooltip)}."""
    return {"EpsR": ("\u03b5r", translate("Paver", "Relative permittivity")),
            "MuR": ("\u03bcr", translate("Paver", "Relative permeability")),
            "LossTangent": (translate("Paver", "Loss tangent"), translate(
                "Paver", "Imaginary by real part of the permittivity")),
            "Conductor": (translate("Paver", "Conductor"), translate(
                "Paver", "No waves inside: the target length is that around it")),
            "Radius": (translate("Paver", "Radius"), translate("Paver", "Radius of the wire, for solvers"))}


class NamedBox(ChildBox):
    """The fields."""

    name = "Named"

    def build(self):
        self.kind, self.fields = named_parts.kind_of(self.obj), {}
        self.label = self.first = named(QtGui.QLineEdit(named_parts.name_of(self.obj)), "NamedLabel", translate(
            "Paver", "Its name in files of the mesh"))
        self.form.addRow(translate("Paver", "Name"), self.label)
        if proxies.type_of(self.obj) == proxies.MEDIUM:
            self.form.addRow(translate("Paver", "Material"), self.material_field())
        for name in self.kind.properties:
            text, tip = labels()[name]
            field = self.fields[name] = named(self.field_for(name), "Named" + name)
            field.set_tip(tip)
            field.set_value(getattr(getattr(self.obj, name), "Value", getattr(self.obj, name)))
            self.form.addRow(text, field)
        if "Conductor" in self.fields:
            self.fields["Conductor"].changed.connect(self.show_what_counts)
            self.show_what_counts()

    @staticmethod
    def field_for(name):
        if name == "Conductor":
            return fields.ChoiceField([False, True], [translate("Paver", "No"), translate("Paver", "Yes")])
        return fields.QuantityField("length") if name == "Radius" else fields.NumberField()

    def material_field(self):
        """Takes the values of a material of the document or of FreeCAD's cards."""
        self.materials = named_parts.materials(self.obj.Document)
        self.material = named(QtGui.QComboBox(), "NamedMaterial", translate(
            "Paver", "Takes the values of a material of the document or of FreeCAD's cards that have some"))
        self.material.addItem(translate("Paver", "As typed"))
        self.material.addItems(list(self.materials))
        self.material.activated.connect(lambda _index: self.take_material())
        return self.material

    def take_material(self):
        material = self.materials.get(self.material.currentText())
        if material is None:
            return
        for name, value in named_parts.values_of_material(material).items():
            self.fields[name].set_value(value)
        if self.label.text().startswith("Medium"):
            self.label.setText(self.material.currentText())
        self.show_what_counts()

    def show_what_counts(self):
        for name in ("EpsR", "MuR", "LossTangent"):
            self.fields[name].setEnabled(not self.fields["Conductor"].value())

    def checked(self, references):
        """[(object, elements)] as this kind refers to them; ReferenceMissing where it cannot."""
        listed, mesh = named_parts.fitting(self.kind, references), self.mesh()
        if mesh and proxies.type_of(self.obj) != proxies.WIRE:  # that of a wire is taken in
            named_parts.check_references([mesh], listed, self.kind.elements)
        return listed

    def text_fault(self):
        """Empty, or a sentence on what is no value."""
        for name, field in self.fields.items():
            if field.fault():
                return field.fault()
            if name not in ("Conductor", "LossTangent") and not field.value() > 0:
                return translate("Paver", "{} is not above 0; write a larger number.").format(field.text())
        if not self.label.text().strip():
            return translate("Paver", "It has no name; write one.")
        return "" if self.where.references else translate("Paver", "It refers to nothing; add faces, edges, vertices or objects.")

    def line(self):
        """What OK does, as Python."""
        values = {name: field.value() for name, field in self.fields.items() if not field.fault()}
        return call_text("paver_wb.children.named_parts.change", python_name(self.obj), self.where.text(),
                         label=self.label.text().strip(), **values)


class NamedPanel(ChildPanel):
    """The panel of a medium, a port or a wire."""

    box_class, module = NamedBox, "paver_wb.children.named_parts"

    def step(self):
        return translate("Paver", "Change {}").format(self.obj.Label)
