"""Refinements: children of a mesh object that ask for a target length, or that of a medium, on faces, edges, vertices and
solids of what is meshed.

Documents name this module and RefinementProxy: neither may be moved.
"""
import re

from paver_wb import properties
from paver_wb.base import proxies
from paver_wb.base.proxies import Stateless, attach_view, is_refinement
from paver_wb.base.texts import tip
from paver_wb.base.waves import wavelength

GROUP = tip("Refinement")
LENGTH, MEDIUM = BY = ("Length", "Medium")
KINDS = {"Face": "Faces", "Edge": "Edges", "Vertex": "Vertexes", "Solid": "Solids"}
ELEMENT = re.compile(r"(Face|Edge|Vertex|Solid)([1-9]\d*)")

# name: (type, tooltip)
PROPERTIES = {
    "References": ("App::PropertyLinkSubListGlobal", tip("Faces, edges, vertices; a whole object means its solids, or its "
                   "faces where it has none")),
    "By": ("App::PropertyEnumeration", tip("What gives the target length: a length, or the wavelength in a medium")),
    "Length": ("App::PropertyLength", tip("Target length there, growing around it by Gradation of the mesh; without effect "
               "where that of the mesh is shorter")),
    "EpsR": ("App::PropertyFloat", tip("Relative permittivity of the medium; needs Frequency of the mesh")),
    "MuR": ("App::PropertyFloat", tip("Relative permeability of the medium")),
}


class ReferenceMissing(ValueError):
    """A refinement refers to what its mesh does not have. The text is one sentence."""


def add_properties(obj):
    """Those that are not there yet."""
    for name, (kind, tooltip) in PROPERTIES.items():
        if name in obj.PropertiesList:
            continue
        obj.addProperty(kind, name, GROUP, tooltip)
        if name == "By":
            obj.By = list(BY)
        if name in ("EpsR", "MuR"):
            setattr(obj, name, 1)
    show_what_counts(obj)


def show_what_counts(obj):
    """Only the properties that have an effect."""
    for name in ("Length", "EpsR", "MuR"):
        obj.setEditorMode(name, [] if (name == "Length") == (obj.By == LENGTH) else ["Hidden"])


class RefinementProxy(Stateless):
    """What FreeCAD calls. Nothing of it is stored but its name."""

    Type = proxies.REFINEMENT

    def __init__(self, obj):
        obj.Proxy = self
        add_properties(obj)

    def onChanged(self, obj, name):
        if name not in PROPERTIES or any(other not in obj.PropertiesList for other in PROPERTIES):
            return
        if name == "By":
            show_what_counts(obj)
        if not proxies.is_restoring(obj):
            for mesh in meshes_of(obj):
                mesh.Proxy.update_status(mesh)

    def onDocumentRestored(self, obj):
        add_properties(obj)
        attach_view(obj)


def of_mesh(mesh):
    """The refinements of a mesh object, in its order."""
    return [child for child in getattr(mesh, "Refinements", []) if is_refinement(child)]


def meshes_of(obj):
    """The mesh objects that have a refinement; one, unless a document was put together by hand."""
    return [other for other in obj.InList if proxies.is_mesh(other) and obj in other.Refinements]


def make(mesh, references, length=None, eps_r=None, mu_r=None, name="Refinement"):
    """A new refinement of a mesh object.

    references: [(object, "Face3"), (object, ["Edge1", "Edge2"]), object]; for a mesh of one object also ["Face3"].
    length: mm, text with a unit, or a quantity. Without one eps_r, mu_r: the wavelength in that medium.
    ReferenceMissing for what the mesh does not have, ValueError for a bad length; the document is then as before.
    """
    listed = as_references(mesh, references)
    check_references([mesh], listed)
    with proxies.new_object(mesh.Document, "App::FeaturePython", name) as obj:
        RefinementProxy(obj)
        obj.References = [(thing, tuple(elements)) for thing, elements in listed]
        set_value(obj, length, eps_r, mu_r)
        mesh.Refinements = [*mesh.Refinements, obj]
    return obj


def meshes_with(document, references):
    """Mesh objects that have all of [(object, elements)] among what they mesh."""
    def has_all(mesh):
        try:
            return all(find(proxies.sources(mesh), mesh, thing, element)
                       for thing, elements in references for element in elements)
        except ReferenceMissing:
            return False
    return [mesh for mesh in proxies.meshes_of(document) if has_all(mesh)]


def first_length(mesh):
    """A third of the mesh's target length, mm, of one digit; 1 where it has none yet."""
    options = properties.given(mesh)
    if "size" not in options and "frequency" not in options:
        return 1.0
    if "size" in options:
        length = options["size"]
    else:
        length = wavelength(options["frequency"], options.get("eps_r", 1), options.get("mu_r", 1)) / options["divisions"]
    return float(f"{length / 3:.0e}")


def change(obj, references, length=None, eps_r=None, mu_r=None):
    """Gives a refinement other references and another value, as make takes them, with its errors."""
    meshes = meshes_of(obj)
    listed = as_references(meshes[0], references) if meshes else references
    check_references(meshes, listed)
    obj.References = [(thing, tuple(elements)) for thing, elements in listed]
    set_value(obj, length, eps_r, mu_r)


