"""FreeCAD's program with a private profile that has this checkout as its only add-on."""
import os
import shutil
import subprocess

from repo import ROOT


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
