"""The mesh as an object of a document.

What is kept is the file in `MeshFile`: it is saved, undone and redone. `FemMesh` is a view for solvers and for drawing,
made from that file: FreeCAD neither undoes it nor stores more than plain quadratic elements, and takes long over it.

Documents name this module and MeshProxy: neither may be moved.
"""
import ast
import itertools
import os
import shutil

import FreeCAD

from paver_wb import analysis, core, properties, refinement
from paver_wb.base import source_shapes
from paver_wb.base.proxies import (MESH, Stateless, add_property, attach_view, is_mesh, is_restoring,  # noqa: F401
                                   meshes_of, new_object, sources)
from paver_wb.base.texts import listed, tip
from paver_wb.children import named_parts
from paver_wb.formats import fem_mesh, mesh_file

INPUT, RESULT = tip("Input"), tip("Result")
NOT_MESHED, UP_TO_DATE, OUT_OF_DATE = STATES = ("Not meshed", "Up to date", "Out of date")
FACES_FAILED = "Faces failed"  # what state() gives besides
MOST_CHANGES = 3  # are named
RUN_IN = AUTOMATIC, IN_FREECAD, IN_PROCESS = ("Automatic", "FreeCAD", "Own process")
ENUMERATIONS = {"Status": [list(STATES)], "RunIn": [list(RUN_IN)]}
LINKS = ("Part", "MoreParts")
REFINEMENTS, RANKS, SHOWN_STATUS, SHAPE_LINK = "Refinements", "Ranks", "MeshStatus", "Shape"
translate = FreeCAD.Qt.translate
PREFERENCES = "User parameter:BaseApp/Preferences/Mod/Paver"
FILL_LIMIT = 10000  # elements; FreeCAD needs about a quarter of a second for as many, in which the window stands still
HEAVY_ELEMENTS = 300000

# name: (type, group, tooltip, editor modes)
PROPERTIES = {
    "Part": ("App::PropertyLinkGlobal", INPUT, tip("Object to mesh: a solid or a surface, an App::Part, a link"), ()),
    "MoreParts": ("App::PropertyLinkListGlobal", INPUT, tip("Further objects, meshed together with Part, each where it "
                  "stands"), ()),
    REFINEMENTS: ("App::PropertyLinkListGlobal", INPUT, tip("Refinements: target lengths of faces, edges, vertices and "
                  "solids"), ()),
    "Media": ("App::PropertyLinkListGlobal", INPUT, tip("Media: what solids are made of"), ()),
    "Ports": ("App::PropertyLinkListGlobal", INPUT, tip("Ports: faces, edges and vertices under names of their own"), ()),
    "Wires": ("App::PropertyLinkListGlobal", INPUT, tip("Wires: edges with a radius"), ()),
    "WireRadius": ("App::PropertyLength", INPUT, tip("Radius of edges without a wire of their own, for solvers and scripts: "
                   "the mesh does not depend on it; 0: not given"), ()),
    "RunIn": ("App::PropertyEnumeration", INPUT, tip("Where the window's commands mesh; own process: FreeCAD survives a "
              "crash; automatic: there from HeavyElements of the preferences on"), ()),
    RANKS: ("App::PropertyInteger", INPUT, tip("Processes that share the work, by MPI; 0: without MPI"), ()),
    "Status": ("App::PropertyEnumeration", RESULT, tip("Not meshed, Up to date, Out of date: the same in all languages, "
               "for scripts"), ("Hidden",)),
    SHOWN_STATUS: ("App::PropertyString", RESULT, tip("Out of date: an option or an object has changed since meshing"),
            ("ReadOnly",)),
    "Quads": ("App::PropertyInteger", RESULT, tip("Number of quads"), ("ReadOnly",)),
    "Triangles": ("App::PropertyInteger", RESULT, tip("Number of triangles"), ("ReadOnly",)),
    "Lines": ("App::PropertyInteger", RESULT, tip("Number of line elements of wires"), ("ReadOnly",)),
    "Nodes": ("App::PropertyInteger", RESULT, tip("Number of nodes"), ("ReadOnly",)),
    "TargetLength": ("App::PropertyLength", RESULT, tip("Target length of the element edges"), ("ReadOnly",)),
    "WorstScaledJacobian": ("App::PropertyFloat", RESULT, tip("Smallest scaled Jacobian of all elements"), ("ReadOnly",)),
    "Watertight": ("App::PropertyBool", RESULT, tip("Every mesh edge lies in exactly two elements"), ("ReadOnly",)),
    "FailedFaces": ("App::PropertyStringList", RESULT, tip("Faces that could not be meshed, with the reason"),
                    ("ReadOnly",)),
    "FemMeshFilled": ("App::PropertyBool", RESULT, tip("FemMesh holds the mesh: always below the limit of the preferences, "
                      "above it on demand"), ("ReadOnly",)),
    "MeshFile": ("App::PropertyFileIncluded", RESULT, tip("The mesh itself, as the document keeps it"), ("Hidden",)),
    "MeshedOptions": ("App::PropertyString", RESULT, tip("Options that the mesh was made with"), ("Hidden",)),
    "MeshedShape": ("App::PropertyString", RESULT, tip("Digest of the shape that was meshed"), ("Hidden",)),
    "ShapeChanged": ("App::PropertyBool", RESULT, tip("The shape differs from the one that was meshed"), ("Hidden",)),
    "MeshedLabels": ("App::PropertyString", RESULT, tip("Digest of the labels that faces had when they were meshed"), ("Hidden",)),
    "LabelsChanged": ("App::PropertyBool", RESULT, tip("A label that faces are called by differs from then"), ("Hidden",)),
}


