"""Groups of elements that solvers of the FEM workbench look for.

A pressure on a shell finds its elements by a group of faces whose name begins with that of the constraint; materials and
thicknesses are found faster so. Without such a group a pressure is left out of the calculation, with a message only.
"""
import re

import FreeCAD

from paver_wb import core, refinement
from paver_wb.formats import fem_mesh
from paver_wb.formats.mesh_file import BOTH

SUFFIX = "_Faces"  # of a member's group
translate = FreeCAD.Qt.translate


def analyses_of(obj):
    return [thing for thing in obj.InList if thing.isDerivedFrom("Fem::FemAnalysis")]


def join_active(obj):
    """Puts a mesh object into the analysis of its document that is active in the window, as the FEM workbench does with its
    own meshes."""
    import FemGui
    active = FemGui.getActiveAnalysis()
    if active is None or active.Document != obj.Document or obj in active.Group:
        return
    others = [member.Label for member in active.Group if member.isDerivedFrom("Fem::FemMeshObject")]
    active.addObject(obj)
    if others:
        FreeCAD.Console.PrintWarning(translate("Paver", "'{}' has several meshes now, {}; solvers take one, so remove the "
                                               "others from it.").format(active.Label, ", ".join([*others, obj.Label])) + "\n")


def face_numbers(names, source, subelements, is_alone):
    """Numbers, from 0, of the faces of a mesh that one entry of References means, of the source of that name; an entry
    without any elements means all. What two faces have in common is of both."""
    prefix = "" if is_alone else source + "_"
    wanted = [prefix + sub for sub in subelements if re.fullmatch(r"Face\d+", sub)]
    is_whole = not any(subelements)
    pattern = re.compile(re.escape(prefix) + r"Face\d+")
    return {i for i, name in enumerate(names)
            if any(one in wanted or is_whole and pattern.fullmatch(one) for one in name.split(BOTH))}


def references(obj, sources):
    """[(name of a member of the mesh object's analyses, name of a source, elements of it that the member refers to)]."""
    return [(member.Name, source, elements) for analysis in analyses_of(obj) for member in analysis.Group
            for thing, subelements in getattr(member, "References", None) or []
            for source, elements in located(obj, sources, thing, list(subelements))]


def located(obj, sources, thing, elements):
    """[(name of a source, its elements)] that elements of a thing are: of a source, or of what is inside of one, as features
    of a Body are."""
    if thing in sources:
        return [(thing.Name, elements)]
    found = {}
    for element in elements or [""]:
        try:
            number, names = refinement.find(sources, obj, thing, element)
        except (ValueError, AttributeError, RuntimeError, core.CoreMissing):  # elsewhere, or nothing that has faces
            continue
        found.setdefault(sources[number].Name, []).extend(names)
    return list(found.items())


def without_effect(obj, groups):
    """Pressures of the mesh object's analyses that find none of its faces, and would not act."""
    return [member for analysis in analyses_of(obj) for member in analysis.Group
            if member.isDerivedFrom("Fem::ConstraintPressure") and member.References and member.Name + SUFFIX not in groups]


def groups_of(wanted, names, is_alone):
    """{name of a group: numbers of faces} of references(); is_alone: a single object is meshed. Needs no document."""
    groups = {}
    for member, source, subelements in wanted:
        faces = face_numbers(names, source, subelements, is_alone)
        if faces:
            groups.setdefault(member + SUFFIX, set()).update(faces)
    return groups


def face_groups(obj, sources, names):
    """{name of a group: numbers of faces} for every member of the mesh object's analyses that refers to faces of what
    is meshed."""
    return groups_of(references(obj, sources), names, len(sources) < 2)


def renew_groups(fem, obj, sources):
    """Makes the groups of a filled FemMesh those that members of the analyses need now, and gives their names. Its groups of
    faces tell which elements these have."""
    present = {fem.getGroupName(group): group for group in fem.Groups if fem.getGroupElementType(group) == "Face"}
    names = [name for name in present if not name.endswith(SUFFIX)]
    wanted = {name: set().union(*(fem.getGroupElements(present[names[face]]) for face in faces))
              for name, faces in face_groups(obj, sources, names).items()}
    new = dict(wanted)
    for name in [name for name in present if name.endswith(SUFFIX)]:
        if set(fem.getGroupElements(present[name])) == wanted.get(name):
            del new[name]
        else:
            fem.removeGroup(present[name])
    fem_mesh.add_elements(fem, {name: sorted(elements) for name, elements in new.items()})
    return set(wanted)
