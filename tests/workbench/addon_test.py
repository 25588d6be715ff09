"""The cases that run inside FreeCAD, and the add-on where the core is not built."""
import re

import freecad


def test_all_cases_in_freecad(home):
    done = freecad.run(["-t", "TestPaver"], home)
    output = done.stdout + done.stderr
    assert done.returncode == 0, output[-8000:]
    assert int(re.search(r"Ran (\d+) tests", output).group(1)) > 5, output[-8000:]
    assert "skipped" not in output


def test_a_case_that_fails_is_seen(home):
    assert freecad.run(["-t", "TestPaver.NoSuchCase"], home).returncode != 0


def test_add_on_loads_without_the_core(home, tmp_path):
    macro = tmp_path / "look.FCMacro"
    macro.write_text("import sys\nfrom paver_wb import core\nprint('said:', core.problem())\nsys.exit(0)\n")
    done = freecad.run([str(macro)], home, PAVER_BUILD=str(tmp_path))
    said = [line for line in done.stdout.splitlines() if line.startswith("said:")]
    assert done.returncode == 0 and len(said) == 1 and "run scripts/build paver_python" in said[0], done.stdout
    assert "Traceback" not in done.stdout + done.stderr and "No module" not in done.stdout + done.stderr
