"""Groups of elements that solvers of the FEM workbench look for.

A pressure on a shell finds its elements by a group of faces whose name begins with that of the constraint; materials and
thicknesses are found faster so. Without such a group a pressure is left out of the calculation, with a message only.
"""
import re


def analyses_of(obj):
    return [thing for thing in obj.InList if thing.isDerivedFrom("Fem::FemAnalysis")]


def face_numbers(names, source, subelements, is_alone):
    """Numbers, from 0, of the faces of a mesh that one entry of References means; an entry without any means all."""
    prefix = "" if is_alone else source.Name + "_"
    wanted = [prefix + sub for sub in subelements if re.fullmatch(r"Face\d+", sub)]
    is_whole = not any(subelements)
    pattern = re.compile(re.escape(prefix) + r"Face\d+")
    return {i for i, name in enumerate(names) if name in wanted or is_whole and pattern.fullmatch(name)}


def face_groups(obj, sources, names):
    """{name of a group: numbers of faces} for every member of the mesh object's analyses that refers to faces of what
    is meshed."""
    groups = {}
    for analysis in analyses_of(obj):
        for member in analysis.Group:
            faces = set()
            for source, subelements in getattr(member, "References", None) or []:
                if source in sources:
                    faces |= face_numbers(names, source, subelements, len(sources) < 2)
            if faces:
                groups[member.Name + "_Faces"] = faces
    return groups
