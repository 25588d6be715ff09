"""Meshes in files: the document's own, FreeCAD's FemMesh, and what is read from others."""
