"""Refinements: children of a mesh object that ask for a target length, or that of a medium, on faces, edges, vertices and
solids of what is meshed.

Documents name this module and RefinementProxy: neither may be moved.
"""
import FreeCAD

from paver_wb import core, properties
from paver_wb.base import expressions, proxies
from paver_wb.base.proxies import is_refinement
from paver_wb.base.texts import tip
from paver_wb.base.waves import wavelength
from paver_wb.children.references import (Numbers, ReferenceMissing, as_references, check_references,  # noqa: F401
                                          find, meshes_of, names_in_whole)

translate = FreeCAD.Qt.translate
GROUP = tip("Refinement")
LENGTH, MEDIUM = BY = ("Length", "Medium")

# name: (type, tooltip, values as of add_property)
PROPERTIES = {
    "References": ("App::PropertyLinkSubListGlobal", tip("Faces, edges, vertices; a whole object means its solids, or its "
                   "faces where it has none")),
    "By": ("App::PropertyEnumeration", tip("What gives the target length: a length, or the wavelength in a medium"),
           list(BY)),
    "Length": ("App::PropertyLength", tip("Target length there, growing around it by Gradation of the mesh; without effect "
               "where that of the mesh is shorter")),
    "EpsR": ("App::PropertyFloat", tip("Relative permittivity of the medium; needs Frequency of the mesh"), 1),
    "MuR": ("App::PropertyFloat", tip("Relative permeability of the medium"), 1),
}


def add_properties(obj):
    """Those that are not there yet."""
    for name, (kind, tooltip, *values) in PROPERTIES.items():
        proxies.add_property(obj, kind, name, GROUP, tooltip, *values)
    show_what_counts(obj)


def show_what_counts(obj):
    """Only the properties that have an effect."""
    for name in ("Length", "EpsR", "MuR"):
        obj.setEditorMode(name, [] if (name == "Length") == (obj.By == LENGTH) else ["Hidden"])


class RefinementProxy(proxies.Proxy):
    Type, add_properties = proxies.REFINEMENT, staticmethod(add_properties)

    def onChanged(self, obj, name):
        if name not in PROPERTIES or any(other not in obj.PropertiesList for other in PROPERTIES):
            return
        if name == "By":
            show_what_counts(obj)
        if not proxies.is_restoring(obj):
            for mesh in meshes_of(obj):
                mesh.Proxy.update_status(mesh)


def of_mesh(mesh):
    """The refinements of a mesh object, in its order."""
    return [child for child in getattr(mesh, "Refinements", []) if is_refinement(child)]


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
        except (ReferenceMissing, core.load().InputError):  # it has no shape
            return False
    return [mesh for mesh in proxies.meshes_of(document) if has_all(mesh)]


def target_of(mesh):
    """(target length, mm; eps_r times mu_r) as the options of a mesh have them; None for what they do not give."""
    options = properties.given(mesh)
    if "size" in options or "frequency" not in options:
        return options.get("size"), None
    medium = options.get("eps_r", 1), options.get("mu_r", 1)
    length, divisions = wavelength(options["frequency"], *medium), options["divisions"]
    return length / divisions if length and divisions > 0 else None, medium[0] * medium[1]


def first_length(mesh):
    """A third of the mesh's target length, mm, of one digit; 1 where it has none yet."""
    length, _ = target_of(mesh)
    return float(f"{length / 3:.0e}") if length else 1.0


def asked_length(value, target, medium):
    """The length that arguments of set_value come to in a mesh with that target_of(), mm; None where that is not known."""
    if value.get("length") is not None:
        return value["length"]
    square = (value.get("eps_r") or 1) * (value.get("mu_r") or 1)
    return target * (medium / square) ** 0.5 if target and medium and square > 0 else None


def has_effect(value, target, medium):
    """Whether arguments of set_value make elements shorter; unknown counts as yes."""
    length = asked_length(value, target, medium)
    return not target or length is None or length < target * (1 - 1e-9)


def value_of(obj):
    """Arguments of set_value for what a refinement has."""
    return {"length": obj.Length.Value} if obj.By == LENGTH else {"eps_r": obj.EpsR, "mu_r": obj.MuR}


def change(obj, references, length=None, eps_r=None, mu_r=None):
    """Gives a refinement other references and another value, as make takes them, with its errors."""
    meshes = meshes_of(obj)
    listed = as_references(meshes[0], references) if meshes else references
    check_references(meshes, listed)
    obj.References = [(thing, tuple(elements)) for thing, elements in listed]
    set_value(obj, length, eps_r, mu_r)


def set_value(obj, length=None, eps_r=None, mu_r=None):
    """Length, or medium where that is None."""
    if length is None and eps_r is None and mu_r is None:
        raise ValueError(translate("Paver", "'{}' has no length; give one, or eps_r and mu_r of a medium.").format(obj.Label))
    if length is None:
        obj.By = MEDIUM
        for name, value in (("EpsR", eps_r), ("MuR", mu_r)):
            expressions.put(obj, name, 1 if value is None else value)
        return
    try:
        obj.By = LENGTH
        expressions.put(obj, "Length", length)
    except Exception:  # FreeCAD raises all sorts, with texts for programmers
        obj.Length = 0
    if not obj.Length.Value > 0:
        raise ValueError(translate("Paver", "The length of '{}' is {}; give one above 0, like 2 or \"2 mm\".").format(
            obj.Label, repr(length)))


def decisive(mesh):
    """Text that is equal for equal refinements; empty without any."""
    entries = [([(thing.Name, tuple(elements)) for thing, elements in obj.References], tuple(value_of(obj).values()))
               for obj in of_mesh(mesh)]
    return repr(sorted(entries)) if entries else ""


def local_texts(mesh, sources):
    """What paver.mesh takes as `local`: the refinements, with elements numbered as in the shape that is meshed.

    ReferenceMissing for a reference that is not among the sources.
    """
    numbers = Numbers(sources)
    texts = []
    for obj in of_mesh(mesh):
        names = names_in_whole(numbers, obj, obj.References)
        value = f"{obj.Length.Value!r}" if obj.By == LENGTH else f"eps-r:{obj.EpsR!r},mu-r:{obj.MuR!r}"
        if names:
            texts.append(",".join(names) + "=" + value)
    return texts
