#!/usr/bin/env python3
"""Meshes that Gmsh wrote, read by import-msh and qualityreport: nodes, areas, kinds of files, the known bad case."""
import json
import os
import pathlib
import subprocess
import sys
import unittest
from collections import defaultdict

import msh2

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "support"))
from scratch import InScratch  # noqa: E402

SOURCE = pathlib.Path(os.environ.get("SOURCE", pathlib.Path(__file__).resolve().parent.parent.parent))
GMSH = os.environ.get("GMSH", "gmsh")

GEOMETRIES = {
    "square": """
        Point(1) = {0, 0, 0}; Point(2) = {2, 0, 0}; Point(3) = {2, 1, 0}; Point(4) = {0, 1, 0};
        Line(1) = {1, 2}; Line(2) = {2, 3}; Line(3) = {3, 4}; Line(4) = {4, 1};
        Curve Loop(1) = {1, 2, 3, 4}; Plane Surface(1) = {1};
        Physical Surface("square", 3) = {1}; Physical Curve("wall", 4) = {1, 2, 3, 4};
        Mesh.MeshSizeMax = 0.35;""",
    "disk": """
        Point(1) = {0, 0, 0}; Point(2) = {1, 0, 0}; Point(3) = {0, 1, 0}; Point(4) = {-1, 0, 0}; Point(5) = {0, -1, 0};
        Circle(1) = {2, 1, 3}; Circle(2) = {3, 1, 4}; Circle(3) = {4, 1, 5}; Circle(4) = {5, 1, 2};
        Curve Loop(1) = {1, 2, 3, 4}; Plane Surface(1) = {1};
        Physical Surface("disk", 1) = {1}; Physical Curve("rim", 2) = {1, 2, 3, 4};
        Mesh.MeshSizeMax = 0.4;""",
    "holes": """
        SetFactory("OpenCASCADE");
        Disk(1) = {0, 0, 0, 2}; Disk(2) = {0.7, 0.1, 0, 0.5}; Disk(3) = {-0.8, 0, 0, 0.4, 0.3}; Disk(4) = {0, -1.2, 0, 0.25};
        BooleanFragments{ Surface{1}; Delete; }{ Surface{2:4}; Delete; }
        Recursive Delete { Surface{4}; }
        Physical Surface("ring", 1) = {5}; Physical Surface("left", 2) = {3}; Physical Surface("right", 3) = {2};
        Mesh.MeshSizeMax = 0.5;""",
    "splines": """
        Point(1) = {0, 0, 0}; Point(2) = {1, -0.3, 0}; Point(3) = {2, 0, 0}; Point(4) = {2.2, 1, 0}; Point(5) = {1, 1.3, 0};
        Point(6) = {0, 1, 0}; Point(11) = {0.6, 0.3, 0}; Point(12) = {1.2, 0.3, 0}; Point(13) = {1.3, 0.7, 0};
        Point(14) = {0.9, 0.9, 0}; Point(15) = {0.5, 0.7, 0};
        Spline(1) = {1, 2, 3}; Spline(2) = {3, 4, 5, 6, 1}; BSpline(3) = {11, 12, 13, 14, 15, 11};
        Curve Loop(1) = {1, 2}; Curve Loop(2) = {3};
        Plane Surface(1) = {1, 2}; Plane Surface(2) = {2};
        Physical Surface("outer", 1) = {1}; Physical Surface("inner", 2) = {2};
        Physical Curve("below", 5) = {1}; Physical Curve("above", 6) = {2}; Physical Curve("cell", 7) = {3};
        Mesh.MeshSizeMax = 0.25;""",
}


def run(*words, status=0):
    done = subprocess.run(words, capture_output=True, text=True, timeout=500)
    if done.returncode != status:
        raise AssertionError(f"{words}: status {done.returncode}: {done.stderr[:2000]} {done.stdout[-500:]}")
    return done


