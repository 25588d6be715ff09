"""A guide through FreeCAD's window: clicks, types and chooses as a user would, by what is written there, and gives back the words
in which a page tells it. So the text of a step is made while the step is done, and cannot say anything else.

    it.step("Give the frequency", f"Click {it.press('Frequency')} and write {it.write('Frequency', '3 GHz')}.")

Runs in FreeCAD, with its Python. What is expected of the window and does not happen is an AssertionError.
"""
import os
import re
import sys

import FreeCAD
import FreeCADGui
from PySide import QtCore, QtGui

sys.path.append(os.path.join(os.path.dirname(os.path.realpath(__file__)), "..", "..", "tests", "workbench"))
import window  # noqa: E402
from pictures import Pictures  # noqa: E402

SETTLE = 400  # ms until FreeCAD has drawn
ENOUGH = 90  # percent of a run, which is to be seen
ARROW = 10   # pixels from an item of the tree to the arrow that unfolds it
ROW = 12      # pixels between the middles of a label and its field
BUTTONS = (QtGui.QPushButton, QtGui.QRadioButton, QtGui.QCheckBox, QtGui.QToolButton)


def plain(text):
    """Without the sign of its key, and the dots of a command that asks."""
    return text.replace("&", "").rstrip(".")


def middle_of(widget):
    return widget.mapToGlobal(widget.rect().center())


def right_of(label, kinds):
    """The nearest field in the row of a label, or of a button."""
    at = middle_of(label)
    fields = [field for kind in kinds for field in window.widgets(kind)
              if abs(middle_of(field).y() - at.y()) < ROW and middle_of(field).x() > at.x()
              and not field.objectName().startswith("qt_") and is_over(field) == is_over(label)]  # qt_: a part of another field
    return min(fields, key=lambda field: middle_of(field).x()) if fields else None


def is_over(widget):
    """Whether it is in a dialog. Not by its window() or parent(): Python deletes what these give with what it thinks to own."""
    at = middle_of(widget)
    return any(dialog.isWindow() and dialog.frameGeometry().contains(at) for dialog in window.widgets(QtGui.QDialog))


def top_first(widgets):
    """What lies over the window, in a dialog, comes first."""
    return sorted(widgets, key=lambda widget: not is_over(widget))


def is_told(button):
    """Whether its text is seen."""
    return not isinstance(button, QtGui.QToolButton) or button.toolButtonStyle() != QtCore.Qt.ToolButtonIconOnly


def bring(widget):
    """Scrolls the panel until a part of it is seen."""
    for area in window.widgets(QtGui.QScrollArea):
        if area.isAncestorOf(widget):
            area.ensureWidgetVisible(widget)
    window.pause(50)


def frame_in(view, item):
    """Where an item of a list, a tree or a table is on the screen."""
    rect = view.visualItemRect(item)
    return QtCore.QRect(view.viewport().mapToGlobal(rect.topLeft()), rect.size())


def click_on(view, item, key=QtCore.Qt.NoModifier):
    """Clicks on such an item, which is scrolled into sight."""
    view.scrollToItem(item)
    window.pause(50)
    window.QTest.mouseClick(view.viewport(), QtCore.Qt.LeftButton, key, view.visualItemRect(item).center())
    window.pause(100)


