"""FreeCAD runs this at its start, without a window too: `import paver` works in macros and in the Python console, and
documents find the modules of the workbench.

It is run as text, so it does not know its own path: the folder is the entry of sys.path that FreeCAD just made for it.
"""


def _add_folders():
    """Before all others, as the system may have a package `paver` of another version. Its compiled part is used where
    the version is the same, and so is a binary in FreeCAD's folder for it."""
    import os
    import sys
    for folder in list(sys.path):
        added = [os.path.join(folder, "bindings"), os.path.join(folder, "Workbench")]
        if all(os.path.isfile(os.path.join(f, p, "__init__.py")) for f, p in zip(added, ("paver", "paver_wb"))):
            sys.path[:0] = added
            from paver_wb import core
            sys.path.insert(len(added), core.binary_folder())
            return


_add_folders()
FreeCAD.addImportType("Gmsh mesh (*.msh)", "paver_wb.file_types")  # noqa: F821
FreeCAD.addExportType("Gmsh mesh of Paver (*.msh)", "paver_wb.file_types")  # noqa: F821
FreeCAD.addExportType("VTK mesh of Paver (*.vtu)", "paver_wb.file_types")  # noqa: F821
FreeCAD.__unit_test__ += ["TestPaver"]  # noqa: F821, FreeCAD is there when it runs this
