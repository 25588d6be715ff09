"""FreeCAD's program with a private profile that has this checkout as its only add-on."""
import os
import shutil
import subprocess

from repo import ROOT

# Without the start page, which needs a browser and does not start for root, and without FreeCAD 1.0's questions about
# STEP files.
PREFERENCES = """<?xml version="1.0" encoding="UTF-8" standalone="no" ?>
<FCParameters><FCParamGroup Name="Root"><FCParamGroup Name="BaseApp"><FCParamGroup Name="Preferences">
<FCParamGroup Name="General"><FCText Name="AutoloadModule">PartWorkbench</FCText>
<FCBool Name="ShowSplasher" Value="0"/></FCParamGroup>
<FCParamGroup Name="Mod"><FCParamGroup Name="Start"><FCBool Name="ShowOnStartup" Value="0"/></FCParamGroup>
<FCParamGroup Name="Part"><FCParamGroup Name="STEP"><FCBool Name="VisibleImportDialog" Value="0"/></FCParamGroup>
</FCParamGroup></FCParamGroup>
</FCParamGroup></FCParamGroup></FCParamGroup></FCParameters>
"""


def profile(folder):
    """Makes `folder` a user folder of FreeCAD's own, with this checkout as Mod/Paver."""
    os.makedirs(os.path.join(folder, "Mod"))
    os.symlink(ROOT, os.path.join(folder, "Mod", "Paver"))
    return str(folder)


def program():
    return shutil.which("freecadcmd") or shutil.which("FreeCADCmd")


def run(arguments, home, timeout=600, **environment):
    """CompletedProcess of freecadcmd with output as text. FreeCAD reads its input where it is left without a script."""
    return subprocess.run([program(), *arguments], capture_output=True, text=True, stdin=subprocess.DEVNULL,
                          timeout=timeout, cwd=home, env={**os.environ, "FREECAD_USER_HOME": home, **environment})


def window_programs():
    """FreeCAD with its window, and what gives it a screen; None for one that is not installed."""
    return shutil.which("freecad") or shutil.which("FreeCAD"), shutil.which("xvfb-run")


def need_window():
    """Ends a test as skipped where there is none; in CI nothing may be missing."""
    import pytest
    if not all(window_programs()):
        (pytest.fail if os.environ.get("CI") == "true" else pytest.skip)("FreeCAD's window or Xvfb is not installed")


def run_window(arguments, home, timeout=600, size="1600x1000x24", **environment):
    """CompletedProcess of FreeCAD with its window, on a screen of its own, with output as text. size: what Xvfb has behind -screen 0."""
    window, screen = window_programs()
    if not window or not screen:
        need_window()
    with open(os.path.join(home, "user.cfg"), "w") as file:
        file.write(PREFERENCES)
    return subprocess.run([screen, "-a", "-s", f"-screen 0 {size}", window, *arguments], capture_output=True,
                          text=True, stdin=subprocess.DEVNULL, timeout=timeout, cwd=home,
                          env={**os.environ, "FREECAD_USER_HOME": home, **environment})
