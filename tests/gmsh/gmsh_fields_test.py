#!/usr/bin/env python3
"""Fields on their way through Gmsh: it reads what export-msh writes, evaluates it at its degree, and writes it again."""
import json
import os
import pathlib
import re
import subprocess
import sys
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "support"))
from scratch import InScratch  # noqa: E402

GMSH = os.environ.get("GMSH", "gmsh")
FORMATS = [("msh41", ()), ("msh41", ("--binary",)), ("msh22", ()), ("msh22", ("--binary",))]
GEOMETRY = """
    SetFactory("OpenCASCADE");
    Disk(1) = {0, 0, 0, 2}; Disk(2) = {0.7, 0.1, 0, 0.8, 0.6};
    BooleanFragments{ Surface{1}; Delete; }{ Surface{2}; Delete; }
    Physical Surface("ring", 1) = {3}; Physical Surface("cell", 2) = {2};
    Mesh.MeshSizeMax = 0.8; Mesh.HighOrderOptimize = 1;
"""


def run(*words, text=None):
    done = subprocess.run([str(word) for word in words], input=text, capture_output=True, text=True, timeout=300)
    if done.returncode != 0:
        raise AssertionError(f"{words}: status {done.returncode}: {done.stderr[:2000]} {done.stdout[-500:]}")
    return done


def gmsh_script(text):
    pathlib.Path("script.geo").write_text(text + "\n")
    words = run(GMSH, "-nt", "1", "script.geo", "-")
    if re.search("Warning|Error", words.stdout + words.stderr):
        raise AssertionError(words.stdout + words.stderr)


def control_values(mesh):
    """For each field, its control values by place: rounded coordinates, and the face's name if it is by face."""
    size = max(map(abs, mesh["points"]))
    points = list(zip(mesh["points"][::2], mesh["points"][1::2]))
    key = [(round(x / size, 9) + 0.0, round(y / size, 9) + 0.0) for x, y in points]
    result = {}
    for field in mesh["fields"]:
        c, by_face = field["components"], field["by_face"]
        places = ([key[p] + (mesh["boundary"]["faces"][f]["name"],)
                   for p, f in zip(field["places"][::2], field["places"][1::2])] if by_face else key)
        rows = {place: field["values"][k * c:k * c + c] for k, place in enumerate(places)}
        result[field["name"]] = (c, by_face, rows)
    return result


class Fields(InScratch):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        pathlib.Path("cell.geo").write_text(GEOMETRY)

    def document(self, degree):
        fields = ["--field", "u=sin(3*x)*cos(2*y)", "--field", "v=x*y,1-x*x", "--field", "w=x,y,x+y"]
        run(GMSH, "-2", "-nt", "1", "-order", degree, "cell.geo", "-o", "cell.msh")
        fields += ["--field", "p@cell=10+x*y", "--field", "p@ring=x-y"]
        pathlib.Path("mesh.json").write_text(run("import-msh", "-q", "--orient", "--time", "0.25", *fields, "cell.msh").stdout)
        return json.loads(pathlib.Path("mesh.json").read_text())

    def places(self, mesh):
        """The mean of three corners, for some triangles."""
        size = (mesh["degree"] + 1) * (mesh["degree"] + 2) // 2
        count = len(mesh["triangle_faces"])
        for t in range(0, count, max(1, count // 8)):
            corners = mesh["triangles"][size * t:size * t + 3]
            yield tuple(sum(mesh["points"][2 * p + x] for p in corners) / 3 for x in (0, 1))

    def probed(self, places):
        """What Gmsh finds: for each place the values of each view in file.msh."""
        lines, files = ['Merge "file.msh";', "n = PostProcessing.NbViews;"], []
        for x, y in places:
            lines += [f"Plugin(Probe).X = {x!r}; Plugin(Probe).Y = {y!r}; Plugin(Probe).Z = 0;"]
            for view in range(4):
                files.append(f"probe{len(files)}.pos")
                lines += [f"Plugin(Probe).View = {view}; Plugin(Probe).Run;",
                          f'Save View[PostProcessing.NbViews - 1] "{files[-1]}";']
        gmsh_script("\n".join(lines))
        rows = [[float(word) for word in re.search(r"\{([^}]*)\}", pathlib.Path(file).read_text().split("{", 1)[1]).group(1).split(",")]
                for file in files]
        return [rows[4 * k:4 * k + 4] for k in range(len(rows) // 4)]

    def test_gmsh_evaluates_fields_at_their_degree_and_gives_them_back(self):
        for degree in (1, 2, 3, 4, 5):
            mesh = self.document(degree)
            before = control_values(mesh)
            self.assertEqual({"u": (1, False), "v": (2, False), "w": (3, False), "p": (1, True)},
                             {name: field[:2] for name, field in before.items()})
            places = list(self.places(mesh))
            ats = [word for k, (x, y) in enumerate(places) for word in ("--at", f"P{k}={x!r},{y!r}:u,v,w,p")]
            table = run("measure", "-q", "--csv", "-", *ats, "mesh.json").stdout.splitlines()
            names, values = table[0].split(","), [float(word) for word in table[1].split(",")]
            for form, binary in FORMATS:
                with self.subTest(degree=degree, form=form, binary=binary):
                    run("export-msh", "--format", form, *binary, "mesh.json", "-o", "file.msh")
                    for k, found in enumerate(self.probed(places)):
                        ours = [value for name, value in zip(names, values) if name.startswith(f"P{k}_")]
                        u, v, w, p = found
                        self.assertEqual(0, v[2])
                        theirs = u + v[:2] + w + p
                        self.assertEqual(len(ours), len(theirs), names)
                        for a, b in zip(ours, theirs):
                            self.assertLess(abs(a - b), 1e-10, (k, ours, theirs))
                    # Gmsh writes each view into a file of its own, with the mesh.
                    for msh in (2.2, 4.1):
                        gmsh_script(f'Merge "file.msh"; Mesh.MshFileVersion = {msh}; Mesh.Binary = {len(binary)};\n' + "".join(
                            f'Save View[{view}] "view{view}.msh";\n' for view in range(4)))
                        for view, name in enumerate(before):
                            done = run("import-msh", f"view{view}.msh")
                            self.assertEqual("", done.stderr)
                            after = json.loads(done.stdout)
                            self.assertEqual(0.25, after["time"])
                            self.same(before[name], control_values(after)[name])

    def same(self, before, after):
        self.assertEqual(before[:2], after[:2])
        self.assertEqual(before[2].keys(), after[2].keys())
        largest = max(abs(value) for row in before[2].values() for value in row)
        for place, row in before[2].items():
            for a, b in zip(row, after[2][place]):
                # Text of Gmsh's has 16 digits, and control values of degree 5 have 43 times the rounding of nodal ones.
                self.assertLess(abs(a - b), 5e-14 * largest, place)


if __name__ == "__main__":
    unittest.main()
