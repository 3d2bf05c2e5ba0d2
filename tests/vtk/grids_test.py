#!/usr/bin/python3
"""What VTK makes of the files of export-vtu: points and values on each element, names, times, series."""
import math
import pathlib
import sys
import unittest
import xml.etree.ElementTree as ElementTree

import vtk

for folder in ("formats/vtu", "support"):
    sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / folder))
from scratch import InScratch  # noqa: E402
from vtu_files import EXAMPLES, Document, evaluate, make_mesh, run  # noqa: E402

# Corners, points on edges, inner ones: barycentric coordinates in 60ths, which doubles cannot hold exactly.
NODES = [(60, 0, 0), (0, 60, 0), (0, 0, 60), (20, 40, 0), (0, 7, 53), (31, 0, 29), (20, 20, 20), (1, 58, 1), (13, 17, 30)]


def read(path):
    """The grid of a file. VTK's errors are events, which must not pass unseen."""
    errors = []
    reader = vtk.vtkXMLUnstructuredGridReader()
    reader.AddObserver("ErrorEvent", lambda *words: errors.append(words))
    reader.SetFileName(path)
    reader.Update()
    if errors or reader.GetErrorCode():
        raise AssertionError(f"VTK cannot read {path}")
    return reader.GetOutput()


def strings(grid, name):
    array = grid.GetFieldData().GetAbstractArray(name)
    return [array.GetValue(k) for k in range(array.GetNumberOfValues())]


