"""The cases of FreeCAD's window that gui_cases.py has."""
import re

import freecad_program

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
    macro, document = tmp_path / "make.FCMacro", tmp_path / "made.FCStd"
    macro.write_text(MAKE)
    made = freecad_program.run([str(macro), "--", str(document)], home)
    assert made.returncode == 0, made.stdout + made.stderr
    done = freecad_program.run_window(["-t", "TestPaverGui.Window"], home, PAVER_HEADLESS_DOCUMENT=str(document))
    output = done.stdout + done.stderr
    assert done.returncode == 0, output[-8000:]
    assert int(re.search(r"Ran (\d+) tests", output).group(1)) >= 4 and "skipped" not in output