class Meshes(InScratch):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        for name, text in GEOMETRIES.items():
            pathlib.Path(name + ".geo").write_text(text + "\n")

    def gmsh(self, geometry, order, form="msh22", binary=False, numbers=()):
        """The file that Gmsh makes, once each."""
        out = f"{pathlib.Path(geometry).stem}-{order}-{form}{'-bin' if binary else ''}.msh"
        if not os.path.exists(out):
            geo = geometry if str(geometry).endswith(".geo") else geometry + ".geo"
            run(GMSH, "-2", "-nt", "1", "-order", str(order), "-format", form, *(["-bin"] if binary else []), *numbers,
                str(geo), "-o", out)
        return out

    def document(self, file):
        return json.loads(run("import-msh", "-q", file).stdout)

    def report(self, file):
        return json.loads(run("qualityreport", "-q", "--format", "json", "--bins", "0", "--worst", "100", file).stdout)

    def test_nodes_of_straight_triangles_lie_where_their_order_says(self):
        """Gmsh's own output fixes the order of the nodes, for each order of elements."""
        for order in range(1, 11):
            nodes, triangles = msh2.read(self.gmsh("square", order))
            self.assertEqual({order}, {t[2] for t in triangles})
            for _, _, _, own in triangles:
                a, b, c = (nodes[n] for n in own[:3])
                for n, (i, j, k) in zip(own, msh2.lattice(order)):
                    for x in (0, 1):
                        self.assertAlmostEqual((i * a[x] + j * b[x] + k * c[x]) / order, nodes[n][x], delta=1e-9)

    def test_control_points_are_what_rationals_give(self):
        for order in range(1, 6):
            matrix = msh2.bezier_from_lagrange(order)
            size = len(matrix)
            file = self.gmsh("disk", order)
            nodes, triangles = msh2.read(file)
            mesh = self.document(file)
            self.assertEqual(order, mesh["degree"])
            self.assertEqual(len(triangles), len(mesh["triangle_faces"]))
            for t, (_, _, _, own) in enumerate(triangles):
                for k, row in enumerate(matrix):
                    point = mesh["triangles"][size * t + k]
                    norm = float(sum(abs(m) for m in row))
                    for x in (0, 1):
                        exact = sum(m * msh2.Fraction(nodes[n][x]) for m, n in zip(row, own) if m)
                        self.assertLessEqual(abs(mesh["points"][2 * point + x] - exact), 3e-16 * norm, (order, t, k))

    def test_every_order_of_every_geometry_is_sound_and_has_the_exact_area(self):
        for name in GEOMETRIES:
            for order in range(1, 6):
                with self.subTest(name=name, order=order):
                    file = self.gmsh(name, order)
                    report = self.report(file)
                    self.assertEqual([], report["faults"])
                    nodes, triangles = msh2.read(file)
                    matrix = msh2.bezier_from_lagrange(order)
                    exact = defaultdict(msh2.Fraction)
                    for _, physical, _, own in triangles:
                        exact[physical] += msh2.signed_area([nodes[n] for n in own], order, matrix)
                    areas = sorted(face["area"] for face in report["faces"])
                    self.assertEqual(len(exact), len(areas))
                    for area, wanted in zip(areas, sorted(exact.values())):
                        self.assertLess(abs(area / float(wanted) - 1), 1e-12)
                    self.assertLess(abs(report["area"] / float(sum(exact.values())) - 1), 1e-12)
                    if report["invalid"] == 0:  # Gmsh adds up |det J|
                        self.assertLess(abs(report["area"] / self.area_by_gmsh(file) - 1), 1e-12)
                    self.assertEqual(report, self.report_of_import(file))

    def area_by_gmsh(self, file):
        script = pathlib.Path("area.geo")
        script.write_text(f'Merge "{file}";\nPlugin(MeshVolume).Dimension = 2;\nPlugin(MeshVolume).Run;\n'
                          'Save View[0] "area.pos";\n')  # what stands on a last line without end is not run
        run(GMSH, "-nt", "1", str(script), "-")
        return float(pathlib.Path("area.pos").read_text().split("{")[2].split("}")[0])

    def report_of_import(self, file):
        run("import-msh", "-q", "-o", "imported.json", file)
        return self.report("imported.json")

    def test_all_kinds_of_files_give_the_same_mesh(self):
        for name, order in (("square", 1), ("holes", 2), ("splines", 3), ("disk", 5)):
            with self.subTest(name=name):
                meshes = {(form, binary): self.document(self.gmsh(name, order, form, binary))
                          for form in ("msh22", "msh41") for binary in (False, True)}
                exact = meshes["msh41", True]
                for kind, mesh in meshes.items():
                    self.assertEqual(exact["triangles"], mesh["triangles"], kind)
                    self.assertEqual(exact["triangle_faces"], mesh["triangle_faces"], kind)
                    self.assertEqual(exact["boundary"]["faces"], mesh["boundary"]["faces"], kind)
                    self.assertEqual(exact["constrained_edges"], mesh["constrained_edges"], kind)
                    self.assertEqual([c["name"] for c in exact["boundary"]["curves"]],
                                     [c["name"] for c in mesh["boundary"]["curves"]], kind)
                    worst = max(abs(a - b) for a, b in zip(exact["points"], mesh["points"]))
                    # Text has 16 digits.
                    self.assertLessEqual(worst, 0 if kind[1] else 3e-15 * 2 ** order, kind)

    def test_names_and_curves_are_those_of_the_geometry(self):
        mesh = self.document(self.gmsh("splines", 2))
        faces = [face["name"] for face in mesh["boundary"]["faces"]]
        self.assertEqual({"outer", "inner"}, set(faces))
        curves = {curve["name"]: curve for curve in mesh["boundary"]["curves"]}
        self.assertEqual({"below", "above", "cell"}, set(curves))
        self.assertTrue(curves["cell"]["closed"])
        self.assertEqual({faces.index("outer"), faces.index("inner")}, {curves["cell"]["left"], curves["cell"]["right"]})
        self.assertEqual(sorted([0, 0, 2, 0]), sorted(mesh["boundary"]["vertices"]))
        square = self.document(self.gmsh("square", 2))
        self.assertEqual(["wall"] * 4, [curve["name"] for curve in square["boundary"]["curves"]])
        self.assertEqual(4, len(square["boundary"]["vertices"]) // 2)
        ring = self.document(self.gmsh("holes", 2))
        self.assertEqual(4, sum(curve["closed"] for curve in ring["boundary"]["curves"]))

    def test_a_surface_whose_loop_runs_clockwise_is_turned_on_request(self):
        geo = pathlib.Path("clockwise.geo")
        geo.write_text(GEOMETRIES["square"].replace("Curve Loop(1) = {1, 2, 3, 4}", "Curve Loop(1) = {-4, -3, -2, -1}") + "\n")
        file = self.gmsh("clockwise", 3)
        report = self.report(file)
        self.assertEqual(report["triangles"], report["invalid"])
        self.assertIn("clockwise", run("import-msh", file).stderr)
        run("import-msh", "-q", "--orient", "-o", "turned.json", file)
        turned = self.report("turned.json")
        self.assertEqual((0, []), (turned["invalid"], turned["faults"]))
        self.assertAlmostEqual(2, turned["area"], delta=1e-13)

    def test_partitions_quadrangles_and_what_else_is_in_a_file(self):
        pathlib.Path("quads.geo").write_text(GEOMETRIES["square"] + "Transfinite Surface{1}; Recombine Surface{1};\n")
        self.assertIn("quadrangle", run("import-msh", self.gmsh("quads", 2), status=3).stderr)
        run(GMSH, "-2", "-order", "2", "-part", "3", "-format", "msh41", "holes.geo", "-o", "parts.msh")
        parts, whole = self.report("parts.msh"), self.report(self.gmsh("holes", 2, "msh41"))
        self.assertEqual([], parts["faults"])
        self.assertEqual(sorted(face["name"] for face in whole["faces"]), sorted(face["name"] for face in parts["faces"]))
        self.assertAlmostEqual(whole["area"], parts["area"], delta=1e-12)
        pathlib.Path("cube.geo").write_text('SetFactory("OpenCASCADE"); Box(1) = {0, 0, 0, 1, 1, 1};\n')
        self.assertIn("has z = ", run("import-msh", self.gmsh("cube", 2), status=3).stderr)
        newer = self.report(self.gmsh("square", 1, "msh41"))
        for kind in ("msh40", "msh1"):
            older = self.report(self.gmsh("square", 1, kind))
            self.assertEqual([], older["faults"])
            self.assertEqual(newer["triangles"], older["triangles"])
            self.assertAlmostEqual(newer["area"], older["area"], delta=1e-12)

    def test_the_twelve_invalid_elements_at_the_seams_of_closed_splines(self):
        """Gmsh writes them without a word; sampling finds the same ones, and they lie at the seams."""
        file = self.gmsh(SOURCE / "tests" / "peers" / "rbc_channel.geo", 2, numbers=("-setnumber", "h", "0.0303"))
        report = self.report(file)
        self.assertEqual((12, 0, []), (report["invalid"], report["degenerate"], report["faults"]))
        nodes, triangles = msh2.read(file)
        steps = 40
        places = [(i / steps, j / steps) for i in range(steps + 1) for j in range(steps + 1 - i)]
        bad = set()
        for t, (_, _, _, own) in enumerate(triangles):
            points = [nodes[n] for n in own]
            if all(abs(points[3 + e][x] - (points[e][x] + points[(e + 1) % 3][x]) / 2) < 1e-12
                   for e in range(3) for x in (0, 1)):
                self.assertGreater(msh2.det_j_of_quadratic(points, 0.25, 0.25), 0)
            elif min(msh2.det_j_of_quadratic(points, *place) for place in places) < 0:
                bad.add(t)
        self.assertEqual(set(report["invalid_elements"]), bad)

    def test_what_export_msh_writes_is_what_gmsh_reads(self):
        """Through Gmsh and back: shapes, faces and curves by name, lines on the boundary, nodes where they belong."""
        for order in (1, 2, 3, 5, 10):
            document = f"splines-{order}.json"
            pathlib.Path(document).write_text(run("import-msh", "-q", self.gmsh("splines", order)).stdout)
            before, curves = self.report(document), self.names(json.loads(pathlib.Path(document).read_text()))
            for form, binary in (("msh41", ()), ("msh41", ("--binary",)), ("msh22", ()), ("msh22", ("--binary",))):
                run("export-msh", "--format", form, *binary, document, "-o", "to.msh")
                words = run(GMSH, "-0", "to.msh", "-format", "msh41", "-o", "from.msh")
                self.assertNotRegex(words.stdout + words.stderr, "Warning|Error")
                self.assertEqual("", run("import-msh", "-o", "from.json", "from.msh").stderr)
                after = self.report("from.json")
                self.assertEqual([], after["faults"])
                self.assertEqual(before["triangles"], after["triangles"])
                areas = [{face["name"]: face["area"] for face in report["faces"]} for report in (before, after)]
                self.assertEqual({"outer", "inner"}, set(areas[0]))
                for name, area in areas[0].items():
                    self.assertAlmostEqual(area, areas[1][name], delta=1e-12)
                self.assertEqual(curves, self.names(json.loads(pathlib.Path("from.json").read_text())))
        # Nodes are known to lie on the boundary: an optimisation of Gmsh's own leaves it where it is.
        run("export-msh", "splines-3.json", "-o", "to.msh")
        run(GMSH, "-0", "to.msh", "-optimize_ho", "-format", "msh22", "-o", "from.msh")
        after = self.report("from.msh")
        self.assertAlmostEqual(self.report("splines-3.json")["area"], after["area"], delta=1e-12)

    def names(self, document):
        """How many edges the curves of each name have."""
        count = defaultdict(int)
        for edge in document["constrained_edges"]:
            count[document["boundary"]["curves"][edge["curve"]]["name"]] += 1
        return dict(count)


if __name__ == "__main__":
    unittest.main(verbosity=1)
