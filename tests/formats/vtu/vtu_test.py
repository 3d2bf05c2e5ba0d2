#!/usr/bin/env python3
"""What export-vtu writes, read with Python's own XML and zlib, against the document that it was made from."""
import csv
import io
import json
import math
import os
import pathlib
import sys
import unittest
import xml.etree.ElementTree as ElementTree

from vtu_files import BEZIER, LAGRANGE, Document, Grid, evaluate, make_mesh, run, vtk_order

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent.parent / "support"))
from scratch import InScratch  # noqa: E402

EMPTY = {"format": "pliant-mesh", "version": 1, "degree": 2, "points": [], "triangles": [], "triangle_faces": [],
         "constrained_edges": [], "boundary": {"vertices": [], "faces": [], "curves": []}}


def heat(x, y, face):
    return [math.sin(3 * x) + y + 10 * face]


def row(*values):
    return lambda x, y, face: [value * (1 + x) + y for value in values]


class Vtu(InScratch):
    def document(self, kind, degree, *fields, time="0"):
        """A small mesh with the field u and these: a kind of sample_mesh (degree 1 to 7), or that of a boundary."""
        document = make_mesh(kind, degree, time)
        for field in fields:
            document.add_field(*field)
        document.save("mesh.json")
        return Document("mesh.json")

    def grid(self, *options, name="mesh.json", out="out.vtu"):
        done = run("export-vtu", *options, name, "-o", out)
        self.assertEqual(b"", done.stderr)
        return Grid(out)

    def check_triangles(self, document, grid, lagrange, by_face, fields):
        """Each cell has the element's control values, or its values at the nodes, in VTK's order."""
        p, order = document.degree, vtk_order(document.degree)
        count = len(document.nets)
        self.assertEqual([(LAGRANGE if lagrange else BEZIER)["triangle"]] * count, grid.types[:count])
        self.assertEqual(document.mesh["triangle_faces"], grid.cell_data["face"].values[:count])
        numbers = {}
        for t, net in enumerate(document.nets):
            face = document.mesh["triangle_faces"][t]
            by_exponents = dict(zip(document.net_rows(t), net))
            for number, e in zip(grid.cells[t], order):
                # One number for a point, or for a point and a face: neighbours are joined there.
                self.assertEqual(number, numbers.setdefault((by_exponents[e], face if by_face else 0), number))
            for name in (None, *fields):
                rows = grid.points if name is None else grid.point_data[name].rows()
                control = document.net_rows(t, name)
                for number, e in zip(grid.cells[t], order):
                    found = rows[number]
                    wanted = control[e] if not lagrange else evaluate(p, control, e, p)
                    if len(wanted) == 2:
                        self.assertEqual((3, 0.0), (len(found), found[2]))
                    largest = max(abs(v) for values in control.values() for v in values)
                    for a, b in zip(found, wanted):
                        self.assertLessEqual(abs(a - b), 4e-15 * largest if lagrange else 0)
        self.assertEqual(len(set(numbers.values())), len(numbers))
        self.assertEqual(sorted(numbers.values()), list(range(len(grid.points))))

    def test_every_degree_as_bezier_and_as_lagrange_triangles(self):
        for degree in range(1, 11):
            kind = "three" if degree < 8 else "cells.json" if degree == 8 else "disk.json"
            document = self.document(kind, degree, ("v", row(1, -2), 2), ("jump", heat, 1, True))
            for options in ((), ("--lagrange",)):
                with self.subTest(degree=degree, options=options):
                    grid = self.grid("--metric", "none", *options)
                    self.check_triangles(document, grid, bool(options), True, ("u", "v", "jump"))
                    self.assertEqual(["face"], list(grid.cell_data))

    def test_points_are_those_of_the_document_where_no_field_is_by_face(self):
        document = self.document("three", 3, ("v", row(1, -2), 2))
        grid = self.grid()
        self.check_triangles(document, grid, False, False, ("u", "v"))
        self.assertEqual([(*point, 0.0) for point in document.points], grid.points)
        nodes = self.grid("--lagrange")
        self.check_triangles(document, nodes, True, False, ("u", "v"))
        self.assertEqual(grid.cells, nodes.cells)

    def test_vectors_of_two_components_get_a_third_and_other_counts_stay(self):
        fields = [(f"f{n}", row(*range(1, n + 1)), n) for n in range(1, 7)]
        self.document("disk", 2, *fields)
        grid = self.grid()
        self.assertEqual([1, 3, 3, 4, 5, 6], [grid.point_data[f"f{n}"].components for n in range(1, 7)])
        self.assertEqual(("u", "f2"), grid.active)

    def test_curves_are_cells_of_the_face_on_their_left(self):
        for degree in (1, 2, 3, 7):
            document = self.document("three", degree, ("jump", heat, 1, True))
            mesh = document.mesh
            for lagrange in (False, True):
                grid = self.grid("--curves", "--metric", "shape", *(["--lagrange"] if lagrange else []))
                first = len(document.nets)
                self.check_triangles(document, grid, lagrange, True, ("jump",))
                self.assertEqual([(LAGRANGE if lagrange else BEZIER)["curve"]] * len(mesh["constrained_edges"]),
                                 grid.types[first:])
                self.assertEqual([-1] * first + [edge["curve"] for edge in mesh["constrained_edges"]],
                                 grid.cell_data["curve"].values)
                for cell, edge, face in zip(grid.cells[first:], mesh["constrained_edges"],
                                            grid.cell_data["face"].values[first:]):
                    curve = mesh["boundary"]["curves"][edge["curve"]]
                    self.assertEqual(curve["right"] if curve["left"] is None else curve["left"], face)
                    ends = edge["points"]
                    points = [ends[0], ends[-1], *ends[1:-1]]
                    for k, (number, point) in enumerate(zip(cell, points)):
                        if not lagrange or k < 2:
                            self.assertEqual((*document.points[point], 0.0), grid.points[number])
                            self.assertEqual(document.row("jump", point, face), [grid.point_data["jump"].values[number]])
                    # The cell beside it has the same points, and the same metric.
                    beside = next(t for t in range(first) if set(cell) <= set(grid.cells[t]))
                    at = grid.cells.index(cell)
                    self.assertEqual(grid.cell_data["shape"].values[beside], grid.cell_data["shape"].values[at])
                self.assertEqual([c["name"] for c in mesh["boundary"]["curves"]], grid.field_data["curve_names"].values)

    def test_metrics_are_those_of_qualityreport(self):
        self.document("tangled", 3)
        table = list(csv.DictReader(io.StringIO(run("qualityreport", "--format", "csv", "mesh.json").stdout.decode())))
        grid = self.grid("--metric", "all")
        names = [name for name in grid.cell_data if name not in ("face", "validity")]
        self.assertEqual(12, len(names))
        self.assertTrue(any(value == 2 for value in grid.cell_data["validity"].values))
        for name in names:
            values = [float(line[name]) if line[name] else 0.0 for line in table]
            self.assertEqual(values, grid.cell_data[name].values, name)
        self.assertEqual([line["validity"] for line in table],
                         [("valid", "degenerate", "invalid")[k] for k in grid.cell_data["validity"].values])
        self.assertIn(0.0, grid.cell_data["distortion"].values)  # elements without a positive area have none
        some = self.grid("--metric", "distortion", "--metric", "shape", "--metric", "shape")
        self.assertEqual(["face", "validity", "distortion", "shape"], list(some.cell_data))

    def test_names_with_any_characters_come_back(self):
        names = ['<p & "q">', "Größe 速度", "tab\tand\nline", " spaces  inside ", "']]>", "a" * 300]
        document = self.document("disk", 1, *[(name, heat) for name in names])
        document.mesh["boundary"]["faces"][0]["name"] = '<"face" & ü'
        document.save("mesh.json")
        grid = self.grid()
        self.assertEqual(["u", *names], list(grid.point_data))
        self.assertEqual(['<"face" & ü'], grid.field_data["face_names"].values)
        # What XML cannot hold is replaced, and names stay distinct.
        document = self.document("disk", 1, *[(name, heat) for name in ("a\1", "a\2", "", "field", "a\uffff", "\0")])
        document.mesh["boundary"]["faces"][0]["name"] = "a\0b"
        document.save("mesh.json")
        grid = self.grid()
        self.assertEqual(["u", "a\ufffd", "a\ufffd (2)", "field", "field (2)", "a\ufffd (3)", "\ufffd"], list(grid.point_data))
        self.assertEqual(["a b"], grid.field_data["face_names"].values)

    def test_sizes_near_the_limits_of_doubles(self):
        document = self.document("three", 2)
        small = self.grid("--metric", "all", "--curves")
        for power in (505, -505):
            factor = 2.0 ** power
            for part in (document.mesh, document.mesh["boundary"], *document.mesh["boundary"]["curves"]):
                for key in ("points", "vertices"):
                    if key in part:
                        part[key] = [value * factor for value in part[key]]
            document.save("scaled.json")
            for options in ((), ("--lagrange",)):
                grid = self.grid("--metric", "all", "--curves", *options, name="scaled.json")
                for name, array in small.cell_data.items():
                    unit = {"jacobian": factor ** 2, "jacobian_max": factor ** 2, "element_area": factor ** 2,
                            "edge_length": factor, "edge_length_max": factor}.get(name, 1)
                    self.assertEqual([value * unit for value in array.values], grid.cell_data[name].values)
                plain = small if not options else self.grid("--lagrange", "--curves")
                self.assertEqual([tuple(x * factor for x in point) for point in plain.points], grid.points)
            document = self.document("three", 2)
        # Values that are the greatest doubles stay finite at the nodes.
        self.document("disk", 5, ("great", lambda x, y, face: [1.7976931348623157e308]))
        for options in ((), ("--lagrange",)):
            values = self.grid(*options).point_data["great"].values
            self.assertTrue(all(1.79e308 < value < math.inf for value in values))

    def test_arrays_of_several_blocks(self):
        pathlib.Path("square.json").write_text(json.dumps({
            "format": "pliant-boundary", "version": 1, "vertices": [0, 0, 1, 0, 1, 1, 0, 1], "faces": [{"name": "all"}],
            "curves": [{"name": "side", "degree": 1, "closed": False, "knots": [0, 0, 1, 1], "points": points,
                        "start": k, "end": (k + 1) % 4, "left": 0, "right": None}
                       for k, points in enumerate(([0, 0, 1, 0], [1, 0, 1, 1], [1, 1, 0, 1], [0, 1, 0, 0]))]}))
        run("bspline2mesh", "-q", "--degree", "2", "--max-area", "5e-5", "square.json", "-o", "mesh.json")
        document, grid = Document("mesh.json"), self.grid("--curves")
        self.assertGreater(24 * len(grid.points), 3 * 2 ** 18)
        self.assertEqual([(*point, 0.0) for point in document.points], grid.points)
        order = [document.nets[7].index(p) for p in grid.cells[7]]
        self.assertEqual([[net[k] for k in order] for net in document.nets], grid.cells[:len(document.nets)])

    def test_a_mesh_without_elements(self):
        pathlib.Path("mesh.json").write_text(json.dumps(EMPTY))
        for options in ((), ("--lagrange", "--curves")):
            grid = self.grid(*options)
            self.assertEqual(([], [], []), (grid.points, grid.cells, grid.field_data["face_names"].values))

    def test_a_series_is_a_list_of_files(self):
        text = b"".join(run("sample_mesh", "disk", str(p), str(time)).stdout
                        for p, time in ((1, 0), (2, 0.1), (3, 0.30000000000000004)))
        pathlib.Path("series.jsonl").write_bytes(text)
        done = run("export-vtu", "-v", "series.jsonl", "-o", "film & co.pvd")
        written = sorted(str(path) for path in pathlib.Path(".").glob("film*"))
        self.assertEqual(["film & co.pvd", *(f"film & co_000{k}.vtu" for k in range(3))], written)
        self.assertIn(f" {sum(os.path.getsize(name) for name in written)} bytes", done.stderr.decode())
        root = ElementTree.parse("film & co.pvd").getroot()
        self.assertEqual("Collection", root.get("type"))
        entries = [(entry.get("timestep"), entry.get("file")) for entry in root.iter("DataSet")]
        self.assertEqual(list(zip(("0", "0.1", "0.30000000000000004"), written[1:])), entries)
        for k, (time, name) in enumerate(entries):
            grid = Grid(name)
            self.assertEqual([float(time)], grid.field_data["TimeValue"].values)
            run("export-vtu", "--frame", str(k), "series.jsonl", "-o", "one.vtu")
            self.assertEqual(pathlib.Path(name).read_bytes(), pathlib.Path("one.vtu").read_bytes())
        self.assertEqual(pathlib.Path("one.vtu").read_bytes(), run("export-vtu", "--frame=-1", "series.jsonl").stdout)
        # Frames of one time would be shown together.
        pathlib.Path("still.jsonl").write_bytes(run("sample_mesh", "disk", "1", "4").stdout * 2)
        self.assertIn(b"do not ascend", run("export-vtu", "still.jsonl", "-o", "still.pvd").stderr)
        self.assertEqual(["0", "1"], [entry.get("timestep") for entry in ElementTree.parse("still.pvd").iter("DataSet")])
        self.assertEqual([4.0], Grid("still_0001.vtu").field_data["TimeValue"].values)

    def test_endings_may_be_in_capitals(self):
        text = b"".join(run("sample_mesh", "disk", "2", time).stdout for time in "01")
        pathlib.Path("series.jsonl").write_bytes(text)
        for ending in ("pvd", "PVD", "Pvd"):
            os.mkdir(ending)
            run("export-vtu", "series.jsonl", "-o", f"{ending}/film.{ending}")
            self.assertEqual([f"film.{ending}", "film_0000.vtu", "film_0001.vtu"], sorted(os.listdir(ending)))
            for name, same in ((f"film.{ending}", "film.pvd"), ("film_0001.vtu", "film_0001.vtu")):
                self.assertEqual(pathlib.Path("pvd", same).read_bytes(), pathlib.Path(ending, name).read_bytes())
            done = run("export-vtu", "--frame", "0", "-o", f"x.{ending}", "series.jsonl", status=2)
            self.assertIn(b"is for a series", done.stderr)
        run("export-vtu", "series.jsonl", "-o", "first.VTU")
        self.assertEqual(pathlib.Path("pvd/film_0000.vtu").read_bytes(), pathlib.Path("first.VTU").read_bytes())

    def test_a_series_with_a_bad_mesh_has_no_list(self):
        os.mkdir("bad")
        good = run("sample_mesh", "disk", "2").stdout
        pathlib.Path("bad.jsonl").write_bytes(good + good.replace(b'"degree":2', b'"degree":3', 1))
        done = run("export-vtu", "bad.jsonl", "-o", "bad/film.pvd", status=3)
        self.assertIn(b"bad.jsonl:2: frame 1: ", done.stderr)
        self.assertEqual(["bad/film_0000.vtu"], [str(path) for path in pathlib.Path("bad").iterdir()])
        Grid("bad/film_0000.vtu")

    def test_wrong_usage(self):
        self.document("disk", 2)
        for options, words in ((("--metric", "beauty"), b"jacobian"), (("--metric", "all", "--metric", "shape"), b"alone"),
                               (("--frame", "1"), b"has 1 mesh"), (("--frame", "0", "-o", "a.pvd"), b"series"),
                               (("-o", "a\1.pvd"), b"UTF-8"), (("-o", b"\xff.pvd"), b"UTF-8")):
            done = run("export-vtu", *options, "mesh.json", status=2)
            self.assertIn(words, done.stderr)
            self.assertEqual(b"", done.stdout)
        self.assertEqual([], list(pathlib.Path(".").glob("a*.pvd*")))


if __name__ == "__main__":
    unittest.main()
