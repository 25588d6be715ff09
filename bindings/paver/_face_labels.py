"""Names of faces, loose edges and vertices that say which object they are of: "Board/Face3", as FreeCAD counts the faces
of that object.

FreeCAD makes the shape of an App::Part, of a link group and of a link array of those of their visible members, in their
order; a link's is that of what it links to.
"""


def of(things, shapes, whole):
    """Labels of the faces of `whole`, which is made of the `shapes` of shapes and objects, then of its loose edges and
    vertices; none of a single object."""
    leaves = [leaf for number, (thing, shape) in enumerate(zip(things, shapes), 1)
              for leaf in leaves_of(thing, shape, label_of(thing, number))]
    if len(leaves) < 2:
        return []
    own = [path[-1] for path, _ in leaves]
    names = [path[-1] if own.count(path[-1]) == 1 else "/".join(path) for path, _ in leaves]
    shapes = [shape for _, shape in leaves]
    labels = [label for name, shape in zip(names, shapes) for label in numbered(name, "Face", shape.Faces)]
    if len(labels) != len(whole.Faces):
        labels = matched(labels, leaves, whole)
    for kind, loose in (("Edge", loose_edges), ("Vertex", loose_vertices)):
        further = [label for name, shape in zip(names, shapes) for label in numbered(name, kind, loose(shape))]
        wanted = len(loose(whole))
        labels += further if len(further) == wanted else [""] * wanted
    return labels


def label_of(thing, number):
    return getattr(thing, "Label", f"Shape{number}")


def numbered(name, kind, elements):
    return [f"{name}/{kind}{i}" for i in range(1, len(elements) + 1)]


def loose_edges(shape):
    """Those that bound no face."""
    return without(shape.Edges, [edge for face in shape.Faces for edge in face.Edges])


def loose_vertices(shape):
    """Those that end no edge."""
    return without(shape.Vertexes, [vertex for edge in shape.Edges for vertex in edge.Vertexes])


def without(elements, others):
    known = {}
    for other in others:
        known.setdefault(other.hashCode(), []).append(other)
    return [one for one in elements if not any(map(one.isSame, known.get(one.hashCode(), ())))]


def leaves_of(thing, shape, *path):
    """[(labels from outside to inside, shape)] of the objects that an object consists of."""
    members = members_of(thing)
    inner = shape.SubShapes if members else []
    if not members or len(inner) != len(members):
        return [(path, shape)]
    return [leaf for (label, member), own in zip(members, inner) for leaf in leaves_of(member, own, *path, label)]


def members_of(thing):
    """[(label, object)] of those that an object's shape is put together of; none where it has one of its own."""
    import Part
    if not hasattr(thing, "getSubObjects"):
        return []
    members = [(name, thing.getSubObject(name, 1)) for name in thing.getSubObjects()]
    return [(member_label(thing, name[:-1], member), member) for name, member in members
            if member is not None and is_seen(thing, name[:-1], member) and not Part.getShape(thing, name).isNull()]


def member_label(thing, name, member):
    """An element of a link array that is no object of its own is called as FreeCAD would call that."""
    is_object = not name.isdigit() or member.isDerivedFrom("App::LinkElement")
    return member.Label if is_object else f"{thing.Label}_i{name}"


def is_seen(thing, name, member):
    """Links know which of their elements are seen; elsewhere the member itself does."""
    seen = thing.isElementVisible(name)
    return member.Visibility if seen < 0 else bool(seen)


def matched(labels, leaves, whole):
    """Where some have faces in common: the first one's label."""
    known = {}
    for label, face in zip(labels, (face for _, shape in leaves for face in shape.Faces)):
        known.setdefault(face.hashCode(), []).append((face, label))
    return [next((label for face, label in known.get(wanted.hashCode(), ()) if face.isSame(wanted)), "")
            for wanted in whole.Faces]
