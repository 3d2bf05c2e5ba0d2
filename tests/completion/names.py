"""A mesh whose names are as odd as names may be, in the forms in which inputs come."""
import json

FACES = ["left cell", "it's", 'say "so"', "a=b", "x:y", "Zelle-π", "back\\slash", "$HOME", "new\nline", "plain"]
FIELDS = ["velocity", "temperature", "heat flow"]
CURVES = ["outline", "inner wall"]


def mesh():
    field = {"components": 1, "by_face": False, "values": [0, 1, 1, 0]}
    return {"format": "pliant-mesh", "version": 1, "degree": 1, "time": 0, "points": [0, 0, 1, 0, 1, 1, 0, 1],
            "note": {"name": "}][", "faces": [{"name": "not one"}]},
            "triangles": [0, 1, 2, 0, 2, 3], "triangle_faces": [0, 0], "constrained_edges": [],
            "fields": [{"name": name, **field} for name in FIELDS],
            "boundary": {"vertices": [], "faces": [{"name": name} for name in FACES],
                         "curves": [{"name": name, "points": []} for name in CURVES]},
            "problem": {"format": "pliant-problem", "parameters": {"conductivity": 1}}}


def write(folder):
    (folder / "mesh.json").write_text(json.dumps(mesh()))
    (folder / "in lines.json").write_text(json.dumps(mesh(), indent=1, ensure_ascii=False))
    (folder / "series.jsonl").write_text("\n" + (json.dumps(mesh()) + "\n") * 2 + "broken")
    (folder / "cut.json").write_text(json.dumps(mesh())[:-3])
    (folder / "boundary.json").write_text(json.dumps({"format": "pliant-boundary", **mesh()["boundary"]}))
    (folder / "problem.json").write_text(json.dumps({"format": "pliant-problem", "parameters": {"k": 1, "rate": 2}}))
    (folder / "drawing.svg").write_text("<svg/>")
    (folder / "notes.txt").write_text("")
    (folder / "folder").mkdir()
