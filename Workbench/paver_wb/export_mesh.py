"""Mesh objects to files: Paver's own formats with all nodes, those of FreeCAD's FEM workbench with quad8."""
import os
import re
import tempfile
from contextlib import contextmanager

import FreeCAD

from paver_wb import analysis, core, mesh_object, statistics
from paver_wb.formats import fem_mesh, mesh_file
from paver_wb.processes import child_process, fem_process

# ending: what it is; in the order in which they are offered
OWN = {"msh": "Gmsh", "vtu": "VTK"}
QT_TRANSLATE_NOOP, translate = FreeCAD.Qt.QT_TRANSLATE_NOOP, FreeCAD.Qt.translate
FEM = {"unv": QT_TRANSLATE_NOOP("Paver", "I-DEAS universal file"), "inp": "Abaqus, CalculiX", "med": "Salome MED", "z88": "Z88",
       "dat": QT_TRANSLATE_NOOP("Paver", "Nastran-like DAT"), "stl": QT_TRANSLATE_NOOP("Paver", "STL, flat triangles")}


class NotWritten(ValueError):
    """A mesh cannot be written. The text is one sentence."""


class CannotHold(NotWritten):
    """The format cannot hold the mesh, or is none."""


def write(obj, path, msh_version="4.1", ascii=False):
    """Writes the mesh of a mesh object to `path`, by its ending, whole or not at all; changes nothing in the document.

    msh_version "4.1" or "2.2", ascii: for .msh and .vtu. NotWritten with what to do; ValueError when it is not meshed.
    """
    ending, mesh = ending_of(path), mesh_object.stored(obj)
    warn(obj)
    if ending in OWN:
        write_own(mesh, path, msh_version, ascii)
    else:
        with whole_file(path) as part:
            fem_mesh.write(mesh, mesh_object.groups_of(obj, mesh), part)
    return path


def fault_of(obj):
    """A sentence on why a mesh object's mesh is not what its options and shapes ask for; empty where it is."""
    try:
        mesh_object.check(obj)
    except core.CoreMissing:  # what is recorded has to do
        pass
    state = mesh_object.state_of(obj)
    if state == mesh_object.OUT_OF_DATE:
        return translate("Paver", "The mesh of '{}' is out of date ({}).").format(obj.Label, mesh_object.changes_text(obj))
    if state == mesh_object.FACES_FAILED:
        return translate("Paver", "The mesh of '{}' has holes: {} could not be meshed.").format(
            obj.Label, ", ".join(re.match(r".*?Face\d+(?=: )|.*", text)[0] for text in obj.FailedFaces))
    return ""


def warn(obj):
    """Tells the report view what is wrong with a mesh that is written all the same."""
    fault = fault_of(obj)
    if fault:
        FreeCAD.Console.PrintWarning(translate("Paver", "{} It is written as it is.").format(fault) + "\n")


def ending_of(path):
    """One of OWN and FEM. CannotHold for another one."""
    ending = os.path.splitext(path)[1].lower().lstrip(".")
    if ending not in OWN and ending not in FEM:
        known = ", ".join("." + e for e in (*OWN, *FEM))
        raise CannotHold(f"{os.path.basename(path)} has none of the endings {known}; choose one of them.")
    return ending


def write_own(mesh, path, msh_version="4.1", ascii=False, progress=None, cancel=None):
    """Writes a StoredMesh to .msh or .vtu, in any thread. NotWritten; paver.Cancelled when it is stopped."""
    paver = core.load()
    try:
        statistics.surface_mesh(mesh).write(path, face_names=mesh_file.group_names(mesh), edge_names=mesh.edge_names,
                                            edge_groups=mesh.edge_groups, point_names=mesh.point_names, volumes=mesh.volumes,
                                            msh_version=msh_version, ascii=ascii, progress=progress, cancel=cancel)
    except paver.Cancelled:
        raise
    except paver.Error as error:
        raise NotWritten(str(error)) from None


def write_file(mesh, file, path, references, is_alone, folder, cancel=None, **more):
    """Writes a StoredMesh, which is in `file` too, by the ending of `path`, in any thread. references, is_alone: as those of
    analysis.groups_of; folder: for what is needed meanwhile; more: arguments of write_own. Errors as there; ChildDied."""
    if ending_of(path) in OWN:
        write_own(mesh, path, cancel=cancel, **more)
        return
    groups = analysis.groups_of(references, mesh.face_names, is_alone)
    with whole_file(path) as part:
        fem_process.write(file, groups, part, folder, cancel)


@contextmanager
def whole_file(path):
    """Gives a path to write to, in a folder of its own, and moves what is there to `path`; errors become NotWritten.

    The name stays the same: MED files have it inside, too.
    """
    folder, name = os.path.split(os.path.abspath(path))
    try:
        with tempfile.TemporaryDirectory(prefix=".paver", dir=folder) as own:
            yield os.path.join(own, name)
            os.replace(os.path.join(own, name), os.path.join(folder, name))
    except (core.load().Cancelled, child_process.ChildDied):
        raise
    except fem_mesh.NoFemMesh as error:
        raise CannotHold(str(error)) from None
    except fem_mesh.Incomplete as error:
        raise NotWritten(str(error)) from None
    except Exception as error:
        raise NotWritten(f"{path} cannot be written ({str(error).strip()}); check the folder.") from None