def add_properties(obj):
    """Those that are not there yet."""
    for name, (kind, group, tooltip, modes) in PROPERTIES.items():
        add_property(obj, kind, name, group, tooltip, *ENUMERATIONS.get(name, ()))
        obj.setEditorMode(name, list(modes))
    obj.setPropertyStatus("FemMesh", "Transient")
    obj.setEditorMode("Placement", ["Hidden"])
    obj.setPropertyStatus(SHOWN_STATUS, ["Transient", "Output"])  # each session has its own language
    if not core.problem() and not properties.has_ranks():
        obj.setEditorMode(RANKS, ["Hidden"])
    if needs_shape_link():
        add_property(obj, "App::PropertyLinkGlobal", SHAPE_LINK, INPUT,
                     tip("Part, under the name that the FEM workbench looks for from FreeCAD 1.0 on"))
        obj.setEditorMode(SHAPE_LINK, ["Hidden"])
    follow_part(obj)


def needs_shape_link():
    """Whether this FreeCAD's solvers look for the geometry of a mesh under another name than Part. In 0.20 they know
    both, but its window takes a property of that name for a shape."""
    return int(FreeCAD.Version()[0]) >= 1


def follow_part(obj):
    """Keeps the second link to what is meshed, where there is one, in step with the first."""
    if SHAPE_LINK in obj.PropertiesList and getattr(obj, SHAPE_LINK) != obj.Part:
        setattr(obj, SHAPE_LINK, obj.Part)


def fill_limit():
    """Largest number of elements with which FemMesh is filled unasked."""
    return FreeCAD.ParamGet(PREFERENCES).GetInt("FillLimit", FILL_LIMIT)


def heavy_elements():
    """Number of predicted elements from which on RunIn "Automatic" means a process of its own."""
    return FreeCAD.ParamGet(PREFERENCES).GetInt("HeavyElements", HEAVY_ELEMENTS)


def shape_digest(obj):
    """Digest of the shapes of all sources where they stand; empty without one, or when it has no shape."""
    things = sources(obj)
    if not hasattr(obj.Proxy, "known"):
        obj.Proxy.known = source_shapes.Known()
    try:
        return obj.Proxy.known.digest_of(source_shapes.of(things)) if things else ""
    except core.load().InputError:
        return ""


def has_meshed_labels(obj):
    """Whether faces are called as they were when they were meshed. Documents of before this was kept do not tell; without
    the core, which has the labels, any change may matter."""
    if not obj.MeshedLabels or core.problem():
        return not obj.MeshedLabels
    try:
        return obj.MeshedLabels == source_shapes.digest_of(repr(source_shapes.labels_of(sources(obj))).encode())
    except core.load().InputError:  # without a shape there are no labels
        return True


def decisive(obj, options=None):
    """Text that is equal for equal options, those that a mesh object has unless `options` are given, and children."""
    own = properties.text_of(properties.given(obj) if options is None else options)
    return own + refinement.decisive(obj) + named_parts.decisive(obj)


def has_meshed_options(obj):
    """Without the core, which knows what the options mean, any change may matter."""
    try:
        return obj.MeshedOptions == decisive(obj)
    except core.CoreMissing:
        return False


