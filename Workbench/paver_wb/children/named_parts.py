"""Media, ports and wires: children of a mesh object that give parts of what is meshed a name: their label, or
NameInFiles where that is not empty, as labels are unique in a document.

Documents name this module and its proxies: none may be moved.
"""
import glob
import os
import re
from typing import NamedTuple

import FreeCAD

from paver_wb.base import expressions, proxies
from paver_wb.base.texts import tip
from paver_wb.children.references import (CHILDREN, Numbers, ReferenceMissing, as_references, check_references, kinds_text,
                                          meshes_of, names_in_whole)

translate = FreeCAD.Qt.translate
MEDIA, PORTS, WIRES = LINKS = CHILDREN[1:]
NAME = "NameInFiles"
CONDUCTING = 1e4  # S/m: a material that conducts better counts as a conductor
ENTRY = re.compile(r"\s*(\w+)\s*[=:]\s*(.*)")  # of a card
GROUPS = {proxies.MEDIUM: tip("Medium"), proxies.PORT: tip("Port"), proxies.WIRE: tip("Wire")}


class Kind(NamedTuple):
    """link: property of the mesh object that has the children; option: of the core; elements: what one may refer to, and a
    whole object means the first of these that it has; properties: {name: (type, tooltip, first value)}."""

    link: str
    option: str
    elements: tuple
    properties: dict


KINDS = {
    proxies.MEDIUM: Kind(MEDIA, "medium", ("Solid",), {
        "EpsR": ("App::PropertyFloat", tip("Relative permittivity"), 1.0),
        "MuR": ("App::PropertyFloat", tip("Relative permeability"), 1.0),
        "LossTangent": ("App::PropertyFloat", tip("Loss tangent: imaginary by real part of the permittivity"), 0.0),
        "Conductor": ("App::PropertyBool", tip("The solid is a conductor: no waves inside, its target length is that around "
                                               "it"), False)}),
    proxies.PORT: Kind(PORTS, "port", ("Face", "Edge", "Vertex"), {}),
    proxies.WIRE: Kind(WIRES, "wire", ("Edge",), {
        "Radius": ("App::PropertyLength", tip("Radius of the wire, for solvers"), 1.0)}),
}
REFERENCES = {proxies.MEDIUM: tip("Solids that are made of it; a whole object means its solids"),
              proxies.PORT: tip("Faces, edges and vertices of the port; a whole object means its faces, or its edges where "
                                "it has none"),
              proxies.WIRE: tip("Edges that stand for the wire; a whole object means all its edges")}


def kind_of(obj):
    return KINDS[proxies.type_of(obj)]


class NamedProxy(proxies.Proxy):
    def add_properties(self, obj):
        for name, (kind, tooltip, *first) in {
                "References": ("App::PropertyLinkSubListGlobal", REFERENCES[self.Type]),
                NAME: ("App::PropertyString", tip("Its name in files of the mesh; empty: the label")),
                **KINDS[self.Type].properties}.items():
            proxies.add_property(obj, kind, name, GROUPS[self.Type], tooltip, *first)

    def onChanged(self, obj, name):
        if name not in ("Label", NAME, "References", *KINDS[self.Type].properties) or proxies.is_restoring(obj):
            return
        for mesh in meshes_of(obj):
            mesh.Proxy.update_status(mesh)


class MediumProxy(NamedProxy):
    Type = proxies.MEDIUM


class PortProxy(NamedProxy):
    Type = proxies.PORT


class WireProxy(NamedProxy):
    Type = proxies.WIRE


PROXIES = {proxy.Type: proxy for proxy in (MediumProxy, PortProxy, WireProxy)}


def of_mesh(mesh, kind=None):
    """The media, ports and wires of a mesh object, in its order; of one kind."""
    return [child for link in LINKS for child in getattr(mesh, link, [])
            if proxies.is_named(child) and kind in (None, proxies.type_of(child))]


def make_medium(mesh, references, eps_r=1.0, mu_r=1.0, tan_d=0.0, conductor=False, name="Medium"):
    """A new medium of solids. references: [object, (object, "Solid1")]; an element of another kind means its object.

    ReferenceMissing for what the mesh does not have, ValueError for a value that cannot be; the document is then as before.
    """
    return make(proxies.MEDIUM, mesh, references, name, EpsR=eps_r, MuR=mu_r, LossTangent=tan_d, Conductor=conductor)


