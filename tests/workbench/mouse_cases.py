"""The mouse itself, by the X server's test extension, over meshes in the 3D view: no event of it may end FreeCAD. Runs in
FreeCAD's window: display_test.py."""
import subprocess

import FreeCADGui
from PySide import QtCore

import window
from display_cases import wait
from display_pick_cases import WithPlaces
from paver_wb.gui.display import mesh_display, report

LEFT, MIDDLE = "1", "2"


def do(*words):
    """What xdotool knows, and what FreeCAD makes of it."""
    subprocess.run(["xdotool", *map(str, words)], check=True)
    wait(120)


class Mouse(WithPlaces):
    def setUp(self):
        super().setUp()
        self.shown = self.run_mesh()
        self.look()
        FreeCADGui.getMainWindow().activateWindow()
        wait(100)

    def tearDown(self):
        do("mousemove", 0, 0)
        super().tearDown()

    def screen(self, x, y):
        """Of a place in the view, measured from its lower left corner; in the screen's pixels, which may be finer than Qt's."""
        viewport, place = self.mouse_place(x, y)
        at, ratio = viewport.mapToGlobal(place), viewport.devicePixelRatioF()
        return round(at.x() * ratio), round(at.y() * ratio)

    def hover(self, element):
        at = self.screen(*self.place_of(self.shown, element))
        for step in (6, 3, 0):
            do("mousemove", at[0] - step, at[1] - step)

    def drag(self, start, end, button=LEFT):
        do("mousemove", *start)
        do("mousedown", button)
        for part in (0.3, 0.6, 1):
            do("mousemove", *(round(a + part * (b - a)) for a, b in zip(start, end)))
        do("mouseup", button)

    def corners(self):
        width, height = self.view.getSize()
        return self.screen(20, height - 20), self.screen(width - 20, 20)

    def test_hover_and_click_in_all_display_modes(self):
        element = int(self.facing(self.shown)[3])
        for mode in self.mesh.ViewObject.listDisplayModes():
            self.set(DisplayMode=mode)
            self.hover(element)
            hovered = self.shown.hovered
            do("click", LEFT)
            selected = FreeCADGui.Selection.getSelectionEx()
            if mode in mesh_display.MODES:
                self.assertEqual([(s.Object, s.SubElementNames) for s in selected],
                                 [(self.mesh, (report.element_name(element),))], mode)
                self.assertEqual(hovered, element, mode)
            do("mousemove", *self.screen(4, 4), "click", LEFT)
            self.assertEqual(FreeCADGui.Selection.getSelection(), [], mode)
        window.picture("mouse_modes")

    def test_selection_in_a_box(self):
        for mode in mesh_display.MODES:
            for command in ("Std_BoxSelection", "Std_BoxElementSelection"):
                self.set(DisplayMode=mode)
                FreeCADGui.Selection.clearSelection()
                FreeCADGui.runCommand(command)
                wait(100)
                self.drag(*self.corners())
                if command == "Std_BoxSelection":
                    self.assertIn(self.mesh, FreeCADGui.Selection.getSelection(), mode)
                else:  # of elements, which meshes do not have for FreeCAD: nothing wrong may come of it
                    self.assertLessEqual({thing.Name for thing in FreeCADGui.Selection.getSelection()}, {self.mesh.Name})
                do("key", "Escape")

    def test_turning_zooming_and_the_menu_of_the_view(self):
        low, high = self.corners()
        for mode in mesh_display.MODES:
            self.set(DisplayMode=mode)
            seen = [self.view.getCamera()]
            self.drag(low, high, MIDDLE)
            seen.append(self.view.getCamera())
            for button in ("4", "4", "5"):
                do("mousemove", *self.screen(*(n // 2 for n in self.view.getSize())), "click", button)
            seen.append(self.view.getCamera())
            self.assertEqual(len(set(seen)), 3, mode)
        QtCore.QTimer.singleShot(600, lambda: subprocess.Popen(["xdotool", "key", "Escape"]))  # the menu waits for it
        do("click", "3")

    def test_preselection_and_selection_of_what_lies_behind(self):
        self.sphere.ViewObject.Visibility = True
        for style in ("Shaded", "Wireframe", "Points"):
            self.sphere.ViewObject.DisplayMode = style
            for element in self.facing(self.shown)[:3]:
                self.hover(int(element))
                do("keydown", "ctrl", "click", LEFT, "keyup", "ctrl")
        self.assertTrue(FreeCADGui.Selection.getSelection())
