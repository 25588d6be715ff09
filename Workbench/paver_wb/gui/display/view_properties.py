"""The properties of the view object that say what is drawn. They are saved with the document."""
from paver_wb.base.proxies import add_property
from paver_wb.base.texts import tip
from paver_wb.gui.display import colour_maps, colouring
from paver_wb.gui.display.emphasis import isolation
from paver_wb.gui.display.panels import CORNERS

COLOURS, SHAPE, MARKS = tip("Paver colours"), tip("Paver shape"), tip("Paver marks")

# name: (type, group, tooltip, first value or list of choices, first choice)
PROPERTIES = {
    "ColourBy": ("App::PropertyEnumeration", COLOURS, tip("What the colours of the elements tell; local target: as "
                 "media, refinements and curvature make it; Certificate: whether the curved element is proven not to fold"), list(colouring.CHOICES),
                 colouring.SJ),
    "ColourMap": ("App::PropertyEnumeration", COLOURS, tip("Colours of figures; Standard: one made for the quantity"),
                  [colouring.OWN_MAP, *colour_maps.NAMES]),
    "ColourRange": ("App::PropertyEnumeration", COLOURS, tip("Standard: the same for all meshes; Data: from the least to the "
                    "most of this mesh; Manual: from RangeLow to RangeHigh"), list(colouring.RANGES)),
    "RangeLow": ("App::PropertyFloat", COLOURS, tip("Lower end of the colours with ColourRange Manual"), 0.0),
    "RangeHigh": ("App::PropertyFloat", COLOURS, tip("Upper end of the colours with ColourRange Manual"), 1.0),
    "ColourBar": ("App::PropertyBool", COLOURS, tip("Shows the colour bar with its histogram in the view"), True),
    "LegendCorner": ("App::PropertyEnumeration", COLOURS, tip("Corner of the view for the colour bar; those of several meshes "
                     "stand side by side"), list(CORNERS)),
    "Shaded": ("App::PropertyBool", COLOURS, tip("Light and shade; without them the colours are those of the colour bar "
               "exactly"), True),
    "Subdivision": ("App::PropertyIntegerConstraint", SHAPE, tip("Straight pieces per element edge; 0: as many as the "
                    "curvature needs and the number of elements allows"), (0, 0, 32, 1)),
    "ShrinkFactor": ("App::PropertyFloatConstraint", SHAPE, tip("Size of the drawn elements, 1: whole; smaller ones leave "
                     "gaps that show every element alone"), (1.0, 0.05, 1.0, 0.05)),
    "EdgeColour": ("App::PropertyColor", SHAPE, tip("Colour of the element edges"), (0.13, 0.14, 0.16)),
    "AlwaysAllEdges": ("App::PropertyBool", SHAPE, tip("Draws the element edges also where they lie so close that they would "
                       "cover the colours"), False),
    "ShowNormals": ("App::PropertyBool", MARKS, tip("Shows the outward normal of every element"), False),
    "ShowFreeEdges": ("App::PropertyBool", MARKS, tip("Marks mesh edges with one element only, and those with more than two"),
                      False),
    "ShowNodes": ("App::PropertyBool", MARKS, tip("Shows the nodes, with PointSize and PointColor"), False),
    "ShowTriangles": ("App::PropertyBool", MARKS, tip("Marks the triangles"), False),
    "ShowWorst": ("App::PropertyIntegerConstraint", MARKS, tip("Marks so many elements with the least scaled Jacobian"),
                  (0, 0, 1000, 1)),
    "Isolate": ("App::PropertyEnumeration", MARKS, tip("Shows a part of the mesh alone; Worst elements: as many as ShowWorst "
                "asks for; Listed elements: those of IsolatedElements"), list(isolation.CHOICES)),
    "IsolatedElements": ("App::PropertyIntegerList", MARKS, tip("Numbers of the elements that Isolate shows"), []),
    "HiddenFaces": ("App::PropertyStringList", MARKS, tip("Names of faces and objects whose elements are not shown: Face3, "
                    "Box/Face3, Box"), []),
    "ElementReport": ("App::PropertyBool", MARKS, tip("Shows figures of the element that was clicked last in the view"), True),
}


def add_to(vobj):
    """Adds the properties that the view object does not have yet."""
    for name, (kind, group, tooltip, *values) in PROPERTIES.items():
        add_property(vobj, kind, name, group, tooltip, *values)


def look(vobj):
    """(opacity from 0 to 1, width of lines, size of points) of FreeCAD's own properties."""
    return 1 - vobj.Transparency / 100, float(getattr(vobj, "LineWidth", 2)), float(getattr(vobj, "PointSize", 5))


def point_colour(vobj):
    return tuple(getattr(vobj, "PointColor", vobj.EdgeColour))[:3]


def shape_colour(vobj):
    """(red, green, blue) of elements that tell nothing by their colour."""
    if hasattr(vobj, "ShapeColor"):
        return vobj.ShapeColor[:3]
    return vobj.ShapeAppearance[0].DiffuseColor[:3]  # its name from FreeCAD 1.0 on


def wish(vobj):
    """What the colours shall tell."""
    return colouring.Wish(vobj.ColourBy, vobj.ColourMap, vobj.ColourRange, (vobj.RangeLow, vobj.RangeHigh))