def update_status(obj):
    """Status from what is recorded."""
    state = NOT_MESHED
    if obj.MeshFile:
        is_same = not obj.ShapeChanged and not obj.LabelsChanged and has_meshed_options(obj)
        state = UP_TO_DATE if is_same else OUT_OF_DATE
    if obj.Status != state:
        obj.Status = state
    shown = status_text(state_of(obj))
    if getattr(obj, SHOWN_STATUS) != shown:
        setattr(obj, SHOWN_STATUS, shown)


def state_of(obj):
    """The Status, or FACES_FAILED where the mesh is up to date but not whole."""
    return FACES_FAILED if obj.Status == UP_TO_DATE and obj.FailedFaces else obj.Status


def status_text(state):
    """What state_of() gives, in the user's language."""
    return {NOT_MESHED: translate("Paver", "Not meshed"), UP_TO_DATE: translate("Paver", "Up to date"),
            OUT_OF_DATE: translate("Paver", "Out of date"), FACES_FAILED: translate("Paver", "Faces failed")}[state]


def changes(obj):
    """What has changed since meshing, as far as that is known: names of options as properties, and words for the rest."""
    found = [translate("Paver", "a shape")] if obj.ShapeChanged else []
    found += [translate("Paver", "a label")] if obj.LabelsChanged else []
    try:
        now, options = properties.given(obj), ast.parse(obj.MeshedOptions, mode="eval").body
        while isinstance(options, ast.Subscript):  # lists of children follow that of options
            options = options.value
        then = dict(ast.literal_eval(options))
        now = dict(ast.literal_eval(properties.text_of(now)))
    except (core.CoreMissing, ValueError, SyntaxError, TypeError):
        return found
    found += [properties.property_name(name) for name in sorted({*then, *now}) if then.get(name) != now.get(name)]
    children, sizes, names = obj.MeshedOptions[options.end_col_offset:], refinement.decisive(obj), named_parts.decisive(obj)
    if children != sizes + names:
        is_size = not children.startswith(sizes) or children == names
        found.append(translate("Paver", "a refinement") if is_size else translate("Paver", "a medium, port or wire"))
    return found


def changes_text(obj):
    """Why the mesh is out of date, and what to do: a sentence without a beginning."""
    found = changes(obj)
    if not found:
        return translate("Paver", "an option or a shape has changed; mesh again")
    return translate("Paver", "changed: {}; mesh again").format(listed(found, MOST_CHANGES))


def untouch(obj):
    """Takes away FreeCAD's mark that an object is to be recomputed, which a mesh that is put into it leaves: a recompute
    would only compare shapes, and the tree would show a fresh mesh as if something were still to be done."""
    obj.purgeTouched()


def tell_readers(obj):
    """Has expressions that read results worked out at the next recompute: a mesh object has none itself, which FreeCAD would
    do that after."""
    if getattr(obj.Proxy, "told", None) == obj.MeshFile:
        return
    obj.Proxy.told = obj.MeshFile
    for other in obj.InList:
        texts = [text for _, text in other.ExpressionEngine]
        if other.isDerivedFrom("Spreadsheet::Sheet") or any(obj.Name in text or obj.Label in text for text in texts):
            other.touch()


def check(obj):
    """Compares the shapes with those that were meshed, also where FreeCAD reports no change (a moved App::Part around
    the object), and gives the Status. Where one is to be recomputed, what is recorded holds until then."""
    if not any(map(is_to_be_recomputed, parts_of(obj))):
        changed = bool(obj.MeshFile) and not has_meshed_shape(obj)
        if obj.ShapeChanged != changed:
            obj.ShapeChanged = changed
    update_status(obj)
    return obj.Status


def check_labels(obj):
    """Compares the labels of faces with those that were meshed: FreeCAD recomputes nothing that only uses a label."""
    obj.LabelsChanged = not has_meshed_labels(obj)
    update_status(obj)


def parts_of(obj):
    """All that a mesh object's shapes come from."""
    things = sources(obj)
    return {*things, *(part for thing in things for part in thing.OutListRecursive)}


def is_to_be_recomputed(thing):
    """Whether a thing makes its shape by and by: until then it is that of before, though FreeCAD's undo gives it back as a
    copy, with bytes of its own."""
    is_made = thing.isDerivedFrom("Part::Feature") and thing.TypeId != "Part::Feature"  # that one's is put in
    return is_made and "Touched" in thing.State


def has_meshed_shape(obj):
    """Whether the shapes are those that were meshed, as they were or as the document has kept them."""
    digest = shape_digest(obj)
    return digest == obj.MeshedShape or (obj.MeshedShape, digest) == getattr(obj.Proxy, "reopened", None)