class Guide:
    """folder: where the user's files are. `steps`: those that were done."""

    def __init__(self, folder, pictures):
        self.folder, self.steps, self.pictures = folder, [], Pictures(pictures)

    def step(self, title, *sentences):
        """Ends a step: keeps its words and takes its picture."""
        window.pause(SETTLE)
        self.steps.append({"title": title, "text": " ".join(sentences), "picture": self.pictures.take(len(self.steps) + 1)})

    def snap(self):
        """Takes the picture of the step now, before it ends."""
        window.pause(SETTLE)
        self.pictures.hold(len(self.steps) + 1)
        return ""

    @staticmethod
    def expect(is_so, what):
        if not is_so:
            raise AssertionError(f"it is not so: {what}")

    # ---- buttons, fields, commands

    def button(self, text):
        found = [button for kind in BUTTONS for button in window.widgets(kind)
                 if plain(button.text()) == text and is_told(button)]
        self.expect(found, f"there is a button {text}")
        return top_first(found)[0]

    def press(self, text):
        """Clicks a button, a radio button or a check box."""
        window.wait(lambda: self.button(text).isEnabled(), f"for {text}")
        button = self.button(text)
        self.pictures.mark(button)
        window.click(button)
        window.pause(50)
        return f"**{text}**"

    def chosen(self, label):
        """What a list of the panel is on, which is scrolled into sight."""
        field = self.field(label, QtGui.QComboBox)
        bring(field)
        self.pictures.mark(field)
        return field.currentText()

    def scroll(self, name):
        """Scrolls the panel to a part of it."""
        bring(window.widget("Paver_" + name))
        return ""

    def field(self, label, *kinds):
        """The field in the row of a text."""
        labels = [widget for kind in (QtGui.QLabel, *BUTTONS) for widget in window.widgets(kind) if plain(widget.text()) == label]
        found = [right_of(widget, kinds) for widget in top_first(labels) if right_of(widget, kinds) is not None]
        self.expect(found, f"there is a field {label}")
        return found[0]

    def write(self, label, text):
        """Types into a field."""
        field = self.field(label, QtGui.QLineEdit)
        bring(field)
        self.expect(field.isEnabled(), f"{label} can be written")
        self.pictures.mark(field)
        field.setFocus()
        field.selectAll()
        window.QTest.keyClicks(field, text)
        window.pause(50)
        return f"`{text}`"

    def choose(self, label, text):
        """Chooses one of a list."""
        field = self.field(label, QtGui.QComboBox)
        bring(field)
        self.pictures.mark(field)
        at = field.findText(text)
        self.expect(at >= 0, f"{label} has {text}")
        field.setFocus()
        for _ in range(field.count()):
            if field.currentIndex() == at:
                break
            window.QTest.keyClick(field, QtCore.Qt.Key_Down if field.currentIndex() < at else QtCore.Qt.Key_Up)
        field.activated.emit(at)
        window.pause(50)
        return f"**{text}**"

    def command(self, name, inside=None):
        """Runs a command of the toolbar or the menu. inside(): what is done in the dialog that it waits for."""
        info = FreeCADGui.Command.get(name).getInfo()
        self.expect(FreeCADGui.Command.get(name).isActive(), f"{name} can be run")
        self.pictures.mark_tool(name)
        faults = []
        if inside:
            QtCore.QTimer.singleShot(2 * SETTLE, lambda: self.attempt(inside, faults))
        FreeCADGui.runCommand(name)
        for fault in faults:
            raise fault
        window.pause(SETTLE)
        keys = info["shortcut"]
        return f"**{plain(info['menuText'])}**" + (f" ({keys})" if keys else "")

    @staticmethod
    def attempt(work, faults):
        """Within a dialog, which has to end whatever happens."""
        try:
            work()
        except Exception as fault:
            faults.append(fault)
            for dialog in window.widgets(QtGui.QFileDialog):
                dialog.reject()

    # ---- files

    def open(self, name):
        """Opens a file of the user's folder."""
        return self.command("Std_Open", lambda: self.name_file(os.path.join(self.folder, name)))

    def export(self, name):
        """Writes the mesh; the step's picture is that of the dialog."""
        path = os.path.join(self.folder, name)
        text = self.command("Paver_Export", lambda: self.name_file(path, name))
        window.wait(lambda: os.path.exists(path) and not window.widget("PaverStatusStop"), f"for {name}")
        self.expect(os.path.getsize(path), f"{name} is written")
        return text

    def group(self, file, name):
        """A group that a file has."""
        with open(os.path.join(self.folder, file), "rb") as written:
            names = written.read().partition(b"$EndPhysicalNames")[0].decode()
        self.expect(f'"{name}"' in names, f"{file} has a group {name}")
        return name

    def name_file(self, path, shown=""):
        """In a dialog of files. shown: what is typed before the picture of it, if one is wanted."""
        field = window.widget("fileNameEdit", QtGui.QLineEdit)
        if shown:
            window.type_into(field, self.folder)  # which goes there
            field.setText(shown)
            window.pause(SETTLE)
            self.pictures.mark(field)
            self.pictures.hold(len(self.steps) + 1)
        window.type_into(field, path)

    # ---- the tree

    def item(self, label):
        """(tree, item) of an object."""
        for tree in window.widgets(QtGui.QTreeWidget):
            found = tree.findItems(label, QtCore.Qt.MatchExactly | QtCore.Qt.MatchRecursive)
            if found:
                return tree, found[-1]  # a document may be called like what it has
        raise AssertionError(f"{label} is in no tree that is seen")

    def select(self, label, key=QtCore.Qt.NoModifier):
        """Clicks on an object in the tree."""
        window.tree_dock()
        click_on(*self.item(label), key)
        self.pictures.mark_if(lambda: frame_in(*self.item(label)) if window.widgets(QtGui.QTreeWidget) else None)
        return f"**{label}**"

    def add(self, label):
        return self.select(label, QtCore.Qt.ControlModifier)

    def unfold(self, label):
        """Shows what lies below an object."""
        tree, item = self.item(label)
        rect = tree.visualItemRect(item)
        arrow = QtCore.QPoint(rect.left() - ARROW, rect.center().y())
        window.QTest.mouseClick(tree.viewport(), QtCore.Qt.LeftButton, QtCore.Qt.NoModifier, arrow)
        window.pause(100)
        self.expect(item.isExpanded(), f"{label} is open in the tree")
        return f"**{label}**"

    def double_click(self, label):
        window.double_click(self.thing(label))
        window.wait(FreeCADGui.Control.activeDialog, "for the panel")
        window.pause(SETTLE)
        return f"**{label}**"

    # ---- the 3D view

    def look(self, command="Std_ViewIsometric"):
        text = self.command(command)
        window.pause(2 * SETTLE)  # FreeCAD 1.0 turns by and by
        return text

    def pick(self, label, *elements):
        """Clicks where one of the elements of an object is seen; gives its name."""
        thing = self.thing(label)
        for element in elements:
            for point in points_on(thing, element):
                if self.click_at(point, thing.Name, element):
                    return element
        raise AssertionError(f"{' or '.join(elements)} of {label} is not seen")

    def clicks(self, label, *elements):
        """pick() where the text says it in other words."""
        self.pick(label, *elements)
        return ""

    def pick_mesh(self, face):
        """Clicks on an element of the mesh on a face, where it is seen."""
        from paver_wb.gui.display.selection import display_of
        mesh, shown = self.mesh(), display_of(self.mesh()).mesh
        port = window.viewport()
        there = sorted((number for number in range(shown.count) if shown.face_names[shown.faces[number]] == face),
                       key=lambda number: self.off_middle(shown.centres[number], port))
        for number in there:
            if self.click_at(FreeCAD.Vector(*shown.centres[number]), mesh.Name, f"Elem{number + 1}"):
                return f"**{face}**"
        raise AssertionError(f"no element on {face} is seen")

    def refine(self, face):
        """Begins a refinement of the face of the mesh, at an element of it that is seen."""
        self.pick_mesh(face)
        return self.command("Paver_Refine")

    @staticmethod
    def off_middle(point, port):
        x, y = FreeCADGui.ActiveDocument.ActiveView.getPointOnScreen(FreeCAD.Vector(*point))
        return abs(x - port.width() / 2) + abs(y - port.height() / 2)

    def click_at(self, point, name, element):
        """Clicks where a point is drawn, if that shows the element; whether it does."""
        view, port = FreeCADGui.ActiveDocument.ActiveView, window.viewport()
        x, y = view.getPointOnScreen(point)
        width, height = view.getSize()
        for off in (0, 1, -1, 2, -2, 3, -3):  # an edge is thin
            info = view.getObjectInfo((x, y + off))
            if not info or (info["Object"], info["Component"]) != (name, element):
                continue
            place = QtCore.QPoint(round((x + 0.5) * port.width() / width), round((height - 0.5 - y - off) * port.height() / height))
            window.QTest.mouseMove(port, place)
            window.pause(50)
            window.QTest.mouseClick(port, QtCore.Qt.LeftButton, QtCore.Qt.NoModifier, place)
            window.pause(100)
            if any(element in chosen.SubElementNames for chosen in FreeCADGui.Selection.getSelectionEx()):
                self.pictures.mark_place(port.mapToGlobal(place))
                return True
        return False

    # ---- what the window says

    @staticmethod
    def thing(label):
        found = FreeCAD.ActiveDocument.getObjectsByLabel(label)
        Guide.expect(len(found) == 1, f"there is one {label}")
        return found[0]

    def says(self, name):
        """The text of a label of the window, as a page quotes it."""
        label = window.widget("Paver_" + name)
        self.expect(label is not None and label.text(), f"{name} is seen")
        return quoted(label.text())

    def predicts(self):
        """How many elements the panel predicts, once it does. Not how much memory, as that depends on the machine."""
        window.wait(lambda: window.widget("Paver_Prediction") and window.widget("Paver_Prediction").text().startswith("About"),
                    "for the prediction")
        return re.match(r"About (.+?) elements", self.says("Prediction"))[1]

    def previews(self):
        """What the panel says of its preview, once that is drawn."""
        window.wait(lambda: window.widget("Paver_PreviewText") and "Looking" not in window.widget("Paver_PreviewText").text(),
                    "for the preview")
        return self.says("PreviewText")

    def figure(self, name):
        """A figure of the mesh, in the panel's table of results."""
        seen = window.widget("Paver_Result")
        self.expect(seen is not None, "the panel has results")
        rows = {seen.item(i, 0).text(): seen.item(i, 1).text() for i in range(seen.rowCount())}
        self.expect(name in rows, f"the results have {name}")
        return rows[name]

    def statistic(self, name, column=1, group=""):
        """A figure of the dialog of statistics."""
        tree = window.widget("Paver_StatisticsTable")
        window.wait(lambda: tree.topLevelItemCount(), "for the statistics")
        for number in range(tree.topLevelItemCount()):
            top = tree.topLevelItem(number)
            for row in range(top.childCount()):
                if top.child(row).text(0) == name and group in ("", top.text(0)):
                    return top.child(row).text(column)
        raise AssertionError(f"the statistics have {name}")

    def finding(self, words):
        """Clicks on a line of the check, which goes to its place; its text."""
        window.wait(lambda: window.widget("Paver_CheckList") and window.widget("Paver_CheckList").count(), "for the check")
        found = window.widget("Paver_CheckList")
        item = next((found.item(i) for i in range(found.count()) if words in found.item(i).text()), None)
        self.expect(item is not None, f"the check finds: {words}")
        click_on(found, item)
        frame = frame_in(found, item)
        self.pictures.mark_if(lambda: frame if window.widget("Paver_CheckList") else None)
        return quoted(item.text())

    def again(self, words):
        self.finding(words)
        return ""

    def good(self):
        """The word of a panel that has found nothing wrong."""
        window.wait(lambda: re.match("Good|Warning|Error", self.says("VerdictText")), "for the verdict")
        text = self.says("VerdictText")
        self.expect(text.startswith("Good"), "the mesh is sound")
        return "Good"

    def series_row(self, step):
        """Number of the row of a series, which begins with that text."""
        table = window.widget("Paver_SeriesTable")
        found = [row for row in range(table.rowCount()) if table.item(row, 0).text() == step]
        self.expect(found, f"the series has {step}")
        return table, found[0]

    def ran(self, step, column):
        """A figure of a series, once that has ended."""
        from paver_wb.gui.series import run
        window.wait(lambda: not run._at_work, "for the series")
        window.pause(SETTLE)
        table, number = self.series_row(step)
        heads = [table.horizontalHeaderItem(at).text() for at in range(table.columnCount())]
        text = table.item(number, heads.index(column)).text()
        self.expect(text, f"{column} of {step} is known")
        return text

    def row(self, step):
        """Clicks on a row of a series."""
        table, number = self.series_row(step)
        click_on(table, table.item(number, 0))
        window.pause(2 * SETTLE)
        frame = frame_in(table, table.item(number, 0))
        self.pictures.mark_if(lambda: frame if window.widget("Paver_SeriesTable") else None)
        return step

    def running(self):
        """Takes the picture while a run goes on, if it can, when it tells how long."""
        from paver_wb.gui import run_control
        run = run_control.run_of(self.mesh())
        self.expect(run is not None, "it runs")
        window.wait(lambda: run.outcome or run.left_text() or (run.percent() or 0) > ENOUGH, "for the run")
        self.pictures.hold(len(self.steps) + 1)
        return ""

    @staticmethod
    def mesh():
        """The document's mesh object."""
        from paver_wb import mesh_object
        return min(mesh_object.meshes_of(FreeCAD.ActiveDocument), key=lambda mesh: mesh.ID)

    def remeshed(self):
        """Waits for the end of a run without a panel."""
        from paver_wb.gui import run_control
        window.wait(lambda: not run_control.run_of(self.mesh()), "for the mesh")
        self.expect(self.mesh().Status == "Up to date", "the mesh is up to date")
        return number(self.mesh().Quads + self.mesh().Triangles)

    def meshed(self):
        """Waits for the end of a run: how many elements it made, and what the panel finds."""
        self.remeshed()
        window.wait(lambda: window.widget("Paver_Result"), "for the results")
        window.pause(2 * SETTLE)
        return self.figure("Elements")


def number(value):
    """As the window writes it."""
    from paver_wb.statistics import number as written
    return written(value)


def quoted(text):
    """A text of the window without what makes it coloured, on one line."""
    text = re.sub("<br>|\n", "; ", text)
    return re.sub(r"[ \u25a0]+", " ", re.sub("<[^>]*>", "", text)).strip().rstrip(".")


def points_on(thing, element):
    """Points of an object's element, the middle first, where it stands."""
    shape = thing.getSubObject(element) if element else thing.Shape
    if shape.ShapeType == "Vertex":
        return [shape.Point]
    if shape.ShapeType == "Edge":
        return [shape.valueAt(shape.FirstParameter + share * (shape.LastParameter - shape.FirstParameter))
                for share in (0.5, 0.4, 0.6, 0.25, 0.75, 0.1, 0.9)]
    corners, triangles = shape.tessellate(max(shape.BoundBox.DiagonalLength / 100, 1e-3))
    middles = [(corners[a] + corners[b] + corners[c]) / 3 for a, b, c in triangles]
    centre = shape.CenterOfMass
    return sorted(middles, key=lambda point: point.distanceToPoint(centre))
