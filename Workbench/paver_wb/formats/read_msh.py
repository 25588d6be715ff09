"""Gmsh files, versions 2.2 and 4.1, text and binary. scripts/meshfile.py reads with it, too."""
from typing import NamedTuple

import numpy as np

from paver_wb.formats.raw_mesh import Damaged, RawMesh

# Gmsh's element types: (kind, order, nodes); other kinds are passed over.
NODES = {1: 2, 2: 3, 3: 4, 4: 4, 5: 8, 6: 6, 7: 5, 8: 3, 9: 6, 10: 9, 11: 10, 12: 27, 13: 18, 14: 14, 15: 1, 16: 8, 17: 20,
         18: 15, 19: 13, 20: 9, 21: 10, 26: 4, 36: 16, 37: 25}
SURFACE = {2: "tri3", 3: "quad4", 9: "tri6", 10: "quad9", 16: "quad8"}


class Cursor:
    """Numbers of a section, one after the other: words of text, or packed."""

    def __init__(self, data, at, is_binary):
        self.data, self.at, self.is_binary, self.words = data, at, is_binary, None
        if not is_binary:
            end = data.find(b"$End", at)
            self.words, self.word = np.array(data[at:end].split()), 0

    def take(self, count, kind):
        """kind: i4, i8 or f8."""
        if self.words is not None:
            self.word += count
            taken = self.words[self.word - count:self.word]
            if len(taken) < count:
                raise Damaged("it ends too early")
            return taken.astype(float if kind == "f8" else np.int64)
        size = count * int(kind[1])
        if count < 0 or self.at + size > len(self.data):
            raise Damaged("it ends too early")
        values = np.frombuffer(self.data, "<" + kind, count, self.at)
        self.at += size
        return values if kind == "f8" else values.astype(np.int64)


def line(data, at):
    end = data.find(b"\n", at)
    end = len(data) if end < 0 else end
    return data[at:end].decode("utf-8", "replace").strip(), end + 1


class Sections(NamedTuple):
    """What a file has. names: {(dimension, number of a physical group): name}; physical: {(dimension, tag of an entity): its
    group}, of version 4.1; nodes: (tags, (n, 3) points), None without; blocks: [(Gmsh's type, tag of the entity, its group in
    version 2.2 or 0, rows of node tags)]; totals: {section: how many nodes or elements it says that it has}."""

    names: dict
    physical: dict
    nodes: object
    blocks: list
    totals: dict


def read(data):
    """RawMesh of the bytes of a file: its surface elements. Damaged when it is none."""
    found = sections(data)
    if found.nodes is None:
        raise Damaged("it has no $Nodes")
    tags, points = found.nodes
    return RawMesh(points, tags, [(SURFACE[kind], rows, group_name(found, tag, number))
                                  for kind, tag, number, rows in found.blocks if kind in SURFACE])


def group_name(found, tag, number):
    """The physical name of a surface, else its number."""
    return found.names.get((2, number or abs(found.physical.get((2, tag), 0)))) or f"Face{tag}"


