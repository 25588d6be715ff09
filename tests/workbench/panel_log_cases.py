"""The log and the time left of runs, in the panel and the status bar. Runs in FreeCAD's window: panel_test.py."""
import FreeCAD
from PySide import QtGui

import window
from panel_cases import PanelCase
from paver_wb import core, preferences
from paver_wb.gui import run_control
from paver_wb.gui.base import run_log, run_status, time_left


class Logs(PanelCase):
    def setUp(self):
        super().setUp()
        self.addCleanup(preferences.parameters().RemBool, "ShowLog")

    def log(self):
        return window.widget("Paver_Log").toPlainText()

    def test_nothing_is_told_before_it_can_be(self):
        estimate = time_left.TimeLeft()
        self.assertIsNone(estimate.left(0.5, 0.1))
        self.assertIsNone(estimate.left(0.01, 100))
        self.assertEqual(time_left.text_of(None), "")

    def test_a_steady_run_is_told_as_it_is_and_jumps_are_smoothed(self):
        estimate = time_left.TimeLeft()
        for passed in range(10, 100, 5):
            self.assertAlmostEqual(estimate.left(passed / 100, passed), 100 - passed, 6)
        estimate = time_left.TimeLeft()
        before = estimate.left(0.2, 20)  # 100 in all
        jumped = estimate.left(0.5, 21)  # by its own it would say 42 in all
        self.assertTrue(21 < jumped < before - 1)
        self.assertIsNone(estimate.left(0.5, 300))  # it stands still longer than it should
        self.assertTrue(0 < estimate.left(0.9, 301) < 300)

    def test_times_are_told_as_people_do(self):
        for seconds, wanted in ((3, "a few seconds left"), (21, "about 20 s left"), (58, "about 1 min left"),
                                (150, "about 2 min left"), (7300, "about 2 h left")):
            self.assertEqual(time_left.text_of(seconds), wanted)

    def test_shares_of_stages_add_up(self):
        last = 0
        for name, _, percents in core.stages():
            self.assertAlmostEqual(run_status.share(name, 0), last, 9)
            last += percents / 100
            self.assertAlmostEqual(run_status.share(name, 1), last, 9)
        self.assertAlmostEqual(last + run_status.SHARE_OF_DRAWING / 100, 1, 1)

    def test_the_log_has_stages_with_seconds_and_stays_until_the_next_run(self):
        mesh = self.add_mesh(size=0.1)
        self.open(mesh)
        self.assertIsNone(window.widget("Paver_Log"), "the options stand below it")
        self.mesh_and_wait()
        lines = self.log().splitlines()
        self.assertIn("handed over", lines[0])
        self.assertTrue(any("Paving" in line and line.endswith(" s") for line in lines), lines)
        self.assertIn("6 faces are meshed.", self.log())
        self.assertIn(f"has {mesh.Quads} quads", self.log())
        window.click(self.button(QtGui.QDialogButtonBox.Ok))
        window.wait(lambda: window.widget("Paver_MeshButton") is None, "for the panel to go")
        self.open(mesh)
        self.assertEqual(self.log().splitlines(), lines)
        window.picture("panel_log")
        mesh.Size = 2
        self.mesh_and_wait()
        self.assertEqual(self.log().count("handed over"), 1)
        name = self.document.Name
        FreeCAD.closeDocument(name)
        self.document = None
        self.assertEqual([key for key in run_log._logs if key[0] == name], [])

    def test_it_lives_and_is_kept_where_no_panel_is(self):
        mesh = self.add_mesh()
        run = self.begin_long_run(mesh)
        self.open(mesh)
        window.wait(lambda: "Paving" in self.log().splitlines()[-1] and "%" in self.log().splitlines()[-1], "for a share")
        run.begun -= 60  # as if it had begun before
        window.wait(lambda: " left" in window.widget("Paver_Progress").text(), "for the time left")
        bars = [bar.text() for bar in window.widgets(QtGui.QProgressBar) if bar.objectName() != "Paver_Progress"]
        window.wait(lambda: any(" left" in bar.text() for bar in window.widgets(QtGui.QProgressBar)
                                if bar.objectName() != "Paver_Progress"), f"for the status bar {bars}")
        window.picture("panel_time_left")
        window.click(window.widget("Paver_StopButton"))
        window.wait(lambda: run.outcome, "for the stop")
        self.assertIn("was stopped", self.log().splitlines()[-1])

    def test_errors_and_repairs_are_in_it_and_it_folds(self):
        mesh = self.add_mesh(size=0.001)
        run = run_control.start(mesh)
        window.wait(lambda: run.outcome, "for the error")
        self.open(mesh)
        self.assertIn("elements are predicted", self.log())
        window.click(window.widget("Paver_LogFold"))
        self.assertIsNone(window.widget("Paver_Log"))
        window.click(self.button(QtGui.QDialogButtonBox.Ok))
        window.wait(lambda: window.widget("Paver_MeshButton") is None, "for the panel to go")
        self.open(mesh)
        self.assertIsNone(window.widget("Paver_Log"))
        window.click(window.widget("Paver_LogFold"))
        self.assertTrue(window.widget("Paver_Log"))
