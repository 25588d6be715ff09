"""Mesh objects to files: Paver's own formats with all nodes, those of FreeCAD's FEM workbench with quad8."""
import os
import tempfile

from paver_wb import core, fem_mesh, mesh_object, statistics

# ending: what it is; in the order in which they are offered
OWN = {"msh": "Gmsh", "vtu": "VTK"}
FEM = {"unv": "I-DEAS universal file", "inp": "Abaqus, CalculiX", "med": "Salome MED", "z88": "Z88", "dat": "Nastran-like DAT",
       "stl": "STL, flat triangles"}


class NotWritten(ValueError):
    """A mesh cannot be written. The text is one sentence."""


class CannotHold(NotWritten):
    """The format cannot hold the mesh, or is none."""


def write(obj, path, msh_version="4.1", ascii=False):
    """Writes the mesh of a mesh object to `path`, by its ending, whole or not at all; changes nothing in the document.

    msh_version "4.1" or "2.2", ascii: for .msh and .vtu. NotWritten with what to do; ValueError when it is not meshed.
    """
    ending = os.path.splitext(path)[1].lower().lstrip(".")
    mesh = mesh_object.stored(obj)
    if ending in OWN:
        try:
            statistics.surface_mesh(mesh).write(path, face_names=mesh.face_names, edge_names=mesh.edge_names,
                                                msh_version=msh_version, ascii=ascii)
        except core.load().Error as error:
            raise NotWritten(str(error)) from None
    elif ending in FEM:
        write_fem(obj, mesh, path)
    else:
        known = ", ".join("." + e for e in (*OWN, *FEM))
        raise CannotHold(f"{os.path.basename(path)} has none of the endings {known}; choose one of them.")
    return path


def write_fem(obj, mesh, path):
    """Through FreeCAD, in a folder of its own first. The name stays the same: MED files have it inside, too."""
    folder, name = os.path.split(os.path.abspath(path))
    try:
        fem = obj.FemMesh if obj.FemMeshFilled else mesh_object.fem_mesh_of(obj, mesh)
        with tempfile.TemporaryDirectory(prefix=".paver", dir=folder) as own:
            part = os.path.join(own, name)
            fem.write(part)
            os.replace(part, os.path.join(folder, name))
    except fem_mesh.NoFemMesh as error:
        raise CannotHold(str(error)) from None
    except Exception as error:
        raise NotWritten(f"{path} cannot be written ({str(error).strip()}); check the folder.") from None