def remember_reopened(obj):
    """Files of FreeCAD keep shapes with 15 digits, so that one that was opened is not the one that was saved. Those that
    come with a mesh that fits are taken for the ones that were meshed."""
    if obj.MeshFile and not obj.ShapeChanged:
        obj.Proxy.reopened = (obj.MeshedShape, shape_digest(obj))


def path_of(obj):
    """Of the mesh's file. ValueError when the object is not meshed."""
    if not obj.MeshFile:
        raise ValueError(translate("Paver", "'{}' is not meshed; mesh it first.").format(obj.Label))
    return obj.MeshFile


def stored(obj):
    """The StoredMesh. ValueError when the object is not meshed, DamagedMesh when its file is damaged."""
    return mesh_file.read(path_of(obj))


def faces_under(obj, elements):
    """[(source, ["Face3"])] that elements of the mesh, numbered from 0, lie on. ValueError when the object is not meshed, or
    its faces are no longer those that were."""
    if check(obj) == OUT_OF_DATE and obj.ShapeChanged:
        raise ValueError(translate("Paver", "The shape of '{}' has changed since meshing, so its elements tell no faces; mesh it "
                                   "again, or select faces of the model.").format(obj.Label))
    mesh, things, found = stored(obj), sources(obj), {}
    faces = [*mesh.quad_faces, *mesh.triangle_faces]
    for face in sorted({faces[element] for element in elements if element < len(faces)}):
        for name in mesh.face_names[face].split(mesh_file.BOTH):
            source, _, element = name.rpartition("_")
            thing = next((thing for thing in things if len(things) == 1 or thing.Name == source), None)
            if thing is not None:
                found.setdefault(thing, []).append(element)
    return list(found.items())


def groups_of(obj, mesh):
    """{name of a group: numbers of faces} that the object's analyses need."""
    return analysis.face_groups(obj, sources(obj), mesh.face_names)


def fem_mesh_of(obj, mesh):
    """Fem.FemMesh of a StoredMesh with all groups."""
    return fem_mesh.of_mesh(mesh, groups_of(obj, mesh))


def fill(obj, mesh=None):
    """Fills FemMesh, whatever the size, with a group for each face and for what the object's analysis needs."""
    was_touched = "Touched" in obj.State
    obj.FemMesh = fem_mesh_of(obj, mesh or stored(obj))
    if not obj.FemMeshFilled:
        obj.FemMeshFilled = True
    if not was_touched:
        untouch(obj)


def follow_analysis(obj):
    """Makes FemMesh have what the analyses that the object is in need, whatever the size. Solvers take what is there: a
    pressure without its group would be left out, without a mesh nothing is solved."""
    if not obj.MeshFile or not analysis.analyses_of(obj):
        return
    try:
        if not obj.FemMeshFilled:
            fill(obj)
        groups = analysis.renew_groups(obj.FemMesh, obj, sources(obj))
    except (mesh_file.DamagedMesh, fem_mesh.NoFemMesh) as error:
        FreeCAD.Console.PrintError(f"{obj.Label}: {error}\n")
        return
    for member in analysis.without_effect(obj, groups):
        FreeCAD.Console.PrintWarning(translate("Paver", "'{}' refers to no face of what '{}' meshes, so solvers leave it out; "
                                               "refer to faces of that.").format(member.Label, obj.Label) + "\n")


def keep(obj, mesh):
    """Puts a StoredMesh, or the file of one, by its path, into the object's file.

    The file of a path is moved, without a copy, and must lie on the disk that the document has its own files on.
    """
    path = os.path.join(obj.Document.TransientDir, free_name(obj) + ".new")
    if isinstance(mesh, str):
        os.replace(mesh, path)
    else:
        mesh_file.write(mesh, path)
    obj.MeshFile = (path, free_name(obj))  # FreeCAD moves what lies in its own folder, and copies anything else


def free_name(obj):
    """A file name that nothing in the document's folder has: by itself FreeCAD takes the one it had before."""
    names = os.listdir(obj.Document.TransientDir)
    return next(name for name in (f"{obj.Name}_{i}.paver" for i in itertools.count(1)) if name not in names)


def part_from_original(obj):
    """Gives a copy of a mesh object a file of its own: FreeCAD leaves both with one, and deletes it with either."""
    shared = obj.MeshFile
    if not shared or all(other.MeshFile != shared for other in meshes_of(obj.Document) if other != obj):
        return
    keep(obj, shutil.copyfile(shared, shared + ".copy"))
    if not os.path.exists(shared):
        shutil.copyfile(obj.MeshFile, shared)


