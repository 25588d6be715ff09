"""What needs FreeCAD's window."""
