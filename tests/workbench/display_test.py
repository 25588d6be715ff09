"""The cases of the 3D view that display_cases.py and its fellows have."""
import os
import re

import freecad_program
import gui_test


def test_all_cases_of_the_display(home, tmp_path):
    macro, document = tmp_path / "make.FCMacro", tmp_path / "made.FCStd"
    macro.write_text(gui_test.MAKE)
    made = freecad_program.run([str(macro), "--", str(document)], home)
    assert made.returncode == 0, made.stdout + made.stderr
    pictures = os.path.join(os.environ["PAVER_BUILD"], "pictures", "display")
    os.makedirs(pictures, exist_ok=True)
    done = freecad_program.run_window(["-t", "TestPaverDisplay"], home, PAVER_HEADLESS_DOCUMENT=str(document),
                              PAVER_PICTURES=pictures)
    output = done.stdout + done.stderr
    assert done.returncode == 0, output[-8000:]
    assert int(re.search(r"Ran (\d+) tests", output).group(1)) > 35 and "skipped" not in output
    assert "already deleted" not in output and "Traceback" not in output, output[-8000:]
