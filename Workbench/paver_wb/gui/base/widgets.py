"""Small widgets that dialogs and panels share, and how an error is told to the user."""
import FreeCAD
import FreeCADGui
from PySide import QtCore, QtGui

translate = FreeCAD.Qt.translate
MARGINS, SPACING = (6, 4, 6, 4), 4  # pixels, of a part of a panel: small screens shall show what counts


def named(widget, name, tip=""):
    """Gives a widget the object name that tests and users' style sheets find it by, and its tooltip."""
    widget.setObjectName("Paver_" + name)
    if tip:
        widget.setToolTip(tip)
    return widget


def button(name, text, tip, action):
    """action: called without arguments."""
    made = named(QtGui.QPushButton(text), name, tip)
    made.clicked.connect(lambda _checked=False: action())
    return made


def fold_button(name, text, tip, fold):
    """fold(is_open): shows or hides what stands below."""
    made = named(QtGui.QToolButton(text=text, checkable=True, autoRaise=True, arrowType=QtCore.Qt.RightArrow,
                                   toolButtonStyle=QtCore.Qt.ToolButtonTextBesideIcon), name, tip)
    made.toggled.connect(lambda is_open: made.setArrowType(QtCore.Qt.DownArrow if is_open else QtCore.Qt.RightArrow))
    made.toggled.connect(fold)
    return made


def text_label(name, tip=""):
    """For whole sentences."""
    return named(QtGui.QLabel(wordWrap=True), name, tip)


def row(*widgets, shares=()):
    """They stand side by side; None: room between them. shares: of the width, for each."""
    made = QtGui.QHBoxLayout()
    for at, widget in enumerate(widgets):
        made.addWidget(widget) if widget else made.addStretch()
        made.setStretch(at, shares[at] if shares else made.stretch(at))
    return made


def stack(layout, *parts):
    """Puts widgets and layouts into a layout, one after the other, and gives it."""
    for part in parts:
        layout.addLayout(part) if isinstance(part, QtGui.QLayout) else layout.addWidget(part)
    return layout


def part_layout(part, title):
    """The layout of a part of a panel, one widget below the other."""
    part.setWindowTitle(title)
    made = QtGui.QVBoxLayout(part)
    made.setContentsMargins(*MARGINS)
    made.setSpacing(SPACING)
    return made


def timer(parent, action, delay=0, is_single=True):
    """start() lets it call `action` after so many ms, or each time these are over."""
    made = QtCore.QTimer(parent, interval=delay, singleShot=is_single)
    made.timeout.connect(action)
    return made


def canvas(width, height):
    """(QImage, its painter), with nothing on it."""
    image = QtGui.QImage(width, height, QtGui.QImage.Format_RGBA8888)
    image.fill(QtCore.Qt.transparent)
    painter = QtGui.QPainter(image)
    painter.setRenderHint(QtGui.QPainter.Antialiasing)
    return image, painter


class FaultBox(QtGui.QFrame):
    """A sentence on what went wrong, in a red frame; hidden without one."""

    def __init__(self):
        super().__init__()
        named(self, "Fault").setStyleSheet("QFrame#Paver_Fault { border: 1px solid #c01c28; border-radius: 3px; }")
        self.text = text_label("FaultText", translate("Paver", "What went wrong, and what to do"))
        self.text.setTextInteractionFlags(QtCore.Qt.TextSelectableByMouse)
        QtGui.QVBoxLayout(self).addWidget(self.text)

    def tell(self, text):
        self.text.setText(text)
        self.setVisible(bool(text))


def complain(text):
    """Shows an error in a box that does not block, and in the report view."""
    FreeCAD.Console.PrintError(text + "\n")
    box = QtGui.QMessageBox(QtGui.QMessageBox.Warning, "Paver", text, QtGui.QMessageBox.Ok,
                            FreeCADGui.getMainWindow())
    box.setObjectName("Paver_Complaint")
    box.setAttribute(QtCore.Qt.WA_DeleteOnClose)
    box.open()
