"""Names of faces that say which object they are of: "Board/Face3", as FreeCAD counts the faces of that object.

FreeCAD makes an App::Part's shape of those of its visible members, in their order; a link's is that of what it links to.
"""


def of(things, shapes, whole):
    """Labels of the faces of `whole`, which is made of the `shapes` of shapes and objects; none of a single object."""
    leaves = [leaf for number, (thing, shape) in enumerate(zip(things, shapes), 1)
              for leaf in leaves_of(thing, shape, label_of(thing, number))]
    if len(leaves) < 2:
        return []
    names = [path[-1] for path, _ in leaves]
    labels = [label for (path, shape), name in zip(leaves, names)
              for label in numbered(name if names.count(name) == 1 else "/".join(path), shape)]
    return labels if len(labels) == len(whole.Faces) else matched(labels, leaves, whole)


def label_of(thing, number):
    return getattr(thing, "Label", f"Shape{number}")


def numbered(name, shape):
    return [f"{name}/Face{i}" for i in range(1, len(shape.Faces) + 1)]


def leaves_of(thing, shape, *path):
    """[(labels from outside to inside, shape)] of the objects that an object consists of."""
    members = members_of(thing)
    inner = shape.SubShapes if members else []
    if not members or len(inner) != len(members):
        return [(path, shape)]
    return [leaf for member, own in zip(members, inner) for leaf in leaves_of(member, own, *path, member.Label)]


def members_of(thing):
    """Those of an App::Part, or of a link to one, that are in its shape."""
    import Part
    if not hasattr(thing, "getSubObjects"):
        return []
    linked = thing.getLinkedObject(True)
    if linked.isDerivedFrom("Part::Feature") or not linked.hasExtension("App::GeoFeatureGroupExtension"):
        return []
    members = [(name, thing.getSubObject(name, 1)) for name in thing.getSubObjects()]
    return [member for name, member in members
            if member is not None and member.Visibility and not Part.getShape(thing, name).isNull()]


def matched(labels, leaves, whole):
    """Where some have faces in common: the first one's label."""
    known = {}
    for label, face in zip(labels, (face for _, shape in leaves for face in shape.Faces)):
        known.setdefault(face.hashCode(), []).append((face, label))
    return [next((label for face, label in known.get(wanted.hashCode(), ()) if face.isSame(wanted)), "")
            for wanted in whole.Faces]