def check_references(meshes, listed):
    """ReferenceMissing where one of [(object, elements)] is in none of what a mesh object meshes."""
    for mesh in meshes:
        for thing, elements in listed:
            for element in elements:
                find(proxies.sources(mesh), mesh, thing, element)


def set_value(obj, length=None, eps_r=None, mu_r=None):
    """Length, or medium where that is None."""
    if length is None and eps_r is None and mu_r is None:
        raise ValueError(f"'{obj.Label}' has no length; give one, or eps_r and mu_r of a medium.")
    if length is None:
        obj.By, obj.EpsR, obj.MuR = MEDIUM, 1 if eps_r is None else eps_r, 1 if mu_r is None else mu_r
        return
    try:
        obj.By, obj.Length = LENGTH, length
    except Exception:  # FreeCAD raises all sorts, with texts for programmers
        obj.Length = 0
    if not obj.Length.Value > 0:
        raise ValueError(f"The length of '{obj.Label}' is {length!r}; give one above 0, like 2 or \"2 mm\".")


def as_references(mesh, references):
    """[(object, [names of elements, "" for all])]."""
    listed = []
    for entry in references:
        if isinstance(entry, str):
            entry = (mesh.Part, entry)
        thing, elements = entry if isinstance(entry, (tuple, list)) else (entry, "")
        listed.append((thing, [elements] if isinstance(elements, str) else list(elements) or [""]))
    if not listed:
        raise ReferenceMissing(f"A refinement of '{mesh.Label}' refers to nothing; select faces, edges or vertices.")
    return listed


def decisive(mesh):
    """Text that is equal for equal refinements; empty without any."""
    entries = []
    for obj in of_mesh(mesh):
        value = (obj.Length.Value,) if obj.By == LENGTH else (obj.EpsR, obj.MuR)
        entries.append(([(thing.Name, tuple(elements)) for thing, elements in obj.References], value))
    return repr(sorted(entries)) if entries else ""


def local_texts(mesh, sources):
    """What paver.mesh takes as `local`: the refinements, with elements numbered as in the shape that is meshed.

    ReferenceMissing for a reference that is not among the sources.
    """
    numbers = Numbers(sources)
    texts = []
    for obj in of_mesh(mesh):
        names = []
        for thing, elements in obj.References:
            for element in elements or ("",):
                names += numbers.names(*find(sources, obj, thing, element))
        value = f"{obj.Length.Value!r}" if obj.By == LENGTH else f"eps-r:{obj.EpsR!r},mu-r:{obj.MuR!r}"
        if names:
            texts.append(",".join(dict.fromkeys(names)) + "=" + value)
    return texts


def find(sources, owner, thing, element):
    """(number of the source, names of its elements) that a reference means."""
    from paver import _shapes
    for number, source in enumerate(sources):
        shape = _shapes.shape_of(source) if thing == source else None
        if shape is not None and "." not in element:
            return number, known(owner, thing, shape, element)
    for number, source in enumerate(sources):
        found = inside(source, thing, element)
        if found:
            return number, found
    what = f"{element or 'all'} of '{thing.Label}'"
    raise ReferenceMissing(f"'{owner.Label}' refers to {what}, which is not among the objects that are meshed; refer to "
                           "elements of those.")


def known(owner, thing, shape, element):
    """Names of the elements of a source's shape; `element` may be empty for the whole of it."""
    if not element:
        kind = "Solid" if shape.Solids else "Face"
        return [f"{kind}{i + 1}" for i in range(len(getattr(shape, KINDS[kind])))]
    match = ELEMENT.fullmatch(element)
    count = len(getattr(shape, KINDS[match.group(1)])) if match else 0
    if not match or int(match.group(2)) > count:
        raise ReferenceMissing(f"'{owner.Label}' refers to {element}, which '{thing.Label}' does not have; choose the "
                               "elements again.")
    return [element]


def inside(source, thing, element):
    """Names of the elements of a source that are an element of something inside it: of an object in an App::Part, of a
    feature of a Body. Empty: not inside."""
    import Part

    from paver import _shapes
    shape = _shapes.shape_of(source)
    if thing == source:
        wanted = Part.getShape(source, element, needSubElement=True)
    elif thing in source.OutListRecursive:
        path = path_to(source, thing)
        wanted = Part.getShape(source, path + element, needSubElement=bool(element)) if path is not None else None
        if wanted is None or wanted.isNull():
            wanted = thing.Shape if not element else thing.getSubObject(element)
    else:
        return []
    parts = [wanted] if element else wanted.Solids or wanted.Faces
    names = [name_in(shape, part) for part in parts]
    return names if all(names) else []


def path_to(source, thing):
    """"Group.Box." leading from an object to one inside it; None when there is no such way."""
    for child in getattr(source, "Group", []):
        if child == thing:
            return child.Name + "."
        further = path_to(child, thing)
        if further is not None:
            return f"{child.Name}.{further}"
    return None


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
