"""Reads .vtu files with nothing but Python: XML, zlib and struct. Also what a mesh document says of the same elements."""
import functools
import json
import math
import operator
import pathlib
import re
import struct
import subprocess
import xml.etree.ElementTree as ElementTree
import zlib
from fractions import Fraction

TYPES = {"Float64": "d", "Int64": "q", "Int32": "i", "UInt8": "B"}
EXAMPLES = pathlib.Path(__file__).resolve().parent.parent.parent.parent / "samples/examples"
BEZIER, LAGRANGE = {"triangle": 76, "curve": 75}, {"triangle": 69, "curve": 68}


def run(*words, status=0, text=None):
    done = subprocess.run(words, capture_output=True, input=text, timeout=500)
    if done.returncode != status:
        raise AssertionError(f"{words}: status {done.returncode}: {done.stderr[:2000]}")
    return done


def make_mesh(kind, degree, time="0"):
    """Writes mesh.json, with the field u: a kind of sample_mesh (degree 1 to 7), or a boundary of samples/examples."""
    made = run("bspline2mesh", "-q", "--degree", str(degree), "--field", "u=x-y", EXAMPLES / kind) \
        if kind.endswith(".json") else run("sample_mesh", kind, str(degree), time)
    pathlib.Path("mesh.json").write_bytes(made.stdout)
    return Document("mesh.json")


def inflate(data, offset):
    """The bytes of the array at an offset of the appended data, and where it ends."""
    blocks, size, last = struct.unpack_from("<QQQ", data, offset)
    sizes = struct.unpack_from(f"<{blocks}Q", data, offset + 24)
    at, parts = offset + 24 + 8 * blocks, []
    for k, packed in enumerate(sizes):
        part = zlib.decompress(data[at:at + packed])
        if len(part) != (last if k + 1 == blocks and last else size):
            raise AssertionError(f"block {k} of {blocks} has {len(part)} bytes")
        parts.append(part)
        at += packed
    return b"".join(parts), at


class Array:
    def __init__(self, tag, data):
        self.components = int(tag.get("NumberOfComponents", "1"))
        raw, self.end = inflate(data, int(tag.get("offset")))
        if tag.get("type") == "String":
            words = raw.split(b"\0")
            if words.pop() != b"":
                raise AssertionError("the last string does not end with a zero")
            self.values = [word.decode() for word in words]
        else:
            code = TYPES[tag.get("type")]
            self.values = list(struct.unpack(f"<{len(raw) // struct.calcsize(code)}{code}", raw))
        count = len(self.values) // self.components
        if tag.get("NumberOfTuples", str(count)) != str(count):
            raise AssertionError(f"{tag.attrib}: {count} tuples")

    def rows(self):
        return [tuple(self.values[k:k + self.components]) for k in range(0, len(self.values), self.components)]


class Grid:
    """The arrays of a file: `points`, `cells` (lists of point numbers), `types`, and dictionaries by name."""

    def __init__(self, path):
        content = pathlib.Path(path).read_bytes()
        head, data = re.fullmatch(rb"(.*?<AppendedData encoding=\"raw\">\n)_(.*)\n</AppendedData>\n</VTKFile>\n", content,
                                  re.DOTALL).groups()
        root = ElementTree.fromstring(head + b"</AppendedData></VTKFile>")
        expected = {"type": "UnstructuredGrid", "version": "1.0", "byte_order": "LittleEndian", "header_type": "UInt64",
                    "compressor": "vtkZLibDataCompressor"}
        if root.attrib != expected:
            raise AssertionError(root.attrib)
        piece = root.find("UnstructuredGrid/Piece")
        ends = [0]

        def section(tag):
            arrays = {}
            for child in tag:
                if child.get("Name") in arrays or int(child.get("offset")) != ends[-1]:
                    raise AssertionError(f"{child.attrib} is there twice, or not where the one before it ends")
                arrays[child.get("Name")] = Array(child, data)
                ends.append(arrays[child.get("Name")].end)
            return arrays

        self.field_data = section(root.find("UnstructuredGrid/FieldData"))
        self.point_data, self.cell_data = section(piece.find("PointData")), section(piece.find("CellData"))
        self.active = (piece.find("PointData").get("Scalars"), piece.find("PointData").get("Vectors"))
        self.points = section(piece.find("Points"))["Points"].rows()
        cells = section(piece.find("Cells"))
        if ends[-1] != len(data):
            raise AssertionError("there are bytes behind the last array")
        offsets = [0] + cells["offsets"].values
        self.cells = [cells["connectivity"].values[a:b] for a, b in zip(offsets, offsets[1:])]
        self.types = cells["types"].values
        counts = (len(self.points), len(self.cells))
        if counts != (int(piece.get("NumberOfPoints")), int(piece.get("NumberOfCells"))) or len(self.types) != counts[1]:
            raise AssertionError("the counts of points and cells do not fit")
        for arrays, count in ((self.point_data, counts[0]), (self.cell_data, counts[1])):
            for name, array in arrays.items():
                if len(array.rows()) != count or not all(math.isfinite(value) for value in array.values):
                    raise AssertionError(f"{name}: not a finite number for each point or cell")


