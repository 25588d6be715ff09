"""The commands and their dialogs, in FreeCAD's window; pictures end up in the build folder."""
import re

import freecad_program
import pytest


@pytest.mark.parametrize("case, count", [("OldExport", 5), ("CheckDialog", 6), ("IsolateCommands", 2), ("Commands", 6), ("Dialogs", 4),
                                         ("Preferences", 2), ("Translations", 3), ("FileTasks", 8), ("SeriesDialogs", 7)])
def test_all_cases_in_the_window(home, case, count):
    done = freecad_program.run_window(["-t", "TestPaverGui." + case], home)
    output = done.stdout + done.stderr
    assert done.returncode == 0, output[-8000:]
    assert int(re.search(r"Ran (\d+) tests", output).group(1)) >= count and "skipped" not in output
    assert "already deleted" not in output and output.count("Traceback") == 0, output[-8000:]
