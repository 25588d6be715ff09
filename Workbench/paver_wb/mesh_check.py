"""What is right and what is wrong with a mesh, in sentences."""
import itertools
from typing import NamedTuple

import FreeCAD
import numpy as np

from paver_wb import mesh_object, statistics
from paver_wb.base.texts import counted, listed
from paver_wb.formats import mesh_file

translate = FreeCAD.Qt.translate
GOOD, NOTE, WARNING, ERROR = "good", "note", "warning", "error"
POOR = 0.3  # scaled Jacobian
LONGEST = 1.6  # of the target length
SHORTEST = 0.1  # of the local target length: what `merge` takes for small, too
ROUNDING = 1e-6  # of a length
MOST_CONTACTS = 3  # are named
MOST_MERGES, MOST_PLACES = 5, 50  # are named, are shown


class Finding(NamedTuple):
    """level: GOOD, NOTE, WARNING or ERROR; text: a sentence; elements: their numbers from 1, quads first; places: (x, y, z)
    where there are no elements."""

    level: str
    text: str
    elements: tuple = ()
    places: tuple = ()


def check(obj):
    """[Finding] of a mesh object, the worst first. ValueError when it is not meshed."""
    return in_order(of_document(obj) + of_mesh(mesh_object.stored(obj)))


def of_document(obj, looks=True):
    """[Finding] of what the mesh's own file does not tell. looks: whether the shapes are compared again."""
    return [finding for finding in (status(obj, looks),) if finding]


def of_mesh(mesh, figures=None):
    """[Finding] of a StoredMesh; looks at no document, so any thread may ask. figures: its statistics.Figures, where they are
    at hand."""
    figures = figures or statistics.of_mesh(mesh)
    surface = [validity(figures), shape(figures), *borders(mesh, figures), triangles(figures)] if len(figures.sj) else [
        Finding(GOOD, translate("Paver", "There are no elements but lines of wires."))]
    return [*failed_faces(mesh), *lost_parts(mesh), *surface, *repairs(mesh), *merges(mesh), *parts(mesh),
            *lengths(mesh, figures), *short_edges(mesh, figures)]


def in_order(findings):
    """The worst first."""
    return sorted(findings, key=lambda finding: (ERROR, WARNING, NOTE, GOOD).index(finding.level))


def verdict(findings):
    """The worst level."""
    return findings[0].level if findings else GOOD


def status(obj, looks=True):
    if obj.Part is None and not obj.MoreParts and obj.Status == mesh_object.UP_TO_DATE:
        return None  # it was imported
    if (mesh_object.check(obj) if looks else obj.Status) == mesh_object.UP_TO_DATE:
        return Finding(GOOD, translate("Paver", "The mesh fits its options and shapes."))
    return Finding(WARNING, translate("Paver", "The mesh is out of date ({}).").format(mesh_object.changes_text(obj)))


def failed_faces(mesh):
    """Of a StoredMesh, each with the place of its fault where that is known."""
    return [Finding(ERROR, translate("Paver", "{} is not meshed: {}.").format(label, face["reason"].rstrip(".")),
                    places=(tuple(face["where"]),) if "where" in face else ())
            for label, face in zip(mesh_file.labels(mesh), mesh.report["faces"]) if face["status"] == "failed"]


def lost_parts(mesh):
    """Parts of ports and wires that the mesh has not got. None of documents that were saved before this was known."""
    return [Finding(ERROR, translate("Paver", "Not in the mesh: {}; name what stays, or mend what fails.").format(part))
            for part in mesh.report.get("lost_parts", [])]


def several(level, elements, count, one, many, *values):
    """A Finding on so many things, in the sentence that fits: of the count and further values."""
    return Finding(level, counted(count, one, many).format(count, *values), elements)


def validity(figures):
    bad = figures.validity != 0
    if bad.any():
        return several(ERROR, numbers(bad), bad.sum(), translate("Paver", "{} element folds, or may fold; use a smaller size there."),
                       translate("Paver", "{} elements fold, or may fold; use a smaller size there."))
    return Finding(GOOD, translate("Paver", "All elements are proven not to fold, curved as they are."))


def shape(figures):
    sj = figures.sj
    poor = np.flatnonzero(sj < POOR) + 1
    poor = poor[np.argsort(sj[poor - 1], kind="stable")]  # the worst first
    if len(poor):
        return several(WARNING, tuple(poor.tolist()), len(poor), translate("Paver", "{} element has a scaled Jacobian below {}: {}."),
                       translate("Paver", "{} elements have a scaled Jacobian below {}; the least is {}."), POOR, f"{sj.min():.3f}")
    return Finding(GOOD, translate("Paver", "No scaled Jacobian is below {}; the least is {}.").format(
        POOR, f"{sj.min():.3f}"))


