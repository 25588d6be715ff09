"""The file that keeps a mesh inside a document: all that Paver made of it, elements of any order.

Layout: 8 bytes MAGIC, 8 bytes length of the head (little-endian), the head (JSON), then the arrays, each at a multiple
of 8 bytes. The head has `order`, `face_names`, `edge_names`, `report` and, for each array, `type`, `shape`, `offset`
(from the end of the head), `crc` and `packed`. FreeCAD compresses the file in the .FCStd, which takes a third less time and
space where whole numbers are kept as "differences" from those of the row before, and of other numbers all first bytes come
first, then all second ones ("planes"). Without `packed` an array is as it is.
"""
import json
import struct
import zlib
from typing import NamedTuple

import numpy as np

MAGIC = b"PaverM1\n"
ARRAYS = {"nodes": "<f8", "quads": "<i4", "triangles": "<i4", "quad_faces": "<i4", "triangle_faces": "<i4",
          "lines": "<i4", "line_edges": "<i4"}
OPTIONAL = {"node_targets": "<f8", "points": "<i4"}  # arrays that older files and imported meshes do not have

JUNCTIONS = "Junctions"  # the group of edges where more than two faces meet
BOTH = " + "  # between names of faces, in the name of what they have in common
NAMES = ("order", "face_names", "edge_names", "report")
LATER_NAMES = ("edge_groups", "point_names", "face_groups", "volumes")  # that older files do not have


class StoredMesh(NamedTuple):
    """Fields as those of paver.Result; face_names are those of the groups."""

    order: int
    nodes: object
    quads: object
    triangles: object
    quad_faces: object
    triangle_faces: object
    lines: object
    line_edges: object
    face_names: list
    edge_names: list
    report: dict
    node_targets: object = None
    edge_groups: tuple = ()
    points: object = None
    point_names: tuple = ()
    face_groups: tuple = ()
    volumes: tuple = ()


class DamagedMesh(ValueError):
    """A stored mesh cannot be read. The text is one sentence."""


def labels(mesh):
    """Names of a mesh's faces for people: "Ground plane/Face3". Those of groups where the report has none: of meshes that
    were read, and in documents of before these were known."""
    given = [face.get("label", face["name"]) for face in mesh.report["faces"]]
    return [name if label == face["name"] else label for name, label, face in zip(mesh.face_names, given, mesh.report["faces"])]


def group_names(mesh):
    """Names of a mesh's faces as groups of files: the port that a face is in, else as labels()."""
    names = labels(mesh)
    return [port or name for port, name in zip([*mesh.face_groups, *[""] * len(names)], names)]


def line_groups(mesh, has_junctions=False):
    """{name: (n, p + 1) rows of nodes} of a mesh's lines that are wires or in ports; of junctions too."""
    groups = np.array([*mesh.edge_groups, ""], dtype=object)  # the last one is that of no edge
    of_line = groups[np.minimum(mesh.line_edges, len(groups) - 1)] if len(mesh.line_edges) else groups[:0]
    names = dict.fromkeys(name for name in of_line.tolist() if name and (has_junctions or name != JUNCTIONS))
    return {name: mesh.lines[of_line == name] for name in names}


def wires(mesh):
    """line_groups() less those of ports."""
    ports = {port["name"] for port in mesh.report.get("ports", [])}
    return {name: lines for name, lines in line_groups(mesh).items() if name not in ports}


def points(mesh):
    """{name: nodes} of a mesh's vertices that end no edge or are in ports."""
    found = {}
    for name, node in zip(mesh.point_names, () if mesh.points is None else np.asarray(mesh.points).tolist()):
        found.setdefault(name, []).append(node)
    return found


def port_faces(mesh):
    """{name: numbers of faces, from 0} of ports."""
    found = {}
    for face, name in enumerate(mesh.face_groups):
        if name:
            found.setdefault(name, set()).add(face)
    return found


def used_nodes(count, *tables):
    """(count,) whether a node is in one of the tables of rows."""
    is_used = np.zeros(count, dtype=bool)
    for rows in tables:
        is_used[rows.ravel()] = True
    return is_used


