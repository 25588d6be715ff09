"""Export and import beside the window. Commands call these; scripts that want to wait use export_mesh and import_mesh."""
import os
import shutil

import FreeCAD
import FreeCADGui
from PySide import QtCore

from paver_wb import analysis, export_mesh, import_mesh, mesh_object, meshing, preferences
from paver_wb.formats import mesh_file
from paver_wb.gui import run_control
from paver_wb.gui.base import run_status, run_task
from paver_wb.gui.base.widgets import complain, translate
from paver_wb.gui.display import drawn_mesh
from paver_wb.processes import fem_process

STATUS_TIME = 10000  # ms


def remember(path):
    preferences.parameters().SetString(preferences.LAST_FOLDER, os.path.dirname(path))


def kept(obj, folder):
    """The mesh's file under a name of its own: an undo meanwhile would take the document's away."""
    path = os.path.join(folder, "mesh.paver")
    try:
        os.link(obj.MeshFile, path)
    except OSError:
        shutil.copyfile(obj.MeshFile, path)
    return path


def export(obj, path, msh_version="4.1", ascii=False):
    """Writes the mesh of a mesh object to `path` on a thread, and gives the run_task.Task.

    Arguments, and what goes wrong before it begins, as for export_mesh.write.
    """
    mesh_object.path_of(obj)
    export_mesh.ending_of(path)
    sources = mesh_object.sources(obj)
    references, is_alone = analysis.references(obj, sources), len(sources) < 2
    export_mesh.warn(obj)

    def work(task):
        export_mesh.write_file(mesh_file.read(file), file, path, references, is_alone, task.folder, task.cancel,
                               msh_version=msh_version, ascii=ascii, progress=task.tell)

    def take(_):
        remember(path)
        FreeCADGui.getMainWindow().statusBar().showMessage(translate("Paver", "Written: {}").format(path), STATUS_TIME)
    task = run_task.Task(translate("Paver", "Writing {}").format(os.path.basename(path)), obj.Document, work, take)
    file = kept(obj, task.folder)
    run_status.watch(task)
    task.begin()
    return task


def mesh_and_export(obj, path, msh_version="4.1", ascii=False):
    """Meshes a mesh object beside the window, then writes it as export() does; gives the run_control.Run. Nothing is written
    where that fails, is stopped, or leaves holes."""
    export_mesh.ending_of(path)

    def go_on(outcome):
        fault = export_mesh.fault_of(obj) if outcome.kind == run_control.MESHED else ""
        if fault:
            complain(translate("Paver", "{} Nothing was written.").format(fault))
        elif outcome.kind == run_control.MESHED:
            export(obj, path, msh_version, ascii)
    run = run_control.start(obj)
    run.ended.connect(lambda outcome: QtCore.QTimer.singleShot(0, lambda: go_on(outcome)))
    return run


def import_file(document, path):
    """Reads a mesh on a thread and makes a mesh object of it, as one step of undo; gives the run_task.Task."""
    label, name = os.path.splitext(os.path.basename(path))[0], document.Name

    def work(task):
        mesh = import_mesh.read(path, lambda path: fem_process.read(path, task.folder, task.cancel))
        if task.cancel.is_set():
            return None
        file = os.path.join(task.folder, "made.paver")
        mesh_file.write(mesh, file)
        drawn = drawn_mesh.DrawnMesh(mesh)
        drawn.prepare(0)
        return mesh, file, drawn

    def take(made):
        document = FreeCAD.listDocuments().get(name)
        if document is None:
            raise ValueError(translate("Paver", "The document was closed before '{}' was read.").format(label))
        mesh, file, drawn = made
        with meshing.transaction(document, "Import mesh"):
            obj = import_mesh.add_mesh(document, mesh, label, file)
            analysis.join_active(obj)
        drawn_mesh.offered.put(obj.MeshFile, drawn)
        remember(path)
        FreeCADGui.SendMsgToActiveView("ViewFit")
    return run_task.begin(translate("Paver", "Reading {}").format(os.path.basename(path)), document, work, take)
