"""The cases of freecad_cases.py in FreeCAD's own program, and in a plain Python that has FreeCAD's libraries."""
import os
import shutil
import subprocess
import sys

import pytest

from conftest import BINDINGS, ROOT

HERE = os.path.dirname(os.path.abspath(__file__))
LIBRARIES = "/usr/lib/freecad-python3/lib"


def need(path):
    """Skips without FreeCAD; in CI nothing may be missing."""
    if not path or not os.path.exists(path):
        (pytest.fail if os.environ.get("CI") == "true" else pytest.skip)("FreeCAD is not installed")


def run(command, profile):
    done = subprocess.run(command, capture_output=True, text=True, stdin=subprocess.DEVNULL, timeout=600,
                          env={**os.environ, "FREECAD_USER_HOME": str(profile), "PAVER_BINDINGS_TESTS": HERE})
    output = done.stdout + done.stderr
    assert done.returncode == 0 and "\nOK" in output, output[-8000:]
    return output


@pytest.fixture
def profile(tmp_path):
    """A user folder of FreeCAD's own, with this checkout as Mod/Paver."""
    (tmp_path / "Mod").mkdir()
    os.symlink(ROOT, tmp_path / "Mod" / "Paver")
    return tmp_path


def test_in_freecads_program(profile):
    program = shutil.which("freecadcmd")
    need(program)
    output = run([program, os.path.join(HERE, "freecad_cases.FCMacro")], profile)
    found = [line for line in output.splitlines() if line.startswith("package: ")]
    assert [os.path.normpath(line[9:]) for line in found] == [f"{profile}/Mod/Paver/bindings/paver/__init__.py"]
    assert "skipped" not in output


def test_in_a_plain_python(profile):
    need(LIBRARIES)
    script = (f"import sys; sys.path[:0] = {[HERE, BINDINGS]!r}; sys.path.append({LIBRARIES!r})\n"
              "import freecad_cases; sys.exit(freecad_cases.run())")
    run([sys.executable, "-c", script], profile)
