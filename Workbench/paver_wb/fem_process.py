"""FreeCAD's formats of files, read and written in a process of its own.

FreeCAD reads and writes them in one call that keeps every other Python waiting, and with it the window; half a million
elements take it many seconds. The process is Python with FreeCAD's modules: fem_child.py.
"""
import json
import os
import shutil
import sys

import numpy as np

from paver_wb import child_process, fem_mesh, mesh_file, read_fem
from paver_wb.raw_mesh import Damaged, Tables

TASK, TABLES, MAIN = "task.json", "tables.npz", "fem_child.py"
ARRAYS = ("nodes", "quads", "triangles", "quad_faces", "triangle_faces")
ERRORS = {"Damaged": Damaged, "NoFemMesh": fem_mesh.NoFemMesh}


def folders():
    """Where FreeCAD's modules lie, those in Python too, which it calls for some formats."""
    import FreeCAD
    library = FreeCAD.getLibraryDir() if hasattr(FreeCAD, "getLibraryDir") else os.path.join(FreeCAD.getHomePath(), "lib")
    return [library, *(folder for folder in sys.path if os.path.isabs(folder))]


def run(task, folder, cancel):
    """Does a task, a dict, in a process that uses `folder`. ValueError with the process's own sentence, ChildDied when
    it ends without one, Cancelled when it is stopped."""
    with open(os.path.join(folder, TASK), "w", encoding="utf-8") as file:
        json.dump({**task, "folders": folders()}, file)
    profile = os.path.join(folder, "profile")  # the user's own is this FreeCAD's alone
    os.makedirs(profile, exist_ok=True)
    status, last, log = child_process.supervise(child_process.command(folder, MAIN), folder, cancel=cancel,
                                                variables={"FREECAD_USER_HOME": profile})
    shutil.rmtree(profile, ignore_errors=True)
    if "error" in last:
        raise ERRORS.get(last["class"], ValueError)(last["error"])
    if "done" not in last:
        error = child_process.ChildDied(f"FreeCAD's part that reads and writes such files ended without a result (exit "
                                        f"code {status}); FreeCAD itself is as before, use .msh or .vtu instead.")
        error.log = log
        raise error


def write(stored, groups, path, folder, cancel=None):
    """Writes the mesh in the file `stored` to `path`, by its ending; groups: {name: numbers of faces}."""
    if not is_possible():
        fem_mesh.write(mesh_file.read(stored), groups, path)
        return
    run({"write": stored, "groups": {name: sorted(faces) for name, faces in groups.items()}, "path": path}, folder,
        cancel)


def read(path, folder, cancel=None):
    """raw_mesh.Tables of a file that FreeCAD reads. Damaged when it does not."""
    if not is_possible():
        return read_fem.tables(path)
    run({"read": os.path.abspath(path)}, folder, cancel)
    made = np.load(os.path.join(folder, TABLES))
    return Tables(int(made["order"]), *(made[name] for name in ARRAYS), made["names"].tolist())


def is_possible():
    """Whether there is a Python to run it in; without one FreeCAD itself has to do it."""
    try:
        child_process.interpreter()
    except child_process.ChildDied:
        return False
    return True