def of_result(result, face_names):
    """StoredMesh of a paver.Result."""
    arrays = {name: getattr(result, name) for name in ARRAYS}
    arrays.update({name: getattr(result, name, None) for name in OPTIONAL})
    return StoredMesh(order=result.order, face_names=list(face_names), edge_names=list(result.edge_names),
                      edge_groups=list(result.edge_groups), point_names=list(result.point_names), face_groups=list(result.face_groups),
                      volumes=list(result.volumes), report=result.report,
                      **arrays)


def pack(array):
    """(bytes that compress well, what was done to them)."""
    if array.dtype.kind == "i":
        return np.diff(array, axis=0, prepend=np.zeros_like(array[:1])).tobytes() if len(array) else b"", "differences"
    return array.reshape(-1).view(np.uint8).reshape(-1, array.itemsize).T.tobytes(), "planes"


def unpack(part, kind, shape, packed):
    """The array of pack()'s bytes."""
    if packed == "differences":
        return np.cumsum(np.frombuffer(part, dtype=kind).reshape(shape), axis=0, dtype=kind)
    if packed == "planes":
        places = np.frombuffer(part, dtype=np.uint8).reshape(kind.itemsize, -1)
        return np.ascontiguousarray(places.T).view(kind).reshape(shape)
    if packed is not None:
        raise ValueError(packed)
    return np.frombuffer(part, dtype=kind).reshape(shape)


def write(mesh, path):
    """Writes a StoredMesh to `path`."""
    head = {name: getattr(mesh, name) for name in (*NAMES, *LATER_NAMES)}
    head["arrays"], blocks, offset = {}, [], 0
    for name, kind in {**ARRAYS, **OPTIONAL}.items():
        if name in OPTIONAL and getattr(mesh, name) is None:
            continue
        array = np.ascontiguousarray(getattr(mesh, name), dtype=kind)
        data, packed = pack(array)
        head["arrays"][name] = {"type": kind, "shape": array.shape, "offset": offset, "crc": zlib.crc32(data),
                                "packed": packed}
        blocks += [data, b"\0" * (-len(data) % 8)]
        offset += len(data) + len(blocks[-1])
    text = json.dumps(head).encode()
    text += b" " * (-len(text) % 8)
    with open(path, "wb") as file:
        file.write(MAGIC + struct.pack("<Q", len(text)) + text)
        file.writelines(blocks)


def array_of(name, entry, data):
    kind, shape = np.dtype(entry["type"]), tuple(entry["shape"])
    size = kind.itemsize * int(np.prod(shape, dtype=np.int64))
    part = data[entry["offset"]:entry["offset"] + size]
    if entry["type"] != {**ARRAYS, **OPTIONAL}[name] or len(part) != size or zlib.crc32(part) != entry["crc"]:
        raise ValueError(name)
    return unpack(part, kind, shape, entry.get("packed"))


def read(path):
    """The StoredMesh of a file. DamagedMesh when it is not one, or not whole."""
    try:
        with open(path, "rb") as file:
            content = file.read()
    except OSError as error:
        raise DamagedMesh(f"The mesh kept in the document cannot be read ({error.strerror}); mesh the object "
                          "again.") from None
    try:
        if content[:8] != MAGIC:
            raise ValueError("head")
        length, = struct.unpack("<Q", content[8:16])
        head = json.loads(content[16:16 + length])
        data = memoryview(content)[16 + length:]
        arrays = {name: array_of(name, head["arrays"][name], data)
                  for name in [*ARRAYS, *(name for name in OPTIONAL if name in head["arrays"])]}
    except (ValueError, KeyError, TypeError, struct.error) as error:
        raise DamagedMesh(f"The mesh kept in the document is damaged ({error}); mesh the object again.") from None
    later = {name: head.get(name, ()) for name in LATER_NAMES}
    return StoredMesh(**arrays, **{name: head[name] for name in NAMES}, **later)
