"""The cases that need FreeCAD's window, on a screen of their own."""
import os
import re
import shutil
import subprocess

import pytest

import freecad

# Without the start page, which needs a browser and does not start for root.
PREFERENCES = """<?xml version="1.0" encoding="UTF-8" standalone="no" ?>
<FCParameters><FCParamGroup Name="Root"><FCParamGroup Name="BaseApp"><FCParamGroup Name="Preferences">
<FCParamGroup Name="General"><FCText Name="AutoloadModule">PartWorkbench</FCText>
<FCBool Name="ShowSplasher" Value="0"/></FCParamGroup>
<FCParamGroup Name="Mod"><FCParamGroup Name="Start"><FCBool Name="ShowOnStartup" Value="0"/></FCParamGroup></FCParamGroup>
</FCParamGroup></FCParamGroup></FCParamGroup></FCParameters>
"""
MAKE = """import sys, FreeCAD
from paver_wb import mesh_object, meshing
document = FreeCAD.newDocument()
mesh = mesh_object.add(document, document.addObject("Part::Box"), size=3)
document.recompute()
meshing.mesh(mesh)
document.saveAs(sys.argv[-1])
sys.exit(0)
"""


def test_all_cases_in_the_window(home, tmp_path):
    program, screen = shutil.which("freecad") or shutil.which("FreeCAD"), shutil.which("xvfb-run")
    if not program or not screen:
        (pytest.fail if os.environ.get("CI") == "true" else pytest.skip)("FreeCAD's window or Xvfb is not installed")
    (tmp_path / "profile" / "user.cfg").write_text(PREFERENCES)
    macro, document = tmp_path / "make.FCMacro", tmp_path / "made.FCStd"
    macro.write_text(MAKE)
    made = freecad.run([str(macro), "--", str(document)], home)
    assert made.returncode == 0, made.stdout + made.stderr
    done = subprocess.run([screen, "-a", "-s", "-screen 0 1200x800x24", program, "-t", "TestPaverGui"], timeout=300,
                          capture_output=True, text=True, stdin=subprocess.DEVNULL, cwd=home,
                          env={**os.environ, "FREECAD_USER_HOME": home, "PAVER_HEADLESS_DOCUMENT": str(document)})
    output = done.stdout + done.stderr
    assert done.returncode == 0, output[-8000:]
    assert int(re.search(r"Ran (\d+) tests", output).group(1)) > 4 and "skipped" not in output
