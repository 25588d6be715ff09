"""FreeCAD runs this as text when its window is made, after Init.py."""


def _add_workbench():
    from paver_wb.gui import workbench
    workbench.register()


_add_workbench()
FreeCAD.__unit_test__ += ["TestPaverGui"]  # noqa: F821, FreeCAD is there when it runs this