class Grids(InScratch):
    def document(self, kind, degree):
        """A mesh with the fields u, v (two components) and jump (by face)."""
        document = make_mesh(kind, degree, "0.25")
        document.add_field("v", lambda x, y, face: [math.sin(x), x * y], 2)
        document.add_field("jump", lambda x, y, face: [math.cos(3 * y) + 7 * face], 1, True)
        document.save("mesh.json")
        return document

    def location(self, grid, cell, pcoords):
        """The place of a cell at parametric coordinates, and a function that interpolates point data there."""
        place, weights = [0.0] * 3, [0.0] * cell.GetNumberOfPoints()
        cell.EvaluateLocation(vtk.mutable(0), pcoords, place, weights)
        ids = [cell.GetPointId(k) for k in range(cell.GetNumberOfPoints())]

        def value(name):
            array = grid.GetPointData().GetArray(name)
            rows = [array.GetTuple(k) for k in ids]
            return [math.fsum(w * x for w, x in zip(weights, column)) for column in zip(*rows)]
        return place, value

    def close(self, wanted, found, scale):
        self.assertLessEqual(max(abs(a - b) for a, b in zip(wanted, found)), 1e-12 * scale)

    def check_triangles(self, document, grid, unit=1.0):
        names = list(document.fields)
        largest = {name: max(map(abs, document.fields[name]["values"])) for name in names}
        extent = max(abs(x) for point in document.points for x in point)
        for t in range(len(document.nets)):
            cell = grid.GetCell(t)
            nets = {name: document.net_rows(t, name) for name in (None, *names)}
            for node in NODES:
                place, value = self.location(grid, cell, (node[1] / 60, node[2] / 60, 0))
                wanted = evaluate(document.degree, nets[None], node, 60)
                self.close([unit * x for x in wanted] + [0], place, unit * extent)
                for name in names:
                    wanted = evaluate(document.degree, nets[name], node, 60)
                    self.close(wanted + [0] * (len(wanted) == 2), value(name), largest[name])
                    self.assertEqual(3 if len(wanted) == 2 else len(wanted), len(value(name)))

    def check_curves(self, document, grid):
        first, p = len(document.nets), document.degree
        for at, edge in enumerate(document.mesh["constrained_edges"]):
            cell = grid.GetCell(first + at)
            curve = document.mesh["boundary"]["curves"][edge["curve"]]
            face = curve["right"] if curve["left"] is None else curve["left"]
            self.assertEqual(edge["curve"], grid.GetCellData().GetArray("curve").GetValue(first + at))
            self.assertEqual(face, grid.GetCellData().GetArray("face").GetValue(first + at))
            for s in (0.0, 0.3, 0.5, 1.0):
                basis = [math.comb(p, k) * s ** k * (1 - s) ** (p - k) for k in range(p + 1)]
                place, value = self.location(grid, cell, (s, 0, 0))
                for found, rows in ((place, [document.points[q] for q in edge["points"]]),
                                    (value("jump"), [document.row("jump", q, face) for q in edge["points"]])):
                    self.close([sum(b * row[c] for b, row in zip(basis, rows)) for c in range(len(rows[0]))], found,
                               max(abs(x) for row in rows for x in row))

    def test_elements_of_every_degree_are_where_the_document_has_them(self):
        for degree in range(1, 11):
            kind = "three" if degree < 8 else "cells.json" if degree == 8 else "disk.json"
            document = self.document(kind, degree)
            for options in ((), ("--lagrange",)):
                with self.subTest(degree=degree, options=options):
                    run("export-vtu", "--curves", *options, "mesh.json", "-o", "out.vtu")
                    grid = read("out.vtu")
                    count = len(document.nets) + len(document.mesh["constrained_edges"])
                    self.assertEqual(count, grid.GetNumberOfCells())
                    basis = "Lagrange" if options else "Bezier"
                    self.assertEqual(f"vtk{basis}Triangle", grid.GetCell(0).GetClassName())
                    self.assertEqual(f"vtk{basis}Curve", grid.GetCell(count - 1).GetClassName())
                    self.check_triangles(document, grid)
                    self.check_curves(document, grid)

    def test_sizes_near_the_limits_of_doubles(self):
        document = self.document("three", 3)
        for unit in (2.0 ** 500, 2.0 ** -500):
            scaled = Document("mesh.json")
            for part in (scaled.mesh, scaled.mesh["boundary"], *scaled.mesh["boundary"]["curves"]):
                for key in ("points", "vertices"):
                    if key in part:
                        part[key] = [value * unit for value in part[key]]
            scaled.save("scaled.json")
            for options in ((), ("--lagrange",)):
                run("export-vtu", "--metric", "all", *options, "scaled.json", "-o", "out.vtu")
                self.check_triangles(document, read("out.vtu"), unit)

    def test_names_times_and_active_arrays(self):
        document = self.document("three", 2)
        names = [face["name"] for face in document.mesh["boundary"]["faces"]]
        document.mesh["boundary"]["faces"][0]["name"] = names[0] = "außen & <innen>"
        document.add_field('odd "&<name>', lambda x, y, face: [x])
        document.save("mesh.json")
        run("export-vtu", "--curves", "--metric", "all", "mesh.json", "-o", "out.vtu")
        grid = read("out.vtu")
        self.assertEqual(names, strings(grid, "face_names"))
        self.assertEqual([curve["name"] for curve in document.mesh["boundary"]["curves"]], strings(grid, "curve_names"))
        self.assertEqual(0.25, grid.GetFieldData().GetArray("TimeValue").GetValue(0))
        self.assertEqual(["u", "v", "jump", 'odd "&<name>'],
                         [grid.GetPointData().GetArrayName(k) for k in range(grid.GetPointData().GetNumberOfArrays())])
        self.assertEqual(("u", "v"), (grid.GetPointData().GetScalars().GetName(), grid.GetPointData().GetVectors().GetName()))
        cells = grid.GetCellData()
        self.assertEqual(["face", "curve", "validity"], [cells.GetArrayName(k) for k in range(3)])
        self.assertEqual(15, cells.GetNumberOfArrays())
        self.assertTrue(0 < cells.GetArray("shape").GetRange()[0] < cells.GetArray("shape").GetRange()[1] < 1)

    def test_the_surface_tends_to_the_curved_area(self):
        """As ParaView shows it: straight triangles, whose error falls by four with each level of subdivision."""
        self.document("three", 2)
        area = self.curved_area()
        for options in ((), ("--lagrange",)):
            run("export-vtu", *options, "mesh.json", "-o", "out.vtu")
            errors = []
            for level in (1, 2, 3, 4):
                surface = vtk.vtkDataSetSurfaceFilter()
                surface.SetInputData(read("out.vtu"))
                surface.SetNonlinearSubdivisionLevel(level)
                mass = vtk.vtkMassProperties()
                mass.SetInputConnection(surface.GetOutputPort())
                errors.append(abs(mass.GetSurfaceArea() - area))
            for coarse, fine in zip(errors, errors[1:]):
                self.assertTrue(3.5 < coarse / fine < 4.5, errors)

    def curved_area(self):
        run("export-vtu", "--metric", "element_area", "mesh.json", "-o", "out.vtu")
        array = read("out.vtu").GetCellData().GetArray("element_area")
        return math.fsum(array.GetValue(k) for k in range(array.GetNumberOfValues()))

    def test_files_of_several_blocks(self):
        run("bspline2mesh", "-q", "--max-area", "1e-4", "--max-triangles", "1000000", "--field", "u=x-y",
            EXAMPLES / "disk.json", "-o", "mesh.json")
        document = Document("mesh.json")
        self.assertGreater(24 * len(document.points), 2 * 2 ** 18)
        run("export-vtu", "mesh.json", "-o", "out.vtu")
        grid = read("out.vtu")
        for k, point in enumerate(document.points):
            self.assertEqual((*point, 0.0), grid.GetPoint(k))
            self.assertEqual(document.fields["u"]["values"][k], grid.GetPointData().GetArray("u").GetValue(k))

    def test_a_mesh_without_elements(self):
        pathlib.Path("mesh.json").write_text(
            '{"format":"pliant-mesh","version":1,"degree":2,"points":[],"triangles":[],"triangle_faces":[],'
            '"constrained_edges":[],"boundary":{"vertices":[],"faces":[],"curves":[]}}')
        run("export-vtu", "--curves", "mesh.json", "-o", "out.vtu")
        grid = read("out.vtu")
        self.assertEqual((0, 0, []), (grid.GetNumberOfPoints(), grid.GetNumberOfCells(), strings(grid, "face_names")))

    def test_a_series(self):
        pathlib.Path("series.jsonl").write_bytes(
            b"".join(run("sample_mesh", "disk", str(p), str(time)).stdout for p, time in ((1, 0), (2, 0.5), (4, 0.75))))
        run("export-vtu", "series.jsonl", "-o", "film.pvd")
        entries = list(ElementTree.parse("film.pvd").iter("DataSet"))
        self.assertEqual(["0", "0.5", "0.75"], [entry.get("timestep") for entry in entries])
        for entry, points in zip(entries, (3, 6, 15)):
            grid = read(entry.get("file"))
            self.assertEqual(points, grid.GetCell(0).GetNumberOfPoints())
            self.assertEqual(float(entry.get("timestep")), grid.GetFieldData().GetArray("TimeValue").GetValue(0))


if __name__ == "__main__":
    unittest.main()