def with_edges(mesh, edges):
    """Numbers of the elements that have one of these edges."""
    wanted = statistics.edge_keys(mesh, edges)
    return numbers(np.concatenate([np.isin(keys, wanted).any(axis=1) for keys in statistics.element_edges(mesh)]))


def borders(mesh, figures):
    edges, users = figures.edges, figures.users
    free, crowded = edges[users == 1], edges[users > 2]
    findings = []
    if len(crowded):
        findings.append(several(NOTE, with_edges(mesh, crowded), len(crowded),
                                translate("Paver", "{} mesh edge has more than two elements: sheets meet there."),
                                translate("Paver", "{} mesh edges have more than two elements: sheets meet there.")))
    if len(free):
        findings.append(several(NOTE, with_edges(mesh, free), len(free), translate("Paver", "{} mesh edge is free: the surface is open there."),
                                translate("Paver", "{} mesh edges are free: the surface is open there.")))
    else:
        findings.append(Finding(GOOD, translate("Paver", "The mesh has no free edge.")))
    return findings


def repair_names():
    """{kind in the report: what users read}."""
    return {"sewn edges": translate("Paver", "edges sewn"), "closed loops": translate("Paver", "open loops closed"),
            "turned loops": translate("Paver", "loops turned"), "images": translate("Paver", "curves put on their surface"),
            "periodic edges": translate("Paver", "missing periodic edges added"),
            "poles": translate("Paver", "missing poles added"), "borders": translate("Paver", "missing borders added"),
            "turned faces": translate("Paver", "faces turned over"),
            "dropped faces": translate("Paver", "faces dropped that lie on others")}


def repairs(mesh):
    """What was repaired in the model. Nothing of documents that were saved before this was known."""
    made = mesh.report["model"].get("repairs", [])
    if not made:
        return []
    names = repair_names()
    listed = ", ".join(f"{repair['count']} {names.get(repair['kind'], repair['kind'])}" for repair in made)
    return [Finding(NOTE, translate("Paver", "The model was repaired: {}.").format(listed))]


def merges(mesh):
    """What was merged, as it is small or lies in the plane of others. Nothing of documents that were saved before this was known."""
    made = mesh.report.get("merges", [])
    if not made:
        return []
    return [several(NOTE, at_places(mesh, [merge["where"] for merge in made[:MOST_PLACES]]), len(made),
                    translate("Paver", "{} edge or face was merged, of {} mm: {}."),
                    translate("Paver", "{} edges and faces were merged, up to {} mm: {}."),
                    f"{max(merge['size'] for merge in made):.3g}", listed([merge["name"] for merge in made], MOST_MERGES))]


def at_places(mesh, places):
    """Numbers of the elements about the nodes nearest to the places."""
    nodes = [np.argmin(((mesh.nodes - np.array(place)) ** 2).sum(axis=1)) for place in places]
    return numbers(np.concatenate([np.isin(elements, nodes).any(axis=1) for elements in (mesh.quads, mesh.triangles)]))


def elements_of(mesh, names):
    """(elements,) whether an element is on a face of one of these parts."""
    wanted = set(names)
    is_theirs = np.array([bool(wanted.intersection((*face.get("front", ()), *face.get("back", ()), *owners(label))))
                          for face, label in zip(mesh.report["faces"], mesh_file.labels(mesh))], dtype=bool)
    return is_theirs[np.concatenate([mesh.quad_faces, mesh.triangle_faces])]


def owners(label):
    """Names of the objects of a face: ["A", "B"] of "A/Face2 + B/Face1"."""
    return [part.rpartition("/")[0] for part in label.split(mesh_file.BOTH) if "/" in part]


def nodes_of(mesh, chosen):
    """(nodes,) whether a node is in one of the chosen elements."""
    return mesh_file.used_nodes(len(mesh.nodes), mesh.quads[chosen[:len(mesh.quads)]],
                                mesh.triangles[chosen[len(mesh.quads):]])


def between(mesh, names):
    """Numbers of the elements where two parts share nodes."""
    shared = np.flatnonzero(np.logical_and.reduce([nodes_of(mesh, elements_of(mesh, [name])) for name in names]))
    has = np.concatenate([np.isin(rows, shared).any(axis=1) for rows in (mesh.quads, mesh.triangles)])
    return numbers(has)


def numbers(has):
    """Of elements, from 1."""
    return tuple((np.flatnonzero(has) + 1).tolist())


def touching(report):
    """Pairs of parts that touch or cross, each once, in however many places they do."""
    return list({frozenset(contact["parts"]): contact["parts"] for contact in report["model"].get("contacts", [])}.values())


