"""Models whose parts touch: from the file, as an App::Part and as a list of objects they come to the same."""
import os
import sys

import pytest

from conftest import BINDINGS
from freecad_test import LIBRARIES, need

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "../support"))
import runs  # noqa: E402

MODELS = sorted(name for name in os.listdir(os.path.join(runs.SHARED, "contact")) if name.endswith(".step")) if os.path.isdir(
    os.path.join(runs.SHARED, "contact")) else [""]


def outline(result):
    report = result.report
    return (len(report["components"]), report["model"]["nonmanifold_edges"], report["model"]["free_edges"],
            sum(face["status"] == "meshed" for face in report["faces"]), len(result.quads), len(result.lines))


@pytest.fixture(scope="module")
def freecad():
    """FreeCAD's modules in this Python."""
    need(LIBRARIES)
    sys.path[:0] = [BINDINGS]
    sys.path.append(LIBRARIES)
    import FreeCAD
    import Part
    return FreeCAD, Part


@pytest.mark.parametrize("name", MODELS)
def test_what_touches_is_connected_however_it_comes(freecad, name):
    path = runs.need_shared("contact", name)
    FreeCAD, Part = freecad
    import paver
    shape = Part.Shape()
    shape.read(path)
    document = FreeCAD.newDocument()
    part, members = document.addObject("App::Part", "Part"), []
    for member in shape.SubShapes:
        members.append(document.addObject("Part::Feature", "Member"))
        members[-1].Shape = member
        part.addObject(members[-1])
    document.recompute()
    size = shape.BoundBox.DiagonalLength / 12
    wanted, whole, listed = (outline(paver.mesh(thing, size=size, partial=True)) for thing in (path, part, members))
    FreeCAD.closeDocument(document.Name)
    assert whole == wanted
    assert listed == wanted
