"""Surface elements of Gmsh files, versions 2.2 and 4.1, text and binary."""
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


def read(data):
    """RawMesh of the bytes of a file. Damaged when it is none."""
    at, version, is_binary = 0, "", False
    names, physical, nodes, blocks = {}, {}, None, []
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
        elif section in ("$Entities", "$Nodes", "$Elements"):
            count = 0
            if version == "2.2":
                text, at = line(data, at)
                count = int(text)
            cursor = Cursor(data, at, is_binary)
            if section == "$Entities":
                physical = entities(cursor)
            elif section == "$Nodes":
                nodes = nodes2(cursor, count) if version == "2.2" else nodes4(cursor)
            else:
                blocks = elements2(cursor, count) if version == "2.2" else elements4(cursor, physical)
            at = cursor.at
        end = data.find(b"$End" + section[1:].encode(), at)
        at = len(data) if end < 0 else end
    if nodes is None:
        raise Damaged("it has no $Nodes")
    named = [(SURFACE[kind], rows, group_name(names, tag, number)) for kind, tag, number, rows in blocks
             if kind in SURFACE]
    return RawMesh(nodes[1], nodes[0], named)


def group_name(names, tag, number):
    """The physical name of a surface, else its number."""
    return names.get((2, number)) or f"Face{tag}"


def entities(cursor):
    """{tag of a surface: number of its physical group}."""
    physical = {}
    counts = cursor.take(4, "i8")
    for dimension in range(4):
        for _ in range(counts[dimension]):
            tag = int(cursor.take(1, "i4")[0])
            cursor.take(3 if dimension == 0 else 6, "f8")
            numbers = cursor.take(int(cursor.take(1, "i8")[0]), "i4")
            if dimension > 0:
                cursor.take(int(cursor.take(1, "i8")[0]), "i4")
            if dimension == 2 and len(numbers):
                physical[tag] = int(abs(numbers[0]))
    return physical


def nodes4(cursor):
    blocks = int(cursor.take(4, "i8")[0])
    tags, points = [], []
    for _ in range(blocks):
        dimension, _, is_parametric = cursor.take(3, "i4")
        count = int(cursor.take(1, "i8")[0])
        tags.append(cursor.take(count, "i8"))
        width = 3 + (int(dimension) if is_parametric else 0)
        points.append(cursor.take(width * count, "f8").reshape(count, width)[:, :3])
    if not tags:
        return np.zeros(0, np.int64), np.zeros((0, 3))
    return np.concatenate(tags), np.concatenate(points)


def elements4(cursor, physical):
    """[(type, tag of the surface, number of its physical group, rows of node tags)]."""
    found = []
    for _ in range(int(cursor.take(4, "i8")[0])):
        _, tag, kind = (int(n) for n in cursor.take(3, "i4"))
        width = nodes_of(kind) + 1
        count = int(cursor.take(1, "i8")[0])
        found.append((kind, tag, physical.get(tag, 0), cursor.take(count * width, "i8").reshape(count, width)[:, 1:]))
    return found


def nodes2(cursor, count):
    if cursor.is_binary:
        packed = np.frombuffer(cursor.data, "<i4, <f8, <f8, <f8", count, cursor.at)
        cursor.at += packed.nbytes
        return packed["f0"].astype(np.int64), np.stack([packed[f] for f in ("f1", "f2", "f3")], axis=1)
    table = cursor.take(4 * count, "f8").reshape(count, 4)
    return table[:, 0].astype(np.int64), table[:, 1:]


def elements2(cursor, count):
    tables, done = {}, 0
    while done < count:
        if cursor.is_binary:
            kind, several, tags = (int(n) for n in cursor.take(3, "i4"))
            table = cursor.take(several * (1 + tags + nodes_of(kind)), "i4").reshape(several, -1)[:, 1:]
        else:
            _, kind, tags = (int(n) for n in cursor.take(3, "i4"))
            several, table = 1, cursor.take(tags + nodes_of(kind), "i4").reshape(1, -1)
        for row in table:
            tables.setdefault((kind, int(row[1]) if tags > 1 else 0, int(row[0]) if tags else 0), []).append(row[tags:])
        done += several
    return [(*key, np.array(table)) for key, table in tables.items()]


def nodes_of(kind):
    if kind not in NODES:
        raise Damaged(f"it has elements of Gmsh's type {kind}, which are not known here")
    return NODES[kind]