def contacts(mesh):
    found = touching(mesh.report)
    if not found:
        return []
    elements = dict.fromkeys(itertools.chain.from_iterable(between(mesh, pair) for pair in found[:MOST_PLACES]))
    texts = [" \u2013 ".join(pair) for pair in found]
    return [several(NOTE, tuple(sorted(elements)), len(found), translate("Paver", "{} pair of parts touches: {}."),
                    translate("Paver", "{} pairs of parts touch: {}."), listed(texts, MOST_CONTACTS))]


def separate_meshes(mesh):
    """All but the largest are shown."""
    components = mesh.report.get("components", [])
    if len(components) < 2:
        return []
    members = sorted((elements_of(mesh, names) for names in components), key=lambda has: has.sum())
    texts = listed([names[0] for names in components], MOST_CONTACTS, "; ")
    return [Finding(WARNING, translate("Paver", "There are {} separate meshes, which share no node: {}.").format(
        len(components), texts), numbers(np.logical_or.reduce(members[:-1])))]


def parts(mesh):
    """What touches what, and how many meshes come of it. None of documents that were saved before this was known."""
    findings = contacts(mesh)
    for pair in mesh.report["model"].get("unconnected", []):
        findings.append(Finding(ERROR, translate("Paver", "{} touch but could not be connected; repair or fuse them.").format(
            " \u2013 ".join(pair)), numbers(elements_of(mesh, pair))))
    for solid in mesh.report["model"].get("one_sided", []):
        findings.append(Finding(ERROR, translate("Paver", "The faces of {} cannot all look outwards; repair the solid.").format(
            solid), numbers(elements_of(mesh, [solid]))))
    for solid in mesh.report["model"].get("open_solids", []):
        findings.append(Finding(WARNING, translate("Paver", "{} is open: faces are missing or do not meet.").format(solid),
                                numbers(elements_of(mesh, [solid]))))
    if unread := mesh.report["model"].get("unread", []):
        findings.append(Finding(WARNING, translate("Paver", "Not read, or not as the file has it: {}.").format(
            listed(unread, MOST_CONTACTS))))
    for gap in mesh.report.get("gaps", []):
        text = (translate("Paver", "{} is open where its edges run along each other, {} mm apart.")
                if gap["parts"][0] == gap["parts"][1] else
                translate("Paver", "{} come within {} mm of each other and share no node there."))
        findings.append(Finding(WARNING, text.format(
            " \u2013 ".join(dict.fromkeys(gap["parts"])), f"{gap['distance']:.3g}"), at_places(mesh, [gap["where"]])))
    if crossings := mesh.report.get("crossings", []):
        texts = [" \u2013 ".join(dict.fromkeys(crossing["faces"])) for crossing in crossings]
        findings.append(Finding(WARNING, translate("Paver", "Elements run through each other: {}.").format(
            listed(texts, MOST_CONTACTS, "; ")), at_places(mesh, [crossing["where"] for crossing in crossings])))
    return findings + separate_meshes(mesh)


def triangles(figures):
    if not figures.triangles:
        return Finding(GOOD, translate("Paver", "All elements are quads."))
    total = figures.quads + figures.triangles
    return several(NOTE, tuple(range(figures.quads + 1, total + 1)), figures.triangles, translate(
        "Paver", "{} of {} elements is a triangle."), translate("Paver", "{} of {} elements are triangles."), total)


def lengths(mesh, figures):
    if not figures.target:
        return []
    long = figures.lengths > LONGEST * figures.target
    if not long.any():
        return [Finding(GOOD, translate("Paver", "No edge is longer than {} of the target length.").format(LONGEST))]
    return [several(WARNING, with_edges(mesh, figures.edges[long]), long.sum(), translate("Paver", "{} edge is longer than {} of the target length."),
                    translate("Paver", "{} edges are longer than {} of the target length."), LONGEST)]


def short_edges(mesh, figures):
    """Edges far shorter than wanted at their place: what refinements, tips and sharp edges ask for is wanted there. None where
    that is not known: of imported meshes, and in older documents."""
    if mesh.node_targets is None or not len(mesh.node_targets) or not len(figures.edges):
        return []
    wanted = np.asarray(mesh.node_targets)[figures.edges].mean(axis=1)
    short = figures.lengths < (1 - ROUNDING) * SHORTEST * wanted
    if not short.any():
        return [Finding(GOOD, translate("Paver", "No edge is shorter than {} of the target length at its place.").format(
            SHORTEST))]
    least = np.flatnonzero(short)[np.argmin(figures.lengths[short] / wanted[short])]
    return [several(WARNING, with_edges(mesh, figures.edges[short]), short.sum(),
                    translate("Paver", "{} edge is far shorter than wanted, {} mm instead of {} mm; remove small "
                              "details of the model, or refine there."),
                    translate("Paver", "{} edges are far shorter than wanted, the worst {} mm instead of {} mm; remove small details of "
                              "the model, or refine there."), f"{figures.lengths[least]:.3g}", f"{wanted[least]:.3g}")]
