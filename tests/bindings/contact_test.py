"""Models whose parts touch: as STEP and BREP files, as an App::Part and as a list of objects they come to the same."""
import glob
import os
import sys

import pytest

from conftest import BINDINGS
from freecad_test import LIBRARIES, need

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "../support"))
import runs  # noqa: E402

OWN = ("rod on a plate", "fin on a sheet", "patch on a board", "wire on a sheet", "point on a sheet", "boxes that cross")
SHARED = [path for path in sorted(glob.glob(os.path.join(runs.SHARED, "contact", "*.step")))
          if os.path.basename(path) != "face_crosses_itself.step"]


@pytest.fixture(scope="module")
def freecad():
    """FreeCAD's modules in this Python."""
    need(LIBRARIES)
    sys.path[:0] = [BINDINGS]
    sys.path.append(LIBRARIES)
    import FreeCAD
    import Part
    return FreeCAD, Part


def members_of(FreeCAD, Part, name):
    """Shapes that touch, in millimetres."""
    at = FreeCAD.Vector
    plate = Part.makeBox(40, 30, 2)
    sheet = Part.makePlane(40, 30)
    return {"rod on a plate": lambda: [plate, Part.makeCylinder(3, 20, at(20, 15, 2))],
            "fin on a sheet": lambda: [sheet, Part.makePlane(10, 20, at(15, 15, 0), at(0, 1, 0))],
            "patch on a board": lambda: [plate, Part.makePlane(10, 8, at(10, 10, 2))],
            "wire on a sheet": lambda: [sheet, Part.makeLine(at(20, 15, 0), at(20, 15, 25))],
            "point on a sheet": lambda: [sheet, Part.Vertex(at(23, 11, 0))],
            "boxes that cross": lambda: [plate, Part.makeBox(20, 20, 20, at(30, 20, 1))]}[name]()


def outline(result):
    report = result.report
    return (len(report["components"]), report["model"]["nonmanifold_edges"], report["model"]["free_edges"],
            sum(face["status"] == "meshed" for face in report["faces"]), len(result.quads), len(result.lines))


def outlines(freecad, files, members, size):
    """Of each file, of an App::Part and of a list of objects."""
    FreeCAD, _ = freecad
    import paver
    document = FreeCAD.newDocument()
    part, objects = document.addObject("App::Part", "Part"), []
    for member in members:
        objects.append(document.addObject("Part::Feature", "Member"))
        objects[-1].Shape = member
        part.addObject(objects[-1])
    document.recompute()
    found = [outline(paver.mesh(thing, size=size)) for thing in (*files, part, objects)]
    FreeCAD.closeDocument(document.Name)
    return found


@pytest.mark.parametrize("name", OWN)
def test_it_does_not_matter_how_a_model_comes(freecad, name, tmp_path):
    members = members_of(*freecad, name)
    whole, files = freecad[1].Compound(members), [str(tmp_path / "model.step"), str(tmp_path / "model.brep")]
    whole.exportStep(files[0])
    whole.exportBrep(files[1])
    found = outlines(freecad, files, members, 4)
    assert found == found[:1] * 4
    assert found[0][0] == 1


@pytest.mark.parametrize("path", SHARED, ids=list(map(os.path.basename, SHARED)))
def test_nor_for_the_shared_models(freecad, path):
    shape = freecad[1].Shape()
    shape.read(path)
    found = outlines(freecad, [path], shape.SubShapes, shape.BoundBox.DiagonalLength / 12)
    assert found == found[:1] * 3
