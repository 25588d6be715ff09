"""Paver in FreeCAD. The modules of this folder work without a window; `gui` has what needs one."""
