"""The task panel and runs beside the window, in FreeCAD's window; pictures end up in the build folder."""
import re

import freecad_program
import pytest


@pytest.mark.parametrize("case", ["Panel", "Runs", "Logs", "Previews", "Sizes", "RefinementPanel", "NamedPanel"])
def test_all_cases_in_the_window(home, case):
    done = freecad_program.run_window(["-t", "TestPaverGui." + case], home)
    output = done.stdout + done.stderr
    assert done.returncode == 0, output[-8000:]
    assert int(re.search(r"Ran (\d+) tests", output).group(1)) > 3 and "skipped" not in output
    assert "already deleted" not in output and output.count("Traceback") == 0, output[-8000:]
