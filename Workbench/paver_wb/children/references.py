"""What children of a mesh object refer to: elements of its sources, as names in the shape that is meshed."""
import re

import FreeCAD

from paver_wb.base import proxies

CHILDREN = ("Refinements", "Media", "Ports", "Wires")  # properties of a mesh object
KINDS = {"Face": "Faces", "Edge": "Edges", "Vertex": "Vertexes", "Solid": "Solids"}
ELEMENT = re.compile(r"(Face|Edge|Vertex|Solid)([1-9]\d*)")
translate = FreeCAD.Qt.translate
SOLIDS_FIRST = ("Solid", "Face")  # what a whole object means: the first of these kinds that it has


class ReferenceMissing(ValueError):
    """A child of a mesh object refers to what the mesh does not have. The text is one sentence."""


def meshes_of(obj):
    """The mesh objects that have a child; one, unless a document was put together by hand."""
    return [other for other in obj.InList if proxies.is_mesh(other) and any(obj in getattr(other, link, []) for link in CHILDREN)]


def check_references(meshes, listed, whole=SOLIDS_FIRST):
    """ReferenceMissing where one of [(object, elements)] is in none of what a mesh object meshes."""
    for mesh in meshes:
        for thing, elements in listed:
            for element in elements:
                find(proxies.sources(mesh), mesh, thing, element, whole)


def as_references(mesh, references):
    """[(object, [names of elements, "" for all])]."""
    listed = []
    for entry in references:
        if isinstance(entry, str):
            entry = (mesh.Part, entry)
        thing, elements = entry if isinstance(entry, (tuple, list)) else (entry, "")
        listed.append((thing, [elements] if isinstance(elements, str) else list(elements) or [""]))
    if not listed:
        raise ReferenceMissing(translate("Paver", "What is to belong to '{}' refers to nothing; select faces, edges, vertices or "
                                         "objects.").format(mesh.Label))
    return listed


def find(sources, owner, thing, element, whole=SOLIDS_FIRST):
    """(number of the source, names of its elements) that a reference means."""
    from paver import _shapes
    for number, source in enumerate(sources):
        shape = _shapes.shape_of(source) if thing == source else None
        if shape is not None and "." not in element:
            return number, known(owner, thing, shape, element, whole)
    for number, source in enumerate(sources):
        found = inside(source, thing, element, whole)
        if found:
            return number, found
    raise ReferenceMissing(translate("Paver", "'{}' refers to {} of '{}', which is not among the objects that are meshed; refer to "
                                     "elements of those.").format(owner.Label, element or translate("Paver", "all"), thing.Label))


def elements_of(shape, whole):
    """The elements that the whole of a shape means."""
    return next(filter(None, (getattr(shape, KINDS[kind]) for kind in whole)), [])


def kinds_text(kinds):
    names = {"Face": translate("Paver", "face"), "Edge": translate("Paver", "edge"), "Vertex": translate("Paver", "vertex"),
             "Solid": translate("Paver", "solid")}
    return ", ".join(names[kind] for kind in kinds)


def known(owner, thing, shape, element, whole):
    """Names of the elements of a source's shape; `element` may be empty for the whole of it."""
    if not element:
        found = elements_of(shape, whole)
        if not found:
            raise ReferenceMissing(translate("Paver", "'{}' refers to '{}', which has no {}; choose another object.").format(
                owner.Label, thing.Label, kinds_text(whole)))
        return [f"{found[0].ShapeType}{i + 1}" for i in range(len(found))]
    match = ELEMENT.fullmatch(element)
    count = len(getattr(shape, KINDS[match.group(1)])) if match else 0
    if not match or int(match.group(2)) > count:
        raise ReferenceMissing(translate("Paver", "'{}' refers to {}, which '{}' does not have; choose the elements again."
                                         ).format(owner.Label, element, thing.Label))
    return [element]


def inside(source, thing, element, whole):
    """Names of the elements of a source that are an element of something inside it, of an object in an App::Part or a
    feature of a Body, or of something that it is inside of. Empty: neither."""
    from paver import InputError, _shapes
    if thing != source and thing not in source.OutListRecursive and source not in thing.OutListRecursive:
        return []
    shape, way = _shapes.shape_of(source), path_to(source, thing)
    try:
        wanted = _shapes.object_shape(thing, element) if way is None else _shapes.object_shape(source, way + element)
    except InputError:  # there is no such element
        return []
    parts = elements_of(wanted, whole) if not element or element.endswith(".") else [wanted]
    names = [name_in(shape, part) for part in parts]
    return names if all(names) else []