def refill(obj):
    """Makes FemMesh what the other properties say, after opening a file and after undo and redo."""
    try:
        if obj.MeshFile and obj.FemMeshFilled:
            fill(obj)
        elif obj.FemMesh.NodeCount:
            obj.FemMesh = fem_mesh.empty()
    except mesh_file.DamagedMesh as error:
        FreeCAD.Console.PrintError(f"{obj.Label}: {error}\n")


def stay_in_place(obj):
    """Elements lie where the model stands. Whatever moved the mesh object would move what is drawn and FemMesh, but no
    file that is written."""
    if obj.Placement != FreeCAD.Placement():
        obj.Placement = FreeCAD.Placement()
    part = obj.getParentGeoFeatureGroup()
    if part is not None:
        part.removeObject(obj)
        FreeCAD.Console.PrintWarning(translate("Paver", "'{}' stays outside of '{}', which would move it: its elements lie where "
                                               "the model stands already.").format(obj.Label, part.Label) + "\n")


class MeshProxy(Stateless):
    """What FreeCAD calls. Nothing of it is stored but its name."""

    Type = MESH

    def __init__(self, obj):
        obj.Proxy = self
        add_properties(obj)
        properties.add_to(obj)
        update_status(obj)

    update_status = staticmethod(update_status)

    def execute(self, obj):
        """Meshes nothing: meshing is asked for. Only compares the shapes with those that were meshed."""
        try:
            check(obj)
        except core.CoreMissing:  # something has changed, and nothing here can tell what
            obj.ShapeChanged = bool(obj.MeshFile)
            update_status(obj)

    def onChanged(self, obj, name):
        if SHOWN_STATUS not in obj.PropertiesList:
            return
        if name == "Placement" and not is_restoring(obj):
            stay_in_place(obj)
        if name not in (*LINKS, REFINEMENTS, *named_parts.LINKS) and not properties.is_option(obj, name):
            return
        if is_restoring(obj) or "ShapeChanged" not in obj.PropertiesList:
            return
        if name == LINKS[0]:
            follow_part(obj)
        if name in LINKS and obj.MeshFile:
            obj.ShapeChanged = True  # until execute has looked
        update_status(obj)

    def onDocumentRestored(self, obj):
        add_properties(obj)
        try:
            properties.add_to(obj)
            update_status(obj)  # which a session without the core could not know
            remember_reopened(obj)
        except core.CoreMissing as error:
            FreeCAD.Console.PrintWarning(f"{obj.Label}: {error}\n")
        part_from_original(obj)
        stay_in_place(obj)
        obj.Proxy.told = obj.MeshFile
        refill(obj)
        untouch(obj)
        view = attach_view(obj)
        if view:
            view.look_later()


class Observer:
    """Fills FemMesh again, which FreeCAD's undo leaves as it is, and where members of an analysis change; compares shapes
    before they are saved, and labels when one changes; keeps meshes out of what would move them."""

    def slotChangedObject(self, obj, name):
        if name not in ("Label", "Group", "References") or is_restoring(obj):
            return
        if name == "Label":
            for mesh in [mesh for mesh in meshes_of(obj.Document) if mesh.MeshedLabels and obj in parts_of(mesh)]:
                check_labels(mesh)
            return
        changed = [obj] if name == "Group" else obj.InList
        for member in filter(is_mesh, obj.Group if name == "Group" else ()):
            stay_in_place(member)
        for group in [thing for thing in changed if thing.isDerivedFrom("Fem::FemAnalysis") and not is_restoring(thing)]:
            for member in filter(is_mesh, group.Group):
                follow_analysis(member)

    def slotUndoDocument(self, document):
        for obj in meshes_of(document):
            refill(obj)
            tell_readers(obj)
            untouch(obj)

    slotRedoDocument = slotUndoDocument

    def slotStartSaveDocument(self, document, _path):
        if not core.problem():
            for obj in meshes_of(document):
                check(obj)


def add(document, parts, name="PaverMesh", **options):
    """A new mesh object for one object or a list of them, not meshed yet; options as those of paver.mesh.

    ValueError for a bad option, CoreMissing when the core is not built; the document is then as before.
    """
    core.load()
    parts = list(parts) if isinstance(parts, (list, tuple)) else [parts]
    with new_object(document, "Fem::FemMeshObjectPython", name) as obj:
        MeshProxy(obj)
        obj.Part, obj.MoreParts = (parts or [None])[0], parts[1:]
        properties.put(obj, options)
    return obj


FreeCAD.addDocumentObserver(Observer())