def make_port(mesh, references, name="Port"):
    """A new port of faces, edges, vertices: [(object, "Face3"), (object, ["Edge1", "Edge2"]), object]. Errors as above."""
    return make(proxies.PORT, mesh, references, name)


def make_wire(mesh, references, radius=1.0, name="Wire"):
    """A new wire of edges: [object, (object, "Edge1")], radius in mm or with a unit. An object that is not meshed yet
    becomes one that is. Errors as above."""
    return make(proxies.WIRE, mesh, references, name, Radius=radius)


def make(type_, mesh, references, name, **values):
    kind, before = KINDS[type_], list(mesh.MoreParts)
    listed = fitting(kind, as_references(mesh, references))
    if type_ == proxies.WIRE:
        take_in(mesh, listed)
    try:
        check_references([mesh], listed, kind.elements)
        with proxies.new_object(mesh.Document, "App::FeaturePython", name) as obj:
            obj.Label = name
            PROXIES[type_](obj)
            put(obj, listed, values)
            setattr(mesh, kind.link, [*getattr(mesh, kind.link), obj])
    except BaseException:
        if list(mesh.MoreParts) != before:
            mesh.MoreParts = before
        raise
    return obj


def change(obj, references, label=None, **values):
    """Gives a child other references, another name in files and values of its properties. Errors as those of make_medium.

    The label becomes that name unless NameInFiles has it; that gets it, too, where another object is labelled so.
    """
    kind, meshes = kind_of(obj), meshes_of(obj)
    listed = fitting(kind, as_references(meshes[0], references) if meshes else references)
    if meshes and proxies.type_of(obj) == proxies.WIRE:
        take_in(meshes[0], listed)
    check_references(meshes, listed, kind.elements)
    put(obj, listed, values)
    if label is not None and label != name_of(obj):
        if not getattr(obj, NAME):
            obj.Label = label
        setattr(obj, NAME, "" if obj.Label == label else label)


def fitting(kind, listed):
    """References as a kind may have them: a face of a solid stands for its object."""
    found = []
    for thing, elements in listed:
        fit = [element for element in elements if element_kind(element) in ("", *kind.elements)]
        if len(fit) < len(elements) and kind.elements != ("Solid",):
            wrong = next(element for element in elements if element not in fit)
            named = {"port": translate("Paver", "port"), "wire": translate("Paver", "wire")}[kind.option]
            raise ReferenceMissing(translate("Paver", "{} of '{}' cannot be in a {}; choose {}.").format(
                wrong, thing.Label, named, kinds_text(kind.elements)))
        found.append((thing, elements if len(fit) == len(elements) else list(dict.fromkeys(map(owner, elements)))))
    return found


def element_kind(element):
    """"Face" of "Link.Box.Face3"; empty for all of an object."""
    return element.rsplit(".", 1)[-1].rstrip("0123456789")


def owner(element):
    """"Link.Box." of "Link.Box.Face3"; empty for an element of the object itself."""
    return element[:element.rfind(".") + 1]


def take_in(mesh, listed):
    """Adds the objects to what is meshed that are not part of it."""
    known = proxies.sources(mesh)
    inner = [thing for source in known for thing in source.OutListRecursive]
    new = [thing for thing, _ in listed if thing not in known and thing not in inner]
    if new:
        mesh.MoreParts = [*mesh.MoreParts, *dict.fromkeys(new)]


def put(obj, listed, values):
    """Checks values and sets them."""
    obj.References = [(thing, tuple(elements)) for thing, elements in listed]
    for name, value in values.items():
        try:
            expressions.put(obj, name, value)
        except Exception:  # FreeCAD raises all sorts, with texts for programmers
            raise ValueError(translate("Paver", "{} of '{}' cannot be {}; write a number.").format(
                name, obj.Label, repr(value))) from None
        number = getattr(getattr(obj, name), "Value", getattr(obj, name))
        if name != "Conductor" and not (number >= 0 if name == "LossTangent" else number > 0):
            text = translate("Paver", "{} of '{}' is {}; give one from 0.") if name == "LossTangent" else translate(
                "Paver", "{} of '{}' is {}; give one above 0.")
            raise ValueError(text.format(name, obj.Label, repr(value)))


