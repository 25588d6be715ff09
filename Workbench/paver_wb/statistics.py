"""Figures of a mesh for people who compute with it: sizes in millimetres and wavelengths, unknowns, matrix memory."""
from math import floor
from typing import NamedTuple

import FreeCAD
import numpy as np

from paver_wb import core, mesh_object
from paver_wb.base.units import MM
from paver_wb.base.waves import wavelength, wavelength_of
from paver_wb.formats import mesh_file

translate = FreeCAD.Qt.translate
FEWEST = 5  # faces that are named
BYTES_DOUBLE = 16  # of a complex number


class Wave(NamedTuple):
    """frequency: Hz; length: wavelength in the medium, mm."""

    frequency: float
    length: float


class Figures(NamedTuple):
    """name: of the mesh object. quads, triangles, nodes: counts.

    edges: (e, 2) mesh edges between corners, once each, lines where there are only wires; lengths: (e,) chords, mm; users: (e,) elements at each.
    areas: (elements,) mm^2, of the curved elements, quads first; sj: (elements,); validity: (elements,) as
    paver.ElementQuality has it; target: target length, mm.
    wave: Wave around the solids, or None; densest: by how much the shortest wavelength of the media is shorter.
    faces: FaceFigures of each face that has elements; segment: least length of a wire's lines by its radius, 0: none.
    """

    name: str
    quads: int
    triangles: int
    nodes: int
    edges: object
    lengths: object
    users: object
    areas: object
    sj: object
    validity: object
    target: float
    wave: object
    densest: float = 1.0
    faces: tuple = ()
    segment: float = 0.0


class FaceFigures(NamedTuple):
    """elements: how many; area: mm^2; densest: by how much the wavelength of the media beside it is shorter."""

    label: str
    elements: int
    area: float
    densest: float


class Row(NamedTuple):
    """A row of the table: group and name in the user's language; value as text, the same in wavelengths or empty."""

    group: str
    name: str
    value: str
    in_waves: str = ""


def wave_of(obj):
    """The Wave that a mesh object's options ask for; None where they give a length."""
    length = wavelength_of(obj)
    return Wave(obj.Frequency.Value, length) if length else None


def wave_at(frequency, eps_r=1.0, mu_r=1.0):
    return Wave(frequency, wavelength(frequency, eps_r, mu_r))


def mesh_edges(mesh):
    """(edges, users) of a StoredMesh: pairs of corner nodes, rising, and how many elements have each; the lines where there
    are only wires."""
    every = np.concatenate([keys.ravel() for keys in element_edges(mesh)])
    keys, users = np.unique(every if len(every) else edge_keys(mesh, np.asarray(mesh.lines)[:, :2]), return_counts=True)
    return np.stack(np.divmod(keys, len(mesh.nodes) + 1), axis=1), users


def edge_keys(mesh, pairs):
    """(...,) a number for each of (..., 2) pairs of nodes, the same either way round."""
    low, high = np.moveaxis(np.sort(pairs.astype(np.int64), axis=-1), -1, 0)
    return low * (len(mesh.nodes) + 1) + high


def element_edges(mesh):
    """edge_keys() of the (quads, 4) and (triangles, 3) sides of the elements."""
    corners = mesh.quads[:, :4], mesh.triangles[:, :3]
    return [edge_keys(mesh, np.stack([rows, np.roll(rows, -1, axis=1)], axis=-1)) for rows in corners]


def edge_lengths(mesh, edges):
    """(edges,) chords of pairs of nodes, mm."""
    nodes = np.asarray(mesh.nodes)
    return np.linalg.norm(nodes[edges[:, 0]] - nodes[edges[:, 1]], axis=1)


def surface_mesh(mesh):
    """paver.SurfaceMesh of a StoredMesh."""
    names = ("order", "nodes", "quads", "triangles", "quad_faces", "triangle_faces", "lines", "line_edges")
    points = () if mesh.points is None else mesh.points
    return core.load().SurfaceMesh(**{name: getattr(mesh, name) for name in names}, points=points)


