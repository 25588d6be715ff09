"""The add-on as FreeCAD's Addon Manager installs it, with a core that the system has installed: nothing is asked, and an
example is meshed in the window. Run by addon_in_bare_root.sh."""
import os
import sys

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path += [os.path.join(os.path.dirname(HERE), name) for name in ("support", "workbench")]
import freecad_program  # noqa: E402
from conftest import home  # noqa: E402, F401
from first_use_test import empty_home, installed, source  # noqa: E402, F401

SHOW = """import os, sys, traceback
import FreeCAD, FreeCADGui
from PySide import QtCore


def show():
    try:
        import TestPaver, window
        from paver_wb import core, examples, mesh_object
        from paver_wb.gui import run_control
        FreeCADGui.activateWorkbench("PaverWorkbench")
        window.pause(1000)
        assert window.widget("Paver_FirstUse") is None
        source = examples.open_model("torus.step")
        mesh = mesh_object.add(source.Document, source, size=8)
        run = run_control.start(mesh)
        window.wait(lambda: mesh.Quads > 0, "for the mesh")
        source.ViewObject.Visibility = False
        FreeCADGui.ActiveDocument.ActiveView.viewIsometric()
        FreeCADGui.SendMsgToActiveView("ViewFit")
        window.pause(1000)
        window.picture("installed_core")
        print("made:", core.load()._paver.__file__, mesh.Quads, mesh.Status, flush=True)
    except BaseException:
        traceback.print_exc()
    sys.stderr.flush()
    os._exit(0)


QtCore.QTimer.singleShot(1000, show)
"""


def test_a_mesh_in_the_window(installed, tmp_path):  # noqa: F811
    macro = tmp_path / "show.FCMacro"
    macro.write_text(SHOW)
    done = freecad_program.run_window([str(macro)], installed, PAVER_BUILD="")
    made = [line.split() for line in done.stdout.splitlines() if line.startswith("made:")]
    assert made and "Traceback" not in done.stderr, done.stdout + done.stderr
    assert made[0][1].startswith("/usr/lib/python3/dist-packages/paver/") and int(made[0][2]) > 500
    assert made[0][3:] == ["Up", "to", "date"]
