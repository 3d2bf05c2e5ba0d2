"""The schemas accept what the pages show and what the tools write, and refuse what the readers refuse."""
import copy
import json
import pathlib
import re
import subprocess
import sys
import tempfile

try:
    import jsonschema
except ImportError:
    print("python3-jsonschema is missing")
    sys.exit(77)

source = pathlib.Path(sys.argv[1])
sys.path.insert(0, str(source / "tests" / "support"))
import cbor  # noqa: E402

schemas = {name: json.loads((source / "formats" / f"{name}.schema.json").read_text()) for name in (file.name.split(".")[0] for file in sorted((source / "formats").glob("*.schema.json")))}
store = {f"{name}.schema.json": schema for name, schema in schemas.items()}


def validator(name):
    jsonschema.Draft202012Validator.check_schema(schemas[name])
    resolver = jsonschema.RefResolver(f"{name}.schema.json", schemas[name], store=store)
    return jsonschema.Draft202012Validator(schemas[name], resolver=resolver)


def status(document):
    return subprocess.run(["passthrough"], input=json.dumps(document), text=True, capture_output=True).returncode


validators = {name: validator(name) for name in schemas}
failures = []
examples, problems = {}, {}
for name in schemas:
    page = (source / "formats" / f"{name}.md").read_text()
    for text in re.findall(r"```json\n(.*?)```", page, re.S):
        examples[name] = json.loads(text)
        failures += [f"{name}.md: {e.json_path} {e.message}" for e in validators[name].iter_errors(examples[name])]
        if name == "problem":
            problems.update({section: examples[name] for section in ("diffuse", "navierstokes") if section in examples[name]})
# Every page with a document in it has a schema beside it, and every schema a page with an example.
shown = {page.stem for page in (source / "formats").glob("*.md") if "```json" in page.read_text()}
assert shown == set(schemas) == set(examples) and len(schemas) >= 6, (shown, set(schemas))
for page in (source / "formats").glob("*.md"):
    fences = re.findall(r"^```(\w*)$", page.read_text(), re.M)
    failures += [f"{page.name}: a fence '{kind}', which no test reads" for kind in fences[::2] if kind not in ("json", "hex")]
assert len(problems) == 2
if subprocess.run(["bspline2mesh", "-q"], input=json.dumps(examples["boundary"]), text=True, capture_output=True).returncode != 0:
    failures.append("boundary.md: bspline2mesh refuses the example")
if status(examples["mesh"]) != 0:
    failures.append("mesh.md: the tools refuse the example")

# The same document in CBOR: it begins as the page says, and another decoder reads what the tools write as JSON.
as_json = subprocess.run(["passthrough"], input=json.dumps(examples["mesh"]).encode(), capture_output=True).stdout
as_cbor = subprocess.run(["passthrough", "--to", "cbor"], input=json.dumps(examples["mesh"]).encode(), capture_output=True).stdout
fences = {page.name: re.findall(r"```hex\n(.*?)```", page.read_text(), re.S) for page in (source / "formats").glob("*.md")}
assert [name for name, found in fences.items() if found] == ["mesh.md"] and len(fences["mesh.md"]) == 1, fences
if not as_cbor.startswith(bytes.fromhex(fences["mesh.md"][0])):
    failures.append(f"mesh.md: in CBOR the example begins with {as_cbor[:80].hex(' ')}")
if cbor.decode(as_cbor) != (json.loads(as_json), len(as_cbor)):
    failures.append("mesh.md: the example in CBOR is another document than in JSON")

for kind, degree in (("disk", 1), ("three", 2), ("tangled", 3)):
    document = json.loads(subprocess.check_output(["sample_mesh", kind, str(degree)]))
    failures += [f"sample_mesh {kind}: {e.json_path} {e.message}" for e in validators["mesh"].iter_errors(document)]