def document_order(p):
    """The exponents of a document's net: corners, edges, inside by descending i, then j."""
    corners = [(p, 0, 0), (0, p, 0), (0, 0, p)]
    net = list(corners)
    for a, b in ((0, 1), (1, 2), (2, 0)):
        for k in range(1, p):
            net.append(tuple((corners[a][x] * (p - k) + corners[b][x] * k) // p for x in range(3)))
    return net + [(i, j, p - i - j) for i in range(p - 2, 0, -1) for j in range(p - 1 - i, 0, -1)]


def vtk_order(p):
    """The exponents of VTK's points: corners, edges, and inside the same again for a degree less by three."""
    if p <= 0:
        return [(0, 0, 0)] if p == 0 else []
    boundary = [e for e in document_order(p) if 0 in e]
    return boundary + [tuple(x + 1 for x in e) for e in vtk_order(p - 3)]


class Document:
    """A mesh document with what a test asks of it."""

    def __init__(self, path):
        self.mesh = json.loads(pathlib.Path(path).read_text(encoding="utf-8"))
        self.degree = self.mesh["degree"]
        size = (self.degree + 1) * (self.degree + 2) // 2
        triangles = self.mesh["triangles"]
        self.nets = [triangles[k:k + size] for k in range(0, len(triangles), size)]
        flat = self.mesh["points"]
        self.points = list(zip(flat[::2], flat[1::2]))
        self.size = max(max(column) - min(column) for column in zip(*self.points))
        self.fields = {field["name"]: field for field in self.mesh.get("fields", [])}
        self.places = {}

    def row(self, field, point, face):
        field = self.fields[field]
        width, at = field.get("components", 1), point
        if field.get("by_face"):
            if field["name"] not in self.places:
                pairs = zip(field["places"][::2], field["places"][1::2])
                self.places[field["name"]] = {pair: k for k, pair in enumerate(pairs)}
            at = self.places[field["name"]][point, face]
        return field["values"][at * width:(at + 1) * width]

    def net_rows(self, triangle, field=None):
        """The control values of an element by exponents, positions if no field is named."""
        face = self.mesh["triangle_faces"][triangle]
        return {e: self.points[p] if field is None else self.row(field, p, face)
                for e, p in zip(document_order(self.degree), self.nets[triangle])}

    def save(self, path):
        pathlib.Path(path).write_text(json.dumps(self.mesh), encoding="utf-8")

    def add_field(self, name, function, components=1, by_face=False):
        """A field with the control values function(x, y, face)."""
        if by_face:
            places = sorted({(p, f) for net, f in zip(self.nets, self.mesh["triangle_faces"]) for p in net})
        else:
            places = [(p, 0) for p in range(len(self.points))]
        values = [v for p, f in places for v in function(*self.points[p], f)]
        field = {"name": name, "components": components, "by_face": by_face, "values": values}
        if by_face:
            field["places"] = [k for place in places for k in place]
        self.mesh.setdefault("fields", []).append(field)
        self.fields[name] = field


@functools.lru_cache(maxsize=None)
def weights(p, node, parts):
    """The basis of a document's net at barycentric coordinates node / parts, rounded once."""
    return [float(Fraction(math.factorial(p) * math.prod(x ** k for x, k in zip(node, e)),
                           math.prod(math.factorial(k) for k in e) * parts ** p)) for e in document_order(p)]


def evaluate(p, net, node, parts):
    """The value of a Bézier form, a dictionary from exponents to rows, at barycentric coordinates node / parts."""
    return [math.fsum(map(operator.mul, weights(p, node, parts), column)) for column in zip(*net.values())]
