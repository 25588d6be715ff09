"""Surface cells of VTK's XML files for unstructured grids (.vtu): text, base64 and appended data, compressed or not."""
import base64
import re
import xml.etree.ElementTree as ElementTree
import zlib

import numpy as np

from paver_wb.formats.raw_mesh import Damaged, RawMesh

# VTK's cell types: kind; 69 and 70 are Lagrange cells, whose order their count of nodes tells.
CELLS = {(5, 3): "tri3", (9, 4): "quad4", (22, 6): "tri6", (23, 8): "quad8", (28, 9): "quad9", (69, 3): "tri3",
         (69, 6): "tri6", (70, 4): "quad4", (70, 9): "quad9"}
SURFACE = (5, 7, 9, 22, 23, 28, 34, 69, 70)
TYPES = {"Float64": "f8", "Float32": "f4", "Int64": "i8", "Int32": "i4", "Int16": "i2", "Int8": "i1", "UInt64": "u8",
         "UInt32": "u4", "UInt16": "u2", "UInt8": "u1"}


def letters(size):
    """Of base64 for so many bytes."""
    return 4 * -(-size // 3)


class File:
    """The tree of a file and its appended data."""

    def __init__(self, data):
        match = re.search(rb"<AppendedData[^>]*encoding=\"(\w+)\"[^>]*>\s*_", data)
        self.appended, self.encoding = b"", ""
        if match:
            end = data.rfind(b"</AppendedData>")
            self.appended, self.encoding = data[match.end():end], match.group(1).decode()
            data = data[:match.start()] + data[end + len(b"</AppendedData>"):]
        try:
            self.root = ElementTree.fromstring(data)
        except ElementTree.ParseError as error:
            raise Damaged(f"its XML is damaged ({error})") from None
        if self.root.tag != "VTKFile" or self.root.get("type") != "UnstructuredGrid":
            raise Damaged("it is not an unstructured grid of VTK")
        self.order = "<" if self.root.get("byte_order", "LittleEndian") == "LittleEndian" else ">"
        self.header = self.order + TYPES[self.root.get("header_type", "UInt32")]
        compressor = self.root.get("compressor")
        if compressor not in (None, "vtkZLibDataCompressor"):
            raise Damaged(f"its compression {compressor} is not known here")
        self.is_compressed = compressor is not None

    def array(self, node):
        kind = self.order + TYPES[node.get("type")]
        style = node.get("format", "ascii")
        if style == "ascii":
            return np.array((node.text or "").split()).astype(kind)
        if style == "binary":
            return np.frombuffer(self.unpacked((node.text or "").strip().encode()), kind)
        data = self.appended[int(node.get("offset", 0)):]
        is_raw = self.encoding == "raw"
        return np.frombuffer(self.unpacked(data, lambda data, size: data[:size], int) if is_raw else self.unpacked(data), kind)

    def unpacked(self, data, read=lambda text, size: base64.b64decode(text[:letters(size)])[:size], length=letters):
        """The data after their size, in one piece with it; or of compressed blocks, whose number, size, last size and sizes
        after compression are a piece of their own. read(data, size): so many bytes of the first piece; length(size): of it."""
        size = np.dtype(self.header).itemsize
        first = int(np.frombuffer(read(data, size), self.header)[0])
        if not self.is_compressed:
            return read(data, size + first)[size:]
        head = np.frombuffer(read(data, size * (3 + first)), self.header)
        sizes = head[3:].tolist()
        blocks, at, parts = read(data[length(head.nbytes):], sum(sizes)), 0, []
        for size in sizes:
            parts.append(zlib.decompress(blocks[at:at + size]))
            at += size
        return b"".join(parts)


def read(data):
    """RawMesh of the bytes of a file; groups by a cell array `face`, where there is one. Damaged when it is none."""
    try:
        return parsed(File(data))
    except (ValueError, KeyError, TypeError, IndexError, AttributeError, zlib.error) as error:
        if isinstance(error, Damaged):
            raise
        raise Damaged(f"its data are damaged ({error})") from None


def parsed(file):
    points, blocks, first = [], [], 0
    for piece in file.root.iter("Piece"):
        own = file.array(piece.find("Points/DataArray")).reshape(-1, 3)
        cells = {node.get("Name"): file.array(node) for node in piece.find("Cells")}
        faces = next((file.array(node) for node in piece.iterfind("CellData/DataArray") if node.get("Name") == "face"),
                     None)
        ends = cells["offsets"].astype(np.int64)
        counts = np.diff(ends, prepend=0)
        for kind, count in sorted(set(zip(cells["types"].tolist(), counts.tolist()))):
            which = np.flatnonzero((cells["types"] == kind) & (counts == count))
            if (kind, count) not in CELLS:
                if kind in SURFACE:
                    raise Damaged(f"it has cells of VTK's type {kind} with {count} nodes, which are not known here")
                continue
            starts = ends[which] - count
            rows = cells["connectivity"].astype(np.int64)[starts[:, None] + np.arange(count)] + first
            tags = faces[which] if faces is not None else np.ones(len(which), int)
            blocks += [(CELLS[kind, count], rows[tags == tag], f"Face{int(tag)}") for tag in np.unique(tags)]
        points.append(own)
        first += len(own)
    every = np.concatenate(points) if points else np.zeros((0, 3))
    return RawMesh(every, np.arange(len(every)), blocks)
