"""The dialog of the first use: the add-on came without its compiled core, which is built here or taken from a
binary."""
import os

import FreeCAD
import FreeCADGui
from PySide import QtCore, QtGui

from paver_wb import binary, core
from paver_wb.gui.base import run_status, run_task, widgets
from paver_wb.gui.base.background import Latest
from paver_wb.gui.base.widgets import named, row, stack, translate
from paver_wb.gui.setup import core_build

LOG_LINES, WIDTH = 5000, 640  # pixels
_dialog = None


def button(name, text, action):
    made = widgets.button("FirstUse" + name, text, "", action)
    made.setAutoDefault(False)
    return made


def text_label(name):
    """For sentences that users may copy."""
    return named(QtGui.QLabel(wordWrap=True, textFormat=QtCore.Qt.PlainText,
                              textInteractionFlags=QtCore.Qt.TextSelectableByMouse), "FirstUse" + name)


def what_is_wrong(fault):
    """The sentence of the core without what to do, where the dialog does it itself."""
    if isinstance(fault, core.NumPyUnfit):
        return str(fault)
    return str(fault).split(f"; or, {core.BINARY}")[0].split("; run ")[0] + "."


class FirstUse(QtGui.QDialog):
    """Stays beside the window. A build goes on when it is closed, and the dialog comes again when that ends."""

    def __init__(self, parent):
        super().__init__(parent)
        self.build, self.wheel = None, None
        self.unpacking = Latest(lambda _: self.end(""), self.take_fault)
        self.setObjectName("Paver_FirstUse")
        self.setWindowTitle(translate("Paver", "Set up Paver"))
        self.state = text_label("State")
        self.boxes = [self.binary_box(), self.build_box()]
        self.again = button("Again", translate("Paver", "Look again"), self.look)
        self.close_button = button("Close", translate("Paver", "Close"), self.close)
        stack(QtGui.QVBoxLayout(self), self.state, *self.boxes, row(None, self.again, self.close_button))
        self.look()

    def binary_box(self):
        box = QtGui.QGroupBox(translate("Paver", "Use a binary"))
        self.wheel_text = text_label("Wheel")
        self.use = button("Use", translate("Paver", "Use it"), lambda: self.unpack(self.wheel))
        self.choose_button = button("Choose", translate("Paver", "Choose file..."), self.choose)
        stack(QtGui.QVBoxLayout(box), self.wheel_text, row(self.use, self.choose_button, None))
        return box

    def build_box(self):
        box = QtGui.QGroupBox(translate("Paver", "Build it here"))
        self.packages = text_label("Packages")
        self.command = named(QtGui.QLineEdit(readOnly=True), "FirstUseCommand")
        self.copy_button = button("Copy", translate("Paver", "Copy"), self.copy)
        self.build_button = button("Build", translate("Paver", "Build"), self.begin)
        self.stop_button = button("Stop", translate("Paver", "Stop"), self.stop)
        self.bar = named(QtGui.QProgressBar(), "FirstUseBar")
        self.log = named(QtGui.QPlainTextEdit(readOnly=True, maximumBlockCount=LOG_LINES, minimumHeight=180,
                                              lineWrapMode=QtGui.QPlainTextEdit.NoWrap), "FirstUseLog")
        self.bar.hide()
        self.log.hide()
        layout = stack(QtGui.QVBoxLayout(box), self.packages, row(self.command, self.copy_button),
                       row(self.build_button, self.stop_button, None), self.bar)
        layout.addWidget(self.log, 1)
        return box

    def look(self):
        """Looks for the core, for a binary and for what a build needs, and shows what can be done."""
        self.fault, self.missing, self.may_build = core.fault(), [], False
        is_of_numpy = isinstance(self.fault, core.NumPyUnfit)
        if is_of_numpy:
            more = translate("Paver", "Nothing can be meshed until then.")
        elif self.fault:
            more = translate("Paver", "Nothing can be meshed without it. Use a binary, or build it here once.")
            self.look_for_binary()
            self.look_for_build()
        else:
            more = core.about()[0]
        self.state.setText((what_is_wrong(self.fault) if self.fault else translate("Paver", "Paver is ready."))
                           + "\n\n" + more)
        for box in self.boxes:
            box.setVisible(self.fault is not None and not is_of_numpy)
        self.again.setVisible(is_of_numpy or bool(self.missing))
        self.allow()
        self.fit()

    def look_for_binary(self):
        self.wheel = binary.found()
        self.wheel_text.setText(translate("Paver", "Found: {}").format(self.wheel) if self.wheel else translate(
            "Paver",
            "A binary is a file paver-{}-*.whl for the Python of this FreeCAD. There is none in FreeCAD's folders."
        ).format(binary.own_version()))

    def look_for_build(self):
        """Whether a build here would fit, and which packages it lacks. It may be tried where that cannot be told."""
        built, own = core_build.built_for(), core_build.own_python()
        is_other = built not in ("", own)
        text = translate("Paver", "All that the build needs is installed. It takes some minutes, in which FreeCAD can "
                                  "be used.")
        try:
            self.missing = [] if is_other else core_build.missing_packages()
        except (OSError, ValueError) as error:
            text = str(error)
        if is_other:
            text = translate("Paver", "A build here is for Python {} of the system, but this FreeCAD has Python {}. "
                                      "Use a binary for that one.").format(built, own)
        elif self.missing:
            text = translate("Paver", "Debian packages are missing for the build: {}. This command installs them, in a "
                                      "terminal:").format(", ".join(self.missing))
        self.packages.setText(text)
        self.command.setText(core_build.command())
        self.command.setCursorPosition(0)
        for widget in (self.command, self.copy_button):
            widget.setVisible(bool(self.missing))
        self.may_build = not self.missing and not is_other

    def fit(self):
        """High enough for its sentences, which Qt does not see to."""
        self.layout().activate()
        self.resize(max(WIDTH, self.width()), self.layout().totalHeightForWidth(max(WIDTH, self.width())))

    def is_busy(self):
        return self.build is not None or self.unpacking.thread is not None

    def allow(self):
        """Enables what can be done now."""
        self.use.setVisible(self.wheel is not None)
        for widget in (self.use, self.choose_button, self.again):
            widget.setEnabled(not self.is_busy())
        self.build_button.setEnabled(self.may_build and not self.is_busy())
        self.stop_button.setEnabled(self.build is not None)
        if not self.fault:
            self.close_button.setFocus()

    def copy(self):
        self.command.selectAll()
        self.command.copy()

    def begin(self):
        self.build = core_build.Build()
        self.build.said.connect(self.log.appendPlainText)
        self.build.progressed.connect(self.show_progress)
        self.build.ended.connect(self.take_build)
        self.log.setPlainText("scripts/build paver_python")
        self.log.show()
        self.bar.setRange(0, 0)
        self.bar.show()
        self.state.setText(translate("Paver", "Building. This window may be closed meanwhile."))
        self.allow()
        run_status.watch(self.build)
        self.fit()
        self.build.begin()

    def show_progress(self, _stage, _fraction):
        self.bar.setRange(0, 100)
        self.bar.setValue(self.build.percent())

    def stop(self):
        self.stop_button.setEnabled(False)
        self.build.stop()

    def take_build(self, outcome):
        self.build = None
        self.bar.hide()
        text = {run_task.DONE: "",
                run_task.STOPPED: translate("Paver", "The build was stopped; Build goes on where it was."),
                run_task.FAILED: translate("Paver", "The build failed; the end of the log says why.")}[outcome]
        self.end(text)

    def choose(self):
        start = QtCore.QStandardPaths.writableLocation(QtCore.QStandardPaths.DownloadLocation)
        path, _ = QtGui.QFileDialog.getOpenFileName(self, translate("Paver", "Choose a binary of Paver"), start,
                                                    f"{translate('Paver', 'Binaries of Paver')} ({binary.NAMES});;"
                                                    f"{translate('Paver', 'All files')} (*)")
        if path:
            self.unpack(path)

    def unpack(self, path):
        self.unpacking.ask(lambda _cancel: binary.install(path))
        self.unpacking.thread.patience = 1000 * binary.TRY_OUT
        self.state.setText(translate("Paver", "Unpacking {}").format(os.path.basename(path)))
        self.allow()

    def take_fault(self, error):
        self.end(str(error) or type(error).__name__)

    def end(self, fault):
        """After a try: what came of it, told here and in the report view."""
        self.look()
        if self.fault:
            self.state.setText(fault or what_is_wrong(self.fault))
            self.fit()
            FreeCAD.Console.PrintError((fault or str(self.fault)) + "\n")
        else:
            FreeCAD.Console.PrintMessage("\n".join(core.about()) + "\n")
        self.show()
        self.raise_()
        self.log.moveCursor(QtGui.QTextCursor.End)
        self.log.ensureCursorVisible()


def show():
    """Shows the dialog, and gives it."""
    global _dialog
    if _dialog is None:
        _dialog = FirstUse(FreeCADGui.getMainWindow())
    elif not (_dialog.isVisible() or _dialog.is_busy()):
        _dialog.look()
    _dialog.show()
    _dialog.raise_()
    return _dialog