def sections(data, known=NODES):
    """The Sections of the bytes of a file. known: nodes by types of elements; Damaged for another type."""
    at, version, is_binary = 0, "", False
    names, physical, nodes, blocks, totals = {}, {}, None, [], {}
    while at < len(data):
        section, at = line(data, at)
        if not section.startswith("$") or section.startswith("$End"):
            continue
        if section == "$MeshFormat":
            head, at = line(data, at)
            version, mode = head.split()[:2]
            is_binary = mode == "1"
            if version not in ("2.2", "4.1"):
                raise Damaged(f"version {version} of .msh is not read; save it as 4.1 or 2.2")
            if is_binary and data[at:at + 4] != b"\1\0\0\0":
                raise Damaged("it is of a machine with another order of bytes")
        elif section == "$PhysicalNames":
            count, at = line(data, at)
            for _ in range(int(count)):
                entry, at = line(data, at)
                dimension, number, name = entry.split(" ", 2)
                names[int(dimension), int(number)] = name.strip('"')
        elif section == "$Entities":
            cursor = Cursor(data, at, is_binary)
            physical, at = entities(cursor), cursor.at
        elif section in ("$Nodes", "$Elements"):
            is_old = version == "2.2"
            if is_old:
                text, at = line(data, at)
            cursor = Cursor(data, at, is_binary)
            parts, totals[section] = (0, int(text)) if is_old else cursor.take(4, "i8")[:2].tolist()
            if section == "$Nodes":
                nodes = nodes2(cursor, totals[section]) if is_old else nodes4(cursor, parts)
            else:
                blocks = elements2(cursor, totals[section], known) if is_old else elements4(cursor, parts, known)
            at = cursor.at
        at = data.find(b"$End" + section[1:].encode(), at)
        if at < 0:  # what stands last may be half a number
            raise Damaged(f"{section} has no end")
    return Sections(names, physical, nodes, blocks, totals)


def entities(cursor):
    """{(dimension, tag): number of the physical group} of every entity that has one."""
    physical = {}
    counts = cursor.take(4, "i8")
    for dimension in range(4):
        for _ in range(counts[dimension]):
            tag = int(cursor.take(1, "i4")[0])
            cursor.take(3 if dimension == 0 else 6, "f8")
            numbers = cursor.take(int(cursor.take(1, "i8")[0]), "i4")
            if dimension > 0:
                cursor.take(int(cursor.take(1, "i8")[0]), "i4")
            if len(numbers):
                physical[dimension, tag] = int(numbers[0])
    return physical


def nodes4(cursor, blocks):
    tags, points = [np.zeros(0, np.int64)], [np.zeros((0, 3))]
    for _ in range(blocks):
        dimension, _, is_parametric = cursor.take(3, "i4")
        count = int(cursor.take(1, "i8")[0])
        tags.append(cursor.take(count, "i8"))
        width = 3 + (int(dimension) if is_parametric else 0)
        points.append(cursor.take(width * count, "f8").reshape(count, width)[:, :3])
    return np.concatenate(tags), np.concatenate(points)


def elements4(cursor, blocks, known):
    found = []
    for _ in range(blocks):
        _, tag, kind = (int(n) for n in cursor.take(3, "i4"))
        width = nodes_of(kind, known) + 1
        count = int(cursor.take(1, "i8")[0])
        found.append((kind, tag, 0, cursor.take(count * width, "i8").reshape(count, width)[:, 1:]))
    return found


def nodes2(cursor, count):
    if cursor.is_binary:
        packed = np.frombuffer(cursor.data, "<i4, <f8, <f8, <f8", count, cursor.at)
        cursor.at += packed.nbytes
        return packed["f0"].astype(np.int64), np.stack([packed[f] for f in ("f1", "f2", "f3")], axis=1)
    table = cursor.take(4 * count, "f8").reshape(count, 4)
    return table[:, 0].astype(np.int64), table[:, 1:]


def elements2(cursor, count, known):
    tables, done = {}, 0
    while done < count:
        if cursor.is_binary:
            kind, several, tags = (int(n) for n in cursor.take(3, "i4"))
            table = cursor.take(several * (1 + tags + nodes_of(kind, known)), "i4").reshape(several, -1)[:, 1:]
        else:
            _, kind, tags = (int(n) for n in cursor.take(3, "i4"))
            several, table = 1, cursor.take(tags + nodes_of(kind, known), "i4").reshape(1, -1)
        for row in table:
            tables.setdefault((kind, int(row[1]) if tags > 1 else 0, int(row[0]) if tags else 0), []).append(row[tags:])
        done += several
    return [(*key, np.array(table)) for key, table in tables.items()]


def nodes_of(kind, known):
    if kind not in known:
        raise Damaged(f"it has elements of Gmsh's type {kind}, which are not known here")
    return known[kind]
