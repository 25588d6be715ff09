"""The task panel and runs beside the window, in FreeCAD's window; pictures end up in the build folder."""
import re

import freecad_program
import pytest


def test_solvers_find_what_is_added_later_in_the_window_too(home):
    done = freecad_program.run_window(["-t", "TestPaver.Later"], home)
    output = done.stdout + done.stderr
    assert done.returncode == 0 and "Traceback" not in output, output[-8000:]


@pytest.mark.parametrize("case", ["Panel", "Runs", "Logs", "Previews", "Sizes", "RefinementPanel", "NamedPanel", "Units", "Create", "Verdicts"])
def test_all_cases_in_the_window(home, case):
    done = freecad_program.run_window(["-t", "TestPaverGui." + case], home)
    output = done.stdout + done.stderr
    assert done.returncode == 0, output[-8000:]
    assert int(re.search(r"Ran (\d+) tests", output).group(1)) > 2 and "skipped" not in output
    assert "already deleted" not in output and output.count("Traceback") == 0, output[-8000:]
