"""Groups of elements that solvers of the FEM workbench look for.

A pressure on a shell finds its elements by a group of faces whose name begins with that of the constraint; materials and
thicknesses are found faster so. Without such a group a pressure is left out of the calculation, with a message only.
"""
import re

from paver_wb.formats.mesh_file import BOTH


def analyses_of(obj):
    return [thing for thing in obj.InList if thing.isDerivedFrom("Fem::FemAnalysis")]


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
    return [(member.Name, source.Name, list(subelements)) for analysis in analyses_of(obj) for member in analysis.Group
            for source, subelements in getattr(member, "References", None) or [] if source in sources]


def groups_of(wanted, names, is_alone):
    """{name of a group: numbers of faces} of references(); is_alone: a single object is meshed. Needs no document."""
    groups = {}
    for member, source, subelements in wanted:
        faces = face_numbers(names, source, subelements, is_alone)
        if faces:
            groups.setdefault(member + "_Faces", set()).update(faces)
    return groups


def face_groups(obj, sources, names):
    """{name of a group: numbers of faces} for every member of the mesh object's analyses that refers to faces of what
    is meshed."""
    return groups_of(references(obj, sources), names, len(sources) < 2)
