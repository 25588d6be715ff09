"""Meshes from files as mesh objects: Gmsh, VTK, and what FreeCAD's FEM workbench reads."""
import os

import numpy as np

from paver_wb import mesh_object, meshing, statistics
from paver_wb.formats import mesh_file, raw_mesh, read_fem, read_msh, read_vtu
from paver_wb.formats.raw_mesh import Damaged

OWN = {".msh": read_msh.read, ".vtu": read_vtu.read}
FEM = (".unv", ".med", ".inp", ".bdf", ".z88", ".vtk", ".stl", ".frd")


def read(path, fem_tables=read_fem.tables):
    """StoredMesh of a file, by its ending. Damaged, with one sentence, when it cannot be read.

    fem_tables(path): raw_mesh.Tables of what FreeCAD reads.
    """
    name = os.path.basename(path)
    ending = os.path.splitext(name)[1].lower()
    try:
        if ending in OWN:
            with open(path, "rb") as file:
                tables = raw_mesh.tables(OWN[ending](file.read()))
        elif ending in FEM:
            tables = fem_tables(path)
        else:
            raise Damaged("its ending is none of " + ", ".join([*OWN, *FEM]))
        return stored(tables, name)
    except OSError as error:
        raise Damaged(f"{name} cannot be read: {error.strerror}.") from None
    except Damaged as error:
        raise Damaged(f"{name} cannot be read: {error}.") from None
    except (ValueError, IndexError, OverflowError, MemoryError) as error:
        raise Damaged(f"{name} cannot be read: its content is damaged ({error}).") from None


def stored(tables, source):
    """StoredMesh with the part of a report that is known."""
    mesh = mesh_file.StoredMesh(tables.order, tables.nodes, tables.quads, tables.triangles, tables.quad_faces,
                                tables.triangle_faces, np.zeros((0, tables.order + 1), np.int32), np.zeros(0, np.int32),
                                tables.names, [], {})
    figures = statistics.of_mesh(mesh)
    sj = figures.sj.min()
    report = {"model": {"file": source}, "target_length": float(figures.lengths.mean()), "order": tables.order,
              "quality": {"quads": figures.quads, "triangles": figures.triangles, "nodes": figures.nodes,
                          "sj": {"all": {"min": float(sj), "mean": float(figures.sj.mean())}},
                          "watertight": bool((figures.users == 2).all())},
              "faces": [{"name": name, "status": "meshed"} for name in tables.names],
              "notes": [f"Imported from {source}; the target length is the mean length of the edges."]}
    return mesh._replace(report=report)


def add(document, path, name=""):
    """A mesh object of a file, without anything to mesh. Damaged when the file cannot be read."""
    return add_mesh(document, read(path), name or os.path.splitext(os.path.basename(path))[0])


def add_mesh(document, mesh, label, file=None):
    """A mesh object of a StoredMesh, which is in `file` already, if that is given: it is moved into the document."""
    obj = mesh_object.add(document, [], label)
    try:
        obj.Label = label
        mesh_object.keep(obj, file or mesh)
        meshing.show_results(obj, mesh)
        obj.MeshedOptions, obj.MeshedShape = mesh_object.decisive(obj), mesh_object.shape_digest(obj)
        if meshing.is_filled_unasked(mesh):
            mesh_object.fill(obj, mesh)
        mesh_object.update_status(obj)
        mesh_object.untouch(obj)
    except BaseException:
        document.removeObject(obj.Name)
        raise
    return obj
