"""The check box of the panel that shows, before meshing, how long elements will be, where parts touch and what is small."""
import shutil
import tempfile

import FreeCAD
import numpy as np
from PySide import QtCore, QtGui

from paver_wb import meshing, preferences
from paver_wb.base import proxies, source_shapes
from paver_wb.base.texts import counted
from paver_wb.base.units import length_text
from paver_wb.gui.base.background import Latest
from paver_wb.gui.base.widgets import named, stack, text_label, timer, translate
from paver_wb.gui.preview.drawing import CONTACT, SMALL, Drawing, size_colours
from paver_wb.processes import fem_process
from paver_wb.statistics import number

DELAY = 400  # ms without an edit
SQUARES = 6  # of a scale
SHOWN = "ShowPreview"


def html(colour):
    return "#{:02x}{:02x}{:02x}".format(*(int(255 * c) for c in colour))


def look_at(job, cancel=None):
    """The Look of a job, in any thread."""
    folder = tempfile.mkdtemp(prefix="paver")
    try:
        return fem_process.look(job, folder, cancel)
    finally:
        shutil.rmtree(folder, ignore_errors=True)


def text_of(look):
    """What a Look has, each in the colour it is drawn in."""
    lines, sizes = [], size_text(look)
    if look.pairs:
        lines.append((CONTACT, counted(look.pairs, translate("Paver", "{} pair of parts touches"), translate(
            "Paver", "{} pairs of parts touch")).format(number(look.pairs))))
    if look.short or look.thin:
        lines.append((SMALL, translate("Paver", "Short edges and small faces that are merged with others: {} and {}").format(
            number(look.short), number(look.thin))))
    if not lines:
        return sizes + "<br>" + translate("Paver", "No parts touch, and nothing is merged")
    return sizes + "<br>" + "<br>".join(f'<span style="color: {html(colour)}">\u25a0</span> {text}' for colour, text in lines)


def size_text(look):
    """The range of target lengths, between squares in their colours."""
    low = float(look.size_lengths.min(initial=look.target))
    if low > 0.999 * look.target:
        return translate("Paver", "Target length everywhere: {}").format(length_text(look.target))
    squares = "".join(f'<span style="color: {html(colour)}">\u25a0</span>' for colour in size_colours(
        np.geomspace(low, look.target, SQUARES), look.target))
    return translate("Paver", "Target length: {} to {}").format(f"{length_text(low)} {squares}", length_text(look.target))


def show(obj, **changes):
    """Draws it for a mesh object, but with `changes` of its options, and gives the Drawing, whose clear() takes it away."""
    drawing = Drawing(obj.Document.Name)
    drawing.show(look_at(meshing.prepare(obj, **changes)))
    return drawing


class PreviewBox(QtGui.QWidget):
    """ask(changes): of the options, as properties.put takes them, or None where these have no values."""

    def __init__(self, obj):
        super().__init__()
        self.obj, self.changes, self.drawing, self.shapes = obj, None, Drawing(obj.Document.Name), None
        self.latest = Latest(self.show_look, self.show_fault)
        self.timer = timer(self, self.begin, DELAY)
        self.check = named(QtGui.QCheckBox(translate("Paver", "Preview")), "Preview", translate(
            "Paver", "Shows on the model how long elements will be, where parts touch, and edges and faces that are merged with others"))
        self.text = text_label("PreviewText")
        layout = QtGui.QVBoxLayout(self)
        layout.setContentsMargins(0, 0, 0, 0)
        stack(layout, self.check, self.text)
        self.text.hide()
        self.check.setChecked(preferences.parameters().GetBool(SHOWN, False))
        self.check.toggled.connect(self.switch)
        FreeCAD.addDocumentObserver(self)

    def switch(self, is_on):
        preferences.parameters().SetBool(SHOWN, is_on)
        self.ask(self.changes)

    def ask(self, changes):
        self.drop()
        self.changes = changes
        if self.check.isChecked() and changes is not None:
            self.tell(translate("Paver", "Looking..."))
            self.timer.start()
        else:
            self.tell("")

    def drop(self):
        """Draws nothing, and asks for nothing any more."""
        self.timer.stop()
        self.latest.drop()
        self.drawing.clear()
        self.shapes = None

    def close_preview(self):
        FreeCAD.removeDocumentObserver(self)
        self.drop()

    def slotRecomputedDocument(self, document):
        """FreeCAD calls it: what is meshed may have another shape or place."""
        if self.shapes is None or document.Name != self.drawing.document:
            return
        try:
            if not source_shapes.are_same(source_shapes.of(proxies.sources(self.obj)), self.shapes):
                self.ask(self.changes)
        except Exception:  # something has no shape; a run would tell
            self.drop()

    @QtCore.Slot()
    def begin(self):
        try:
            self.shapes = source_shapes.of(proxies.sources(self.obj))
            job = meshing.prepare(self.obj, **self.changes)
        except Exception as error:
            self.show_fault(error)
            return
        self.latest.ask(lambda cancel: look_at(job, cancel))

    def tell(self, text):
        self.text.setText(text)
        self.text.setVisible(bool(text))

    def show_look(self, look):
        self.drawing.show(look)
        self.tell(text_of(look))

    def show_fault(self, error):
        self.tell(str(error) or type(error).__name__)
