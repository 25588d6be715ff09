"""How findings of a check look: signs in colours that are seen on light and dark windows, and the worst one in a line."""
from PySide import QtCore, QtGui

from paver_wb import mesh_check
from paver_wb.gui.base.widgets import button, canvas, named, row, text_label, translate

COLOURS = {mesh_check.ERROR: ("#c01c28", "#ffffff"), mesh_check.WARNING: ("#f8c630", "#241c00"),
           mesh_check.NOTE: ("#3465a4", "#ffffff"), mesh_check.GOOD: ("#2e7d32", "#ffffff")}  # sheet, ink
SIGNS = {mesh_check.ERROR: "\u2715", mesh_check.WARNING: "!", mesh_check.NOTE: "i", mesh_check.GOOD: "\u2713"}
SIZE = 18  # pixels of a sign


def sign(level):
    """QIcon of a disc in the level's colour."""
    sheet, ink = COLOURS[level]
    image, painter = canvas(2 * SIZE, 2 * SIZE)
    painter.setPen(QtCore.Qt.NoPen)
    painter.setBrush(QtGui.QColor(sheet))
    painter.drawEllipse(1, 1, 2 * SIZE - 2, 2 * SIZE - 2)
    painter.setPen(QtGui.QColor(ink))
    font = painter.font()
    font.setPixelSize(int(1.4 * SIZE))
    font.setBold(True)
    painter.setFont(font)
    painter.drawText(QtCore.QRectF(0, 0, 2 * SIZE, 2 * SIZE), QtCore.Qt.AlignCenter, SIGNS[level])
    painter.end()
    return QtGui.QIcon(QtGui.QPixmap.fromImage(image))


def line(findings):
    """The worst finding as a verdict; findings: the worst first."""
    level = mesh_check.verdict(findings)
    if level == mesh_check.GOOD:
        return translate("Paver", "Good: nothing is wrong with the mesh.")
    if level == mesh_check.NOTE:
        return translate("Paver", "Good. {}").format(findings[0].text)
    bad = sum(finding.level in (mesh_check.ERROR, mesh_check.WARNING) for finding in findings)
    beginning = translate("Paver", "Error: {}") if level == mesh_check.ERROR else translate("Paver", "Warning: {}")
    more = " " + translate("Paver", "({} more)").format(bad - 1) if bad > 1 else ""
    return beginning.format(findings[0].text) + more


class VerdictLine(QtGui.QFrame):
    """The line, red, yellow or green, with a button for the rest. `level`: that of the findings, empty while there are none."""

    def __init__(self, details):
        """details: called for the button."""
        super().__init__()
        self.level = ""
        named(self, "Verdict")
        self.text = text_label("VerdictText", translate("Paver", "The worst that a check of the mesh has found"))
        self.details = button("VerdictDetails", translate("Paver", "Details"), translate(
            "Paver", "Opens the list of all that was found, and goes to its places"), details)
        layout = row(self.text, self.details, shares=(1, 0))
        layout.setContentsMargins(8, 4, 6, 4)
        self.setLayout(layout)
        self.hide()

    def tell(self, findings):
        """findings: the worst first; none to hide it."""
        self.level = mesh_check.verdict(findings) if findings else ""
        self.setVisible(bool(findings))
        if findings:
            self.colour(*COLOURS[mesh_check.GOOD if self.level == mesh_check.NOTE else self.level])
            self.text.setText(line(findings))

    def tell_busy(self):
        self.level = ""
        self.setStyleSheet("")
        self.text.setText(translate("Paver", "Checking the mesh..."))
        self.show()

    def colour(self, sheet, ink):
        self.setStyleSheet(f"QFrame#Paver_Verdict {{ background: {sheet}; border-radius: 4px; }} "
                           f"QLabel#Paver_VerdictText {{ color: {ink}; background: transparent; }}")