def copy(obj, mesh):
    """The same for another mesh object, under the same name in files."""
    values = {name: getattr(obj, name) for name in kind_of(obj).properties}
    made = make(proxies.type_of(obj), mesh, [(thing, elements or ("",)) for thing, elements in obj.References], obj.Label,
                **values)
    setattr(made, NAME, name_of(obj))
    return made


def name_of(obj):
    """In files."""
    return getattr(obj, NAME, "") or obj.Label


def facts(obj):
    """What the core is told of a child besides its parts."""
    type_ = proxies.type_of(obj)
    if type_ == proxies.WIRE:
        return [f"radius:{obj.Radius.Value!r}"]
    if type_ == proxies.PORT:
        return []
    if obj.Conductor:
        return ["conductor"]
    return [f"eps-r:{obj.EpsR!r}", f"mu-r:{obj.MuR!r}", f"tan-d:{obj.LossTangent!r}"]


def decisive(mesh):
    """Text that is equal for equal children; empty without any."""
    entries = [(kind_of(obj).option, name_of(obj), [(thing.Name, tuple(elements)) for thing, elements in obj.References],
                facts(obj)) for obj in of_mesh(mesh)]
    return repr(sorted(entries)) if entries else ""


def option_texts(mesh, sources):
    """{option: texts as paver.mesh takes them}, with elements numbered as in the shape that is meshed.

    ReferenceMissing for a reference that is not among the sources.
    """
    numbers, texts = Numbers(sources), {}
    for obj in of_mesh(mesh):
        kind = kind_of(obj)
        names = names_in_whole(numbers, obj, obj.References, kind.elements)
        if names:
            texts.setdefault(kind.option, []).append(f"{name_of(obj)}={','.join(names + facts(obj))}")
    return texts


# Materials of FreeCAD


def values_of_material(material):
    """{property of a medium: value} of the dict of a material object or card. ValueError where it says nothing of waves."""
    conductivity = quantity(material.get("ElectricalConductivity", ""), "S/m")
    permittivity = quantity(material.get("RelativePermittivity", ""))
    if conductivity is not None and conductivity > CONDUCTING:
        return {"Conductor": True}
    if permittivity is None:
        raise ValueError(f"{material.get('Name', 'The material')} has neither RelativePermittivity nor an "
                         "ElectricalConductivity of a conductor; type the values of the medium.")
    permeability = quantity(material.get("RelativePermeability", ""))
    return {"EpsR": permittivity, "MuR": 1.0 if permeability is None else permeability, "Conductor": False}


def quantity(text, unit=""):
    """A number in a unit; None where the text is none."""
    if not str(text).strip():
        return None
    try:
        value = FreeCAD.Units.Quantity(str(text))
        return float(value.getValueAs(unit)) if unit else float(value.Value)
    except (ValueError, ArithmeticError):
        return None


def materials(document):
    """{name: dict} of the materials of a document, then of FreeCAD's cards, that say what a medium is."""
    found = {}
    for obj in document.Objects:
        if isinstance(getattr(obj, "Material", None), dict):
            found.setdefault(obj.Label, obj.Material)
    for path in sorted(glob.glob(os.path.join(FreeCAD.getResourceDir(), "Mod", "Material", "**", "*.FCMat"), recursive=True)):
        name = os.path.splitext(os.path.basename(path))[0]
        if name not in ("TEMPLATE", "None"):
            found.setdefault(name, read_card(path))
    return {name: material for name, material in found.items() if is_medium(material)}


def is_medium(material):
    try:
        return bool(values_of_material(material))
    except ValueError:
        return False


def read_card(path):
    """The entries of a material card as a dict: "Name = value" up to FreeCAD 0.21, 'Name: "value"' from 1.0 on."""
    with open(path, encoding="utf-8", errors="replace") as file:
        found = [ENTRY.match(line) for line in file]
    return {entry.group(1): entry.group(2).strip().strip("\"'") for entry in found if entry}
