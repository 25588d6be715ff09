"""The models that come with Paver."""
import os

import FreeCAD

from paver_wb.base.paths import EXAMPLES

translate = FreeCAD.Qt.translate


def names():
    """File names, in alphabetical order."""
    return sorted(name for name in os.listdir(EXAMPLES) if name.endswith((".step", ".brep")))


def titles():
    """{file name: (what it is, what it shows)}."""
    return {
        "box.step": (translate("Paver", "Box"), translate("Paver", "Six plane faces: a regular grid on each")),
        "box_cylinder.step": (translate("Paver", "Box with a cylinder"), translate(
            "Paver", "A periodic face between plane ones")),
        "conesphere.step": (translate("Paver", "Cone-sphere"), translate("Paver", "The tip of a cone and a half sphere")),
        "conesphere_gap.step": (translate("Paver", "Cone-sphere with a groove"), translate(
            "Paver", "Narrow rings beside large faces")),
        "conesphere_one_face.brep": (translate("Paver", "Cone-sphere as one face"), translate(
            "Paver", "One face of revolution with a pole at either end")),
        "disk_tiny_hole.step": (translate("Paver", "Disk with a tiny hole"), translate(
            "Paver", "Element sizes from 1 to 20 in one face")),
        "plate_circular_hole.step": (translate("Paver", "Plate with a round hole"), translate(
            "Paver", "Rows from a circle meet rows from straight sides")),
        "plate_nine_holes.step": (translate("Paver", "Plate with nine holes"), translate(
            "Paver", "Ten loops in one face")),
        "plate_rect_hole.step": (translate("Paver", "Plate with a rectangular hole"), translate(
            "Paver", "Corners that turn outwards")),
        "pyramid.step": (translate("Paver", "Pyramid"), translate("Paver", "Acute corners, faces of three sides")),
        "sphere.step": (translate("Paver", "Sphere"), translate("Paver", "One closed face with two poles")),
        "torus.step": (translate("Paver", "Torus"), translate("Paver", "Closed both ways, no border at all")),
        "wavy_patch.step": (translate("Paver", "Wavy patch"), translate("Paver", "A B-spline surface, curved both ways")),
        "wind_generator.brep": (translate("Paver", "Wind generator"), translate(
            "Paver", "Faces of very different size, twisted blades")),
        "wing.step": (translate("Paver", "Wing"), translate("Paver", "A narrow trailing edge beside large faces")),
    }


def title(name):
    return titles().get(name, (os.path.splitext(name)[0].replace("_", " ").capitalize(), ""))[0]


def about(name):
    return titles().get(name, ("", name))[1]


def open_model(name):
    """The object of an example, alone in a new document. ValueError when there is none of that name."""
    import Part
    if name not in names():
        raise ValueError(f"There is no example {name}; there are {', '.join(names())}.")
    document = FreeCAD.newDocument(os.path.splitext(name)[0])
    obj = document.addObject("Part::Feature", os.path.splitext(name)[0].capitalize())
    obj.Label, obj.Shape = title(name), Part.read(os.path.join(EXAMPLES, name))
    document.recompute()
    return obj
