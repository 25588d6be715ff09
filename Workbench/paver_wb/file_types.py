"""Meshes in FreeCAD's own dialogs for files: File > Import, File > Export. Init.py names this module."""
import os

import FreeCAD

from paver_wb import export_mesh, import_mesh, mesh_object, meshing


def insert(path, document_name):
    """FreeCAD calls it to import a file into a document."""
    document = FreeCAD.getDocument(document_name)
    with meshing.transaction(document, "Import mesh"):
        return import_mesh.add(document, path)


def open(path):
    """FreeCAD calls it to open a file: in a document of its own."""
    document = FreeCAD.newDocument(os.path.splitext(os.path.basename(path))[0])
    insert(path, document.Name)
    return document


def export(objects, path):
    """FreeCAD calls it to export the selected objects, of which one must be a mesh."""
    meshes = [obj for obj in objects if mesh_object.is_mesh(obj)]
    if len(meshes) != 1:
        raise ValueError("Select one mesh object of Paver to export; each goes to a file of its own.")
    export_mesh.write(meshes[0], path)
