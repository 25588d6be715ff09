"""What new mesh objects start with, from the preferences."""
import FreeCAD

from paver_wb import mesh_object

FACETS_ALONG = 20  # elements along the diagonal of what is selected, for a first size
LAST_FOLDER = "LastFolder"  # of files that were read or written
ELEMENTS = ("quad-dominant", "all-quad", "all-triangle")  # in the order of the preference page


def parameters():
    return FreeCAD.ParamGet(mesh_object.PREFERENCES)


def first_size(things, along):
    """Target length for a first mesh, mm, of one digit; 1 for things without an extent."""
    import Part
    boxes = [shape.BoundBox for shape in map(Part.getShape, things) if not shape.isNull()]
    diagonals = [box.DiagonalLength for box in boxes if box.isValid()]  # that of an empty compound is not
    size = max(diagonals, default=0) / along
    return float(f"{size:.0e}") if size > 0 else 1.0


def new_options(things):
    """{option: value} for a mesh object of these objects; only what differs from the core's own defaults. Does not ask the
    core, which may be missing."""
    stored = parameters()
    frequency = stored.GetFloat("NewFrequency", 0)  # GHz
    if frequency > 0:
        options = {"frequency": f"{frequency:g} GHz", "divisions": stored.GetFloat("NewDivisions", 10)}
    else:
        options = {"size": first_size(things, max(1, stored.GetInt("NewFacetsAlong", FACETS_ALONG)))}
    order, elements = stored.GetInt("NewOrder", 1) + 1, stored.GetInt("NewElements", 0)
    if order != 2:
        options["order"] = order
    if 0 < elements < len(ELEMENTS):
        options["elements"] = ELEMENTS[elements]
    gradation = stored.GetFloat("NewGradation", 0.6)
    if abs(gradation - 0.6) > 1e-9:
        options["gradation"] = gradation
    return options