def of_mesh(mesh, name="", wave=None):
    """Figures of a StoredMesh."""
    edges, users = mesh_edges(mesh)
    quality = surface_mesh(mesh).quality()
    nodes = int(mesh_file.used_nodes(len(mesh.nodes), mesh.quads, mesh.triangles, np.asarray(mesh.lines)).sum())
    return Figures(name, len(mesh.quads), len(mesh.triangles), nodes, edges, edge_lengths(mesh, edges), users,
                   quality.area, quality.sj, quality.validity, mesh.report.get("target_length") or 0.0, wave,
                   shorter_by(mesh.report), faces_of(mesh, quality.area), mesh.report.get("solver", {}).get("segment") or 0.0)


def shorter_by(report):
    """The shortest wavelength of the media by that around the solids; 1 where there is none, or was not yet told."""
    solver = report.get("solver", {})
    return solver["wavelength"] / solver["wavelength_around"] if solver.get("wavelength") else 1.0


def faces_of(mesh, areas):
    """(FaceFigures,) of a StoredMesh; none where its report does not know faces. areas: of the elements."""
    if "faces" not in mesh.report:
        return ()
    faces = np.concatenate([mesh.quad_faces, mesh.triangle_faces])
    labels = mesh_file.labels(mesh)
    elements, sizes = np.bincount(faces, minlength=len(labels)), np.bincount(faces, areas, minlength=len(labels))
    around = mesh.report.get("solver", {}).get("wavelength_around")
    found = []
    for face, label in enumerate(labels):
        if elements[face] and sizes[face] > 0:
            told = mesh.report["faces"][face].get("elements_per_square_wavelength")
            plain = elements[face] / sizes[face] * around ** 2 if around else 0
            found.append(FaceFigures(label, int(elements[face]), float(sizes[face]), (told / plain) ** 0.5 if told and plain else 1.0))
    return tuple(found)


def per_square(face, wave):
    """Elements of a FaceFigures per square wavelength."""
    return face.elements / face.area * (face.densest * wave.length) ** 2


def hints(figures):
    """What may trouble a solver, one sentence each, as the core has them."""
    if not len(figures.lengths):
        return []
    wave = figures.densest * figures.wave.length if figures.wave else 0
    return core.load()._paver.solver_hints(float(figures.lengths.min()), float(figures.lengths.max()), float(wave),
                                           int((figures.users > 2).sum()), float(figures.segment))


def of_object(obj, frequency=None):
    """Figures of a mesh object; `frequency` (Hz) in place of its own. ValueError when it is not meshed."""
    wave = wave_of(obj) if frequency is None else wave_at(frequency, obj.EpsR, obj.MuR)
    return of_mesh(mesh_object.stored(obj), obj.Label, wave)


def unknowns(figures, order=1):
    """Unknowns of an electric-field integral equation on a perfect conductor, div-conforming basis functions of full
    order `order` (1: rooftops and RWG): per mesh edge with k elements (k - 1) * order, inside a quad
    2 * order * (order - 1), inside a triangle order * (order - 1)."""
    on_edges = int((figures.users - 1).sum()) * order
    return on_edges + (2 * figures.quads + figures.triangles) * order * (order - 1)


def number(value):
    """Four digits, or all of a whole number with gaps between thousands."""
    return f"{value:,}".replace(",", "\u202f") if isinstance(value, int) else f"{value:.4g}"


def memory(size):
    """Bytes as text."""
    for unit in ("B", "KiB", "MiB", "GiB", "TiB"):
        if size < 1024 or unit == "TiB":
            return f"{size:.0f} {unit}" if unit == "B" else f"{size:.3g} {unit}"
        size /= 1024


def spread(group, values, unit, wave, power):
    """Rows for least, mean and largest; unit: the Unit of lengths, None for a number without one."""
    if not len(values):
        return []
    rows = []
    for name, value in ((translate("Paver", "Least"), values.min()), (translate("Paver", "Mean"), values.mean()),
                        (translate("Paver", "Largest"), values.max())):
        in_waves = f"{number(value / wave.length ** power)} {'λ' if power == 1 else 'λ²'}" if wave else ""
        rows.append(Row(group, name, measured(value, unit, power) if power else number(value), in_waves if power else ""))
    return rows


