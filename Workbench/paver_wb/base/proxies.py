"""What the proxies of objects share, and how one finds the other's objects. Documents store nothing of a proxy but its class."""
from contextlib import contextmanager

import FreeCAD

MESH, REFINEMENT, SERIES = "Paver::Mesh", "Paver::Refinement", "Paver::Series"
NAMED = MEDIUM, PORT, WIRE = "Paver::Medium", "Paver::Port", "Paver::Wire"
views = {}  # {Type of a proxy: class of its view provider}: the window fills it


class Stateless:
    """Under the names that FreeCAD before and from 0.21 on looks for."""

    def dumps(self):
        return None

    def loads(self, state):
        return None

    __getstate__ = dumps
    __setstate__ = loads


class Proxy(Stateless):
    """What FreeCAD calls. Nothing of it is stored but its name. Subclasses have Type, and add_properties(obj), which adds
    those that are not there yet."""

    def __init__(self, obj):
        obj.Proxy = self
        self.add_properties(obj)

    def onDocumentRestored(self, obj):
        self.add_properties(obj)
        attach_view(obj)


def add_property(obj, kind, name, group, tooltip, *values):
    """Adds a property that is not there yet. values: set one after the other: choices of an enumeration, the first value."""
    if name not in obj.PropertiesList:
        obj.addProperty(kind, name, group, tooltip)
        for value in values:
            setattr(obj, name, value)


def attach_view(obj):
    """Gives an object its view provider, which a file that was saved without a window does not have; None where there is
    no window or it has one."""
    provider = views.get(obj.Proxy.Type) if FreeCAD.GuiUp else None
    return provider(obj.ViewObject) if provider and not isinstance(obj.ViewObject.Proxy, provider) else None


@contextmanager
def new_object(document, kind, name):
    """A new object of a document, which is as before when what is done with it fails."""
    obj = document.addObject(kind, name)
    try:
        yield obj
    except BaseException:
        document.removeObject(obj.Name)
        raise
    attach_view(obj)


def type_of(obj):
    return getattr(getattr(obj, "Proxy", None), "Type", "")


def is_mesh(obj):
    return type_of(obj) == MESH


def is_refinement(obj):
    return type_of(obj) == REFINEMENT


def is_named(obj):
    """Whether it is a medium, a port or a wire."""
    return type_of(obj) in NAMED


def is_child(obj):
    """Whether it belongs to a mesh object."""
    return is_refinement(obj) or is_named(obj)


def is_own(obj):
    """Whether it is one of Paver's objects, which are not meshed and not referred to."""
    return is_mesh(obj) or is_child(obj) or type_of(obj) == SERIES


def meshes_of(document):
    """All meshes of a document, in its order."""
    return [obj for obj in document.Objects if is_mesh(obj)]


def sources(obj):
    """The objects that a mesh object meshes."""
    return [thing for thing in [obj.Part, *obj.MoreParts] if thing is not None]


def is_restoring(obj):
    return obj.Document.Restoring or obj.Document.Transacting or "Restore" in obj.State