# Each edit breaks the document for the readers; the schema must see it too.
edits = [
    lambda d: d.update(version=2),
    lambda d: d.update(degree=11),
    lambda d: d.update(degree=1.5),
    lambda d: d.pop("points"),
    lambda d: d["points"].__setitem__(0, "0"),
    lambda d: d["triangles"].__setitem__(0, -1),
    lambda d: d["constrained_edges"][0].update(color="red"),
    lambda d: d["constrained_edges"][0].pop("span"),
    lambda d: d["fields"][0].update(by_face=True),
    lambda d: d["fields"][0].update(places=[0, 0]),
    lambda d: d["fields"][0].update(components=0),
    lambda d: d["criteria"].update(max_area=0),
    lambda d: d["criteria"].update(min_angle=60),
    lambda d: d["criteria"].update(face_area={"square": -1}),
    lambda d: d["boundary"].update(format="pliant-mesh"),
    lambda d: d["boundary"]["curves"][0].update(start=0),
    lambda d: d["boundary"]["curves"][0].update(closed=False),
    lambda d: d["boundary"]["curves"][0].update(removal_error=-1),
    lambda d: d["boundary"]["faces"][0].pop("name"),
]
for number, edit in enumerate(edits):
    document = copy.deepcopy(examples["mesh"])
    edit(document)
    if validators["mesh"].is_valid(document):
        failures.append(f"the mesh schema accepts edit {number}")
    if status(document) != 3:
        failures.append(f"the reader accepts edit {number}")

