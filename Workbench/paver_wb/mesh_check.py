"""What is right and what is wrong with a mesh, in sentences."""
from typing import NamedTuple

import FreeCAD
import numpy as np

from paver_wb import mesh_object, statistics

translate = FreeCAD.Qt.translate
GOOD, NOTE, WARNING, ERROR = "good", "note", "warning", "error"
POOR = 0.3  # scaled Jacobian
LONGEST = 1.6  # of the target length


class Finding(NamedTuple):
    """level: GOOD, NOTE, WARNING or ERROR; text: a sentence; elements: their numbers from 1, quads first."""

    level: str
    text: str
    elements: tuple = ()


def check(obj):
    """[Finding] of a mesh object, the worst first. ValueError when it is not meshed."""
    mesh = mesh_object.stored(obj)
    findings = [status(obj), *failed_faces(obj), validity(mesh), shape(mesh), *borders(mesh), triangles(mesh),
                *lengths(obj, mesh)]
    order = (ERROR, WARNING, NOTE, GOOD)
    return sorted((f for f in findings if f), key=lambda finding: order.index(finding.level))


def verdict(findings):
    """The worst level."""
    return findings[0].level if findings else GOOD


def status(obj):
    if obj.Part is None and not obj.MoreParts:
        return None
    if mesh_object.check(obj) == mesh_object.UP_TO_DATE:
        return Finding(GOOD, translate("Paver", "The mesh fits its options and shapes."))
    return Finding(WARNING, translate("Paver", "The mesh is out of date: an option or a shape has changed; mesh again."))


def failed_faces(obj):
    return [Finding(ERROR, translate("Paver", "A face is not meshed: {}.").format(text.rstrip(".")))
            for text in obj.FailedFaces]


def validity(mesh):
    figures = statistics.surface_mesh(mesh).quality()
    bad = np.flatnonzero(figures.validity != 0) + 1
    if len(bad):
        return Finding(ERROR, translate("Paver", "{} elements fold, or may fold; use a smaller size there.").format(
            len(bad)), tuple(bad.tolist()))
    return Finding(GOOD, translate("Paver", "All elements are proven not to fold, curved as they are."))


def shape(mesh):
    sj = statistics.surface_mesh(mesh).quality().sj
    poor = np.flatnonzero(sj < POOR) + 1
    if len(poor):
        return Finding(WARNING, translate("Paver", "{} elements have a scaled Jacobian below {}; the least is {}.").format(
            len(poor), POOR, f"{sj.min():.3f}"), tuple(poor.tolist()))
    return Finding(GOOD, translate("Paver", "No scaled Jacobian is below {}; the least is {}.").format(
        POOR, f"{sj.min():.3f}"))


def with_edges(mesh, edges):
    """Numbers of the elements that have one of these edges."""
    wanted, found, first = {tuple(edge) for edge in edges.tolist()}, [], 1
    for rows, corners in ((mesh.quads, 4), (mesh.triangles, 3)):
        for number, row in enumerate(rows[:, :corners].tolist(), first):
            if any(tuple(sorted((row[k], row[(k + 1) % corners]))) in wanted for k in range(corners)):
                found.append(number)
        first += len(rows)
    return tuple(found)


def borders(mesh):
    edges, users = statistics.mesh_edges(mesh)
    free, several = edges[users == 1], edges[users > 2]
    findings = []
    if len(several):
        findings.append(Finding(NOTE, translate("Paver", "{} mesh edges have more than two elements: sheets meet there.")
                                .format(len(several)), with_edges(mesh, several)))
    if len(free):
        findings.append(Finding(NOTE, translate("Paver", "{} mesh edges are free: the surface is open there.").format(
            len(free)), with_edges(mesh, free)))
    else:
        findings.append(Finding(GOOD, translate("Paver", "The mesh has no free edge.")))
    return findings


def triangles(mesh):
    if not len(mesh.triangles):
        return Finding(GOOD, translate("Paver", "All elements are quads."))
    numbers = range(len(mesh.quads) + 1, len(mesh.quads) + len(mesh.triangles) + 1)
    return Finding(NOTE, translate("Paver", "{} of {} elements are triangles.").format(
        len(mesh.triangles), len(mesh.quads) + len(mesh.triangles)), tuple(numbers))


def lengths(obj, mesh):
    figures = statistics.of_mesh(mesh)
    if not figures.target:
        return []
    long = figures.lengths > LONGEST * figures.target
    if not long.any():
        return [Finding(GOOD, translate("Paver", "No edge is longer than {} of the target length.").format(LONGEST))]
    return [Finding(WARNING, translate("Paver", "{} edges are longer than {} of the target length.").format(
        int(long.sum()), LONGEST), with_edges(mesh, figures.edges[long]))]
