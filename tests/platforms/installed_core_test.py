"""The add-on as FreeCAD's Addon Manager installs it, with a core that the system has installed: nothing is asked, and an
example is meshed in the window. Run by addon_in_bare_root.sh."""
import os
import sys

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path += [os.path.join(os.path.dirname(HERE), name) for name in ("support", "workbench")]
import freecad_program  # noqa: E402
from conftest import home  # noqa: E402, F401
from first_use_test import empty_home, installed, source  # noqa: E402, F401

SHOW = """import os, traceback
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
        told = f"{core.load()._paver.__file__} {mesh.Quads} {mesh.Status}"
    except BaseException:
        told = traceback.format_exc()
    with open(os.environ["PAVER_TOLD"], "w") as file:  # what is printed FreeCAD would show in its window
        file.write(told)
    os._exit(0)


QtCore.QTimer.singleShot(1000, show)
"""


def test_a_mesh_in_the_window(installed, tmp_path):  # noqa: F811
    macro, told = tmp_path / "show.FCMacro", tmp_path / "told"
    macro.write_text(SHOW)
    done = freecad_program.run_window([str(macro)], installed, PAVER_BUILD="", PAVER_TOLD=str(told))
    assert told.exists(), done.stdout + done.stderr
    core, quads, *status = told.read_text().split()
    assert core.startswith("/usr/lib/python3/dist-packages/paver/") and status == ["Up", "to", "date"], told.read_text()
    assert int(quads) > 500
