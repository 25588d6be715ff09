"""FreeCAD runs this as text when its window is made, after Init.py."""


def _add_workbench():
    import FreeCADGui
    from paver_wb.gui.workbench import PaverWorkbench
    FreeCADGui.addWorkbench(PaverWorkbench())


_add_workbench()
FreeCAD.__unit_test__ += ["TestPaverGui"]  # noqa: F821, FreeCAD is there when it runs this