def measured(value, unit, power):
    """A length, or with power 2 an area, in that unit."""
    return f"{number(value / unit.size ** power)} {unit.name}{'²' if power == 2 else ''}"


def rows(figures, unit=MM):
    """The table; unit: of lengths, and of areas."""
    wave, elements = figures.wave, figures.quads + figures.triangles
    counts, lengths = translate("Paver", "Elements"), translate("Paver", "Edge length")
    areas, dense = translate("Paver", "Element area"), translate("Paver", "In the densest medium")
    table = [Row(counts, translate("Paver", "Quads"), number(figures.quads)),
             Row(counts, translate("Paver", "Triangles"), number(figures.triangles)),
             Row(counts, translate("Paver", "Nodes"), number(figures.nodes)),
             Row(counts, translate("Paver", "Edges"), number(len(figures.edges)))]
    if figures.target:
        in_waves = f"{number(figures.target / wave.length)} λ" if wave else ""
        table.append(Row(lengths, translate("Paver", "Target"), measured(figures.target, unit, 1), in_waves))
    table += spread(lengths, figures.lengths, unit, wave, 1) + spread(areas, figures.areas, unit, wave, 2)
    total = figures.areas.sum()
    table.append(Row(areas, translate("Paver", "Total"), measured(total, unit, 2),
                     f"{number(total / wave.length ** 2)} λ²" if wave else ""))
    if wave and total > 0:
        per_area = elements / (total / wave.length ** 2)
        table.append(Row(areas, translate("Paver", "Elements per λ²"), "", number(per_area)))
    if wave and figures.densest < 1 and len(figures.lengths):
        length = figures.densest * wave.length
        table += [Row(dense, translate("Paver", "Wavelength"), measured(length, unit, 1)),
                  Row(dense, translate("Paver", "Shortest edge"), "", f"{number(figures.lengths.min() / length)} λ"),
                  Row(dense, translate("Paver", "Longest edge"), "", f"{number(figures.lengths.max() / length)} λ")]
    if wave and len(figures.faces) > 1:
        fewest = sorted(figures.faces, key=lambda face: per_square(face, wave))[:FEWEST]
        table += [Row(translate("Paver", "Fewest elements per λ²"), face.label, "", number(per_square(face, wave)))
                  for face in fewest]
    table += spread(translate("Paver", "Scaled Jacobian"), figures.sj, None, None, 0)
    for order, name in enumerate((translate("Paver", "Basis order 1 (rooftops, RWG)"), translate("Paver", "Basis order 2"),
                                  translate("Paver", "Basis order 3")), 1):
        count = unknowns(figures, order)
        table.append(Row(translate("Paver", "Unknowns (conductor)"), name, number(count), memory(BYTES_DOUBLE * count ** 2)))
    return table


def text(figures, unit=MM):
    """The table as lines, with tabs between columns."""
    lines = [figures.name] + ["\t".join(row) for row in rows(figures, unit)] + hints(figures)
    return "\n".join(lines) + "\n"


class Charts(NamedTuple):
    """histogram() of the lengths in mm, of the areas in mm^2, and of the scaled Jacobian."""

    lengths: tuple
    areas: tuple
    sj: tuple


def charts(figures):
    """The Charts of Figures."""
    least = float(figures.sj.min()) if len(figures.sj) else 0.0
    below_least = min(0.9, floor(10 * least) / 10)
    return Charts(histogram(figures.lengths), histogram(figures.areas), histogram(figures.sj, limits=(below_least, 1.0)))


def histogram(values, bins=24, limits=None):
    """(counts, limits of the bins) from least to largest, or between `limits`, which take in every value at their ends;
    values that are nearly alike get wider limits, so that numbers on an axis differ."""
    values = np.asarray(values, dtype=float)
    values = values[np.isfinite(values)]
    if not len(values):
        return np.zeros(1, int), np.array([0.0, 1.0])
    low, high = limits or (values.min(), values.max())
    least_width = 0.1 * abs(0.5 * (high + low)) or 1.0
    if high - low < least_width:
        low, high = 0.5 * (low + high - least_width), 0.5 * (low + high + least_width)
    return np.histogram(np.clip(values, low, high), bins=bins, range=(low, high))