# Problems: the examples stand on a channel with a cell in it, and are carried by the mesh.
def curve(name, points, ends, sides):
    closed = ends[0] is None
    knots = list(range(len(points) // 2 + 1)) if closed else [0, 0, 1, 1]
    return {"name": name, "degree": 1, "closed": closed, "knots": knots, "points": points,
            "start": ends[0], "end": ends[1], "left": sides[0], "right": sides[1]}


corners = [0, 0, 4, 0, 4, 1, 0, 1]
channel = {"format": "pliant-boundary", "version": 1, "vertices": corners, "faces": [{"name": "fluid"}, {"name": "cell"}],
           "curves": [curve(name, [*corners[2 * k:2 * k + 2], *corners[2 * k2:2 * k2 + 2]], (k, k2), (0, None))
                      for k, name in enumerate(("floor", "outflow", "roof", "inflow")) for k2 in ((k + 1) % 4,)]
           + [curve("membrane", [1.5, .25, 2.5, .25, 2.5, .75, 1.5, .75], (None, None), (1, 0))]}
channel_mesh = subprocess.run(["bspline2mesh", "-q"], input=json.dumps(channel), text=True, capture_output=True, check=True).stdout


def solve(problem):
    with tempfile.NamedTemporaryFile("w", suffix=".json") as file:
        json.dump(problem, file)
        file.flush()
        return subprocess.run(["passthrough", "--problem", file.name], input=channel_mesh, text=True, capture_output=True)


for section, example in problems.items():
    solved = solve(example)
    if solved.returncode != 0:
        failures.append(f"problem.md: the example of {section} is refused: {solved.stderr}")
        continue
    mesh = json.loads(solved.stdout)
    for name, document in (("mesh", mesh), ("problem", mesh["problem"])):
        failures += [f"a mesh with a problem: {e.json_path} {e.message}" for e in validators[name].iter_errors(document)]
edits = [
    lambda d: d.pop("format"),
    lambda d: d.update(version=2),
    lambda d: d["parameters"].update(k=True),
    lambda d: d["parameters"].update({"a b": 1}),
    lambda d: d["parameters"].update(x=1),
    lambda d: d["parameters"].update(floor=1),
    lambda d: d["parameters"].update({65 * "k": 1}),
    lambda d: d["diffuse"].pop("field"),
    lambda d: d["diffuse"].update(field=""),
    lambda d: d["diffuse"].pop("materials"),
    lambda d: d["diffuse"].update(material={}),
    lambda d: d["diffuse"].update(convection=[1]),
    lambda d: d["diffuse"].update(initial=[1]),
    lambda d: d["diffuse"]["initial"].update(cell=None),
    lambda d: d["diffuse"]["materials"]["cell"].update(colour="red"),
    lambda d: d["diffuse"]["materials"]["cell"].update(diffusivity=[1, 2]),
    lambda d: d["diffuse"]["materials"]["cell"].update(capacity=[1]),
    lambda d: d["diffuse"]["conditions"][0].pop("curve"),
    lambda d: d["diffuse"]["conditions"][0].update(curve=[]),
    lambda d: d["diffuse"]["conditions"][0].update(curve=4),
    lambda d: d["diffuse"]["conditions"][0].update(value=1),
    lambda d: d["diffuse"]["conditions"][0].update(why="so"),
    lambda d: d["diffuse"]["conditions"][0].pop("jump"),
    lambda d: d["diffuse"]["conditions"][0]["jump"].update(ambient=1),
    lambda d: d["diffuse"]["conditions"][3]["robin"].pop("ambient"),
]
flow_edits = [
    lambda d: d["navierstokes"].pop("materials"),
    lambda d: d["navierstokes"].update(tension={}),
    lambda d: d["navierstokes"].update(gravity=[1]),
    lambda d: d["navierstokes"].update(force=1),
    lambda d: d["navierstokes"].update(initial=["x", "y", 0]),
    lambda d: d["navierstokes"].update(pressure="jumps"),
    lambda d: d["navierstokes"]["surface_tension"].update({"*": 1}),
    lambda d: d["navierstokes"]["surface_tension"].update(membrane=[1]),
    lambda d: d["navierstokes"]["materials"]["cell"].pop("viscosity"),
    lambda d: d["navierstokes"]["materials"]["cell"].update(capacity=1),
    lambda d: d["navierstokes"]["conditions"][0].pop("curve"),
    lambda d: d["navierstokes"]["conditions"][0].update(velocity=1),
    lambda d: d["navierstokes"]["conditions"][0].update(slip=True),
    lambda d: d["navierstokes"]["conditions"][0].update(moves=1),
    lambda d: d["navierstokes"]["conditions"][2].update(slip=False),
    lambda d: d["navierstokes"]["conditions"][2].pop("slip"),
    lambda d: d["navierstokes"]["conditions"][3].update(moves=True),
]
for section, edit in [("diffuse", edit) for edit in edits] + [("navierstokes", edit) for edit in flow_edits]:
    document = copy.deepcopy(problems[section])
    edit(document)
    number = (edits if section == "diffuse" else flow_edits).index(edit)
    if validators["problem"].is_valid(document):
        failures.append(f"the schema of problems accepts edit {number} of {section}")
    if solve(document).returncode != 3:
        failures.append(f"the reader of problems accepts edit {number} of {section}")

# The log of a simulation, and edits that its schema must see.
with tempfile.TemporaryDirectory() as folder:
    log = pathlib.Path(folder) / "log.jsonl"
    start = subprocess.check_output(["sample_mesh", "three", "2"])
    subprocess.run(["evolve", "--until", "2", "--at", "0.75", "--log", log, "-o", "/dev/null",
                    "advect --flow cylinder:x=-3 --dt 0.5 | flipdelaunay | refine | coarsen | smoothcurves"], input=start, check=True)
    lines = [json.loads(line) for line in log.read_text().splitlines()]
    assert len(lines) >= 5
    for line in lines:
        failures += [f"evolve --log: {e.json_path} {e.message}" for e in validators["evolve_log"].iter_errors(line)]
for number, edit in enumerate((
        lambda d: d.pop("stages"),
        lambda d: d.update(step=0),
        lambda d: d.update(dt=-1),
        lambda d: d.update(colour="red"),
        lambda d: d["stages"][0].pop("seconds"),
        lambda d: d["stages"][0]["values"].update(flips="3"),
        lambda d: d["stages"][0]["refusals"].update(why=0))):
    line = copy.deepcopy(examples["evolve_log"])
    edit(line)
    if validators["evolve_log"].is_valid(line):
        failures.append(f"the schema of the log accepts edit {number}")

for number, edit in enumerate((
        lambda d: d.pop("tool"),
        lambda d: d.update(frame=-1),
        lambda d: d.update(colour="red"),
        lambda d: d["values"].update(inserted="3"),
        lambda d: d["refusals"].update(why=0),
        lambda d: d["refused_at"][0].pop("x"),
        lambda d: d["before"].pop("fields"),
        lambda d: d["after"].update(invalid=0.5),
        lambda d: d.pop("missed_after"),
        lambda d: d["growth"][0].update(l2="1"),
        lambda d: d["seconds"].update(read=-1))):
    line = copy.deepcopy(examples["pass_report"])
    edit(line)
    if validators["pass_report"].is_valid(line):
        failures.append(f"the schema of reports accepts edit {number}")

print("\n".join(failures))
sys.exit(1 if failures else 0)
