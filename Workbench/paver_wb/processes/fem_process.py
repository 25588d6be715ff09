"""FreeCAD's formats of files, read and written in a process of its own, and looks at shapes before they are meshed.

FreeCAD reads and writes files in one call that keeps every other Python waiting, and with it the window; half a million
elements take it many seconds. The process is Python with FreeCAD's modules.
"""
import os
import shutil
import sys

from paver_wb.formats import fem_mesh, mesh_file, raw_mesh, read_fem
from paver_wb.processes import child_process, model_look

TABLES, LOOK = "tables.npz", "look.npz"
ERRORS = {"Damaged": raw_mesh.Damaged, "NoFemMesh": fem_mesh.NoFemMesh, "Incomplete": fem_mesh.Incomplete}


def folders():
    """Where FreeCAD's modules lie, those in Python too, which it calls for some formats."""
    import FreeCAD
    library = FreeCAD.getLibraryDir() if hasattr(FreeCAD, "getLibraryDir") else os.path.join(FreeCAD.getHomePath(), "lib")
    return [library, *(folder for folder in sys.path if os.path.isabs(folder))]


def error_of(event):
    return ERRORS.get(event["code"], ValueError)(event["sentence"])


def death(status, _last):
    return (f"FreeCAD's part that reads and writes such files ended without a result (exit code {status}); FreeCAD itself is "
            "as before, use .msh or .vtu instead.")


def look_death(status, _last):
    return (f"Looking at the shapes ended without a result (exit code {status}); FreeCAD itself is as before, mesh without a "
            "preview.")


def run(content, folder, cancel, error_of=error_of, death=death):
    """Does a job in a process that uses `folder`. ValueError with the process's own sentence, ChildDied when it ends
    without one, Cancelled when it is stopped."""
    child_process.write_content({**content, "folders": folders()}, folder)
    profile = os.path.join(folder, "profile")  # the user's own is this FreeCAD's alone
    os.makedirs(profile, exist_ok=True)
    child_process.do(folder, error_of, death, cancel=cancel, variables={"FREECAD_USER_HOME": profile})
    shutil.rmtree(profile, ignore_errors=True)


def write(stored, groups, path, folder, cancel=None):
    """Writes the mesh in the file `stored` to `path`, by its ending; groups: {name: numbers of faces}."""
    if is_possible():
        run({"input": stored, "groups": {name: sorted(faces) for name, faces in groups.items()}, "mesh": path}, folder,
            cancel)
    else:
        fem_mesh.write(mesh_file.read(stored), groups, path)


def read(path, folder, cancel=None):
    """raw_mesh.Tables of a file that FreeCAD reads. Damaged when it does not."""
    if not is_possible():
        return read_fem.tables(path)
    run({"input": os.path.abspath(path), "mesh": TABLES}, folder, cancel)
    return raw_mesh.load(os.path.join(folder, TABLES))


def look(job, folder, cancel=None):
    """model_look.Look of a mesh_job.Job. Errors as those of paver.mesh, ChildDied, Cancelled."""
    if not is_possible():
        return model_look.look(job)
    run(child_process.content_of(job, folder, LOOK), folder, cancel, child_process.error_of, look_death)
    return model_look.load(os.path.join(folder, LOOK))


def is_possible():
    """Whether there is a Python to run it in; without one FreeCAD itself has to do it."""
    try:
        child_process.interpreter()
    except child_process.ChildDied:
        return False
    return True
