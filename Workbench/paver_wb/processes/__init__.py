"""Meshing as data, and the processes that do it for FreeCAD."""
