#!/usr/bin/env python3
"""Validates the documents that the tests before this one have collected: `documents_test.py FOLDER SOURCE`.

Documents up to 24 KB are validated by python3-jsonschema; with AJV, the folder of the npm package, larger ones by it as well."""
import json
import os
import pathlib
import re
import subprocess
import sys
import warnings

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "support"))
import cbor

warnings.simplefilter("ignore", DeprecationWarning)
try:
    import jsonschema
except ImportError:
    print("python3-jsonschema is missing")
    sys.exit(77)

folder, source = pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2])
small = 24 * 1024
schemas = {file.name.split(".")[0]: json.loads(file.read_text()) for file in (source / "formats").glob("*.schema.json")}
store = {f"{name}.schema.json": schema for name, schema in schemas.items()}
validators = {name: jsonschema.Draft202012Validator(schema, resolver=jsonschema.RefResolver(f"{name}.schema.json", schema, store=store))
              for name, schema in schemas.items()}
failures, counts, large = [], {}, []


def schema_of(kind, document):
    """Documents say themselves what they are; lines of reports and logs do not, and the option that wrote them does."""
    return document.get("format", "").removeprefix("pliant-") if kind == "document" else kind


for file in sorted(folder.glob("*-*.json")) + sorted(folder.glob("*-*.cbor")):
    kind = file.name.split("-")[0]
    data = file.read_bytes()
    documents = list(cbor.sequence(data)) if file.suffix == ".cbor" else [json.loads(data)]
    for document in documents:
        name = schema_of(kind, document)
        if name not in validators:
            failures.append(f"{file}: no schema for '{name}'")
            continue
        counts[name] = counts.get(name, 0) + 1
        if len(data) > small:
            large.append((name, file, document))
            continue
        failures += [f"{file}: {error.json_path}: {error.message[:200]}" for error in validators[name].iter_errors(document)]
        if "problem" in document and name == "mesh":
            failures += [f"{file}: problem: {error.json_path}: {error.message[:200]}"
                         for error in validators["problem"].iter_errors(document["problem"])]

AJV = """
import { createRequire } from 'node:module';
import { readFileSync } from 'node:fs';
const Ajv = createRequire(process.argv[1] + '/')('ajv/dist/2020').default;
const { schemas, documents } = JSON.parse(readFileSync(0, 'utf8'));
const ajv = new Ajv({ strict: false });
for (const [name, schema] of Object.entries(schemas)) ajv.addSchema(schema, name + '.schema.json');
for (const [name, file, document] of documents) {
  const validate = ajv.getSchema(name + '.schema.json');
  if (!validate(document)) console.log(file + ': ' + ajv.errorsText(validate.errors).slice(0, 300));
}
"""
if "AJV" in os.environ:
    files = [[name, str(file), document] for name, file, document in large]
    done = subprocess.run(["node", "--input-type=module", "-e", AJV, "--", os.environ["AJV"]], text=True, capture_output=True,
                          input=json.dumps({"schemas": schemas, "documents": files}))
    failures += done.stdout.splitlines() + ([done.stderr] if done.returncode else [])
print(", ".join(f"{count} of {name}" for name, count in sorted(counts.items())), f"; {len(large)} above {small} bytes")
print("\n".join(failures))
wanted = {"mesh", "boundary", "report", "pass_report", "evolve_log"}
if not counts:
    print("no test that collects documents has run before this one")
    sys.exit(77)
if "ALL_KINDS" in os.environ and not wanted <= set(counts):
    print("no documents were collected of", wanted - set(counts))
    sys.exit(1)
sys.exit(1 if failures else 0)
