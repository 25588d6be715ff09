"""Paver in FreeCAD. The modules of this folder work without a window; `gui` has what needs one."""

# Modules and folders, from the lowest on: none imports what comes later. "" is this folder, "gui" that folder, less what
# has an entry of its own. tests/repo/layers_test.py checks it.
LAYERS = ("core", "base", "formats", "processes", "children", "", "gui.base", "gui.display", "gui.run_place", "gui.setup",
          "gui.commands", "gui.preview", "gui.panels", "gui")