def path_to(source, thing):
    """"Group.Box." leading from an object to one inside it; None when there is no such way."""
    for name in source.getSubObjects() or [child.Name + "." for child in getattr(source, "Group", ())]:  # Bodies name none
        child = source.getSubObject(name, 1)
        further = "" if child == thing else child and path_to(child, thing)
        if further is not None:
            return name + further
    return None


def standing(top, path):
    """(object, path in it) of what FreeCAD's selection names by an object and a path in it: the innermost object that stands
    in the document where it is seen there. What is seen in a link stands elsewhere, so that is the link; what a feature
    makes is seen as the shape of its Body."""
    thing = top
    while "." in path:
        name, _, rest = path.partition(".")
        child = thing.getSubObject(name + ".", 1)
        if child is None or child.isDerivedFrom("PartDesign::Feature") or not is_member(child, thing):
            break
        thing, path = child, rest
    return thing, path


def is_member(child, thing):
    from paver import _shapes
    is_group = thing.isDerivedFrom("App::DocumentObjectGroup")
    return child in thing.Group if is_group else _shapes.enclosing(child) == thing


def without_features(thing, path):
    """A path in an object with elements of Bodies in place of those of their features, which a later feature changes."""
    before = ""
    while "." in path:
        owner = thing.getSubObject(before, 1) if before else thing
        if not owner.getSubObjects():  # it has a shape of its own
            return before + own_element(thing, before, path)
        name, _, path = path.partition(".")
        before += name + "."
    return before + path


def own_element(thing, before, path):
    """What a path in a Body means: an element of the Body where it has it, all of it for a feature."""
    from paver import _shapes
    if path.endswith("."):
        return ""
    return name_in(_shapes.object_shape(thing, before), _shapes.object_shape(thing, before + path)) or path


def name_in(shape, part):
    """Name of a shape's element that is, or lies where, `part` does; empty when there is none."""
    kind = part.ShapeType
    if kind not in KINDS:
        return ""
    elements = getattr(shape, KINDS[kind])
    for number, element in enumerate(elements, 1):
        if element.isSame(part):
            return f"{kind}{number}"
    near = 1e-7 * max(shape.BoundBox.DiagonalLength, 1e-300)
    for number, element in enumerate(elements, 1):
        if place(element).distanceToPoint(place(part)) <= near and abs(measure(element) - measure(part)) <= near * (
                1 + measure(part)):
            return f"{kind}{number}"
    return ""


def place(element):
    return element.Point if element.ShapeType == "Vertex" else element.CenterOfMass


def measure(element):
    return {"Vertex": lambda: 0, "Edge": lambda: element.Length}.get(element.ShapeType, lambda: element.Area)()


class Numbers:
    """From elements of sources to those of the compound that is meshed."""

    def __init__(self, sources):
        self.sources, self.shapes, self.whole = sources, None, None

    def names(self, number, elements):
        """Names in the whole of elements of a source."""
        if len(self.sources) == 1:
            return elements
        return [self.name(number, *ELEMENT.fullmatch(element).groups()) for element in elements]

    def name(self, number, kind, index):
        import Part

        from paver import _shapes
        if self.shapes is None:
            self.shapes = [_shapes.shape_of(source) for source in self.sources]
            self.whole = Part.Compound(self.shapes)
        wanted = getattr(self.shapes[number], KINDS[kind])[int(index) - 1]
        return next(f"{kind}{i}" for i, element in enumerate(getattr(self.whole, KINDS[kind]), 1)
                    if element.isSame(wanted))


def grouped(references):
    """[(object, elements)] of [[object, element]], each object once."""
    things = list(dict.fromkeys(thing for thing, _ in references))
    return [(thing, [element for other, element in references if other == thing]) for thing in things]


def names_in_whole(numbers, owner, references, whole=SOLIDS_FIRST):
    """Names, in the shape that is meshed, of what (object, elements) refer to. numbers: Numbers of the sources."""
    names = []
    for thing, elements in references:
        for element in elements or ("",):
            names += numbers.names(*find(numbers.sources, owner, thing, element, whole))
    return list(dict.fromkeys(names))
