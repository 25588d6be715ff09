"""Commands that read and write files."""
import os
import re

import FreeCAD
import FreeCADGui
from PySide import QtGui

from paver_wb import examples, export_mesh, import_mesh, preferences
from paver_wb.gui.base import first_view
from paver_wb.gui.commands import export_question
from paver_wb.gui.commands.common import (QT_TRANSLATE_NOOP, Command, OnMeshed, call_text, python_name, run, shown_as, target_mesh,
                                          translate)


PROPOSED = "msh"
NO_NAME = re.compile(r'[/\\:*?"<>|]')  # what names of files cannot have


def last_folder():
    return preferences.parameters().GetString(preferences.LAST_FOLDER, "")


def export_filters():
    """{text of a filter: (ending, further arguments)}, in the order of the dialog."""
    text = translate("Paver", "text")
    filters = {"Gmsh 4.1 (*.msh)": ("msh", {}), f"Gmsh 4.1, {text} (*.msh)": ("msh", {"ascii": True}),
               "Gmsh 2.2 (*.msh)": ("msh", {"msh_version": "2.2"}),
               f"Gmsh 2.2, {text} (*.msh)": ("msh", {"msh_version": "2.2", "ascii": True}),
               "VTK (*.vtu)": ("vtu", {}), f"VTK, {text} (*.vtu)": ("vtu", {"ascii": True})}
    filters.update({f"{translate('Paver', what)} (*.{ending})": (ending, {}) for ending, what in export_mesh.FEM.items()})
    return filters


def with_ending(path, ending):
    """A path with the ending of a filter, where its own is none that can be written or still the proposed one."""
    stem, own = os.path.splitext(path)
    own = own.lower().lstrip(".")
    if own == ending or own != PROPOSED and own in (*export_mesh.OWN, *export_mesh.FEM):
        return path
    return f"{stem if own == PROPOSED else path}.{ending}"


class Export(OnMeshed):
    resources = shown_as("Paver_Export", QT_TRANSLATE_NOOP("Paver_Export", "Export mesh..."), QT_TRANSLATE_NOOP(
        "Paver_Export", "Writes the mesh to a file: Gmsh and VTK with all nodes, and the formats of the FEM "
        "workbench"), "Q, E")

    def Activated(self):
        obj, filters = target_mesh(), export_filters()
        start = os.path.join(last_folder(), f"{NO_NAME.sub('-', obj.Label)}.{PROPOSED}")
        path, chosen = QtGui.QFileDialog.getSaveFileName(FreeCADGui.getMainWindow(), translate("Paver", "Export mesh"),
                                                         start, ";;".join(filters))
        if path:
            ending, more = filters[chosen]
            whole = with_ending(path, ending)
            if whole == path or not os.path.exists(whole) or export_question.may_replace(whole):
                self.ask_and_write(obj, whole, more)

    def ask_and_write(self, obj, path, more):
        """Writes the mesh; asks first where it is not what its options and shapes ask for."""
        fault = export_mesh.fault_of(obj)
        if not fault:
            self.write(obj, path, more)
            return
        answer = export_question.ask(obj, fault)
        if answer != export_question.CANCEL:
            self.write(obj, path, more, "mesh_and_export" if answer == export_question.MESH else "export")

    @staticmethod
    def write(obj, path, more, function="export"):
        """function: of gui.file_tasks."""
        run(call_text(function, python_name(obj), repr(path), **more), "paver_wb.gui.file_tasks")


class Import(Command):
    resources = shown_as("Paver_Import", QT_TRANSLATE_NOOP("Paver_Import", "Import mesh..."), QT_TRANSLATE_NOOP(
        "Paver_Import", "Makes a mesh object of a file: Gmsh, VTK, and the formats of the FEM workbench"), "Q, I")

    def Activated(self):
        endings = " ".join("*" + ending for ending in (*import_mesh.OWN, *import_mesh.FEM))
        filters = f"{translate('Paver', 'Meshes')} ({endings});;{translate('Paver', 'All files')} (*)"
        path, _ = QtGui.QFileDialog.getOpenFileName(FreeCADGui.getMainWindow(), translate("Paver", "Import mesh"),
                                                    last_folder(), filters)
        if path:
            self.read(path)

    @staticmethod
    def read(path):
        if FreeCAD.ActiveDocument is None:
            run("FreeCAD.newDocument()")
        run(f"import_file(FreeCAD.ActiveDocument, {path!r})", "paver_wb.gui.file_tasks")


class Example(Command):
    """Opens one of the models that come with Paver."""

    def __init__(self, name):
        self.name = name
        self.resources = shown_as("Paver_Example", examples.title(name), examples.about(name))

    def Activated(self):
        if run(f"open_model({self.name!r})", "paver_wb.examples"):
            first_view.show_all(FreeCADGui.ActiveDocument.ActiveView)


def example_commands():
    """{name of a command: command}."""
    return {f"Paver_Example_{os.path.splitext(name)[0]}": Example(name) for name in examples.names()}
