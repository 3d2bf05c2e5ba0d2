#!/usr/bin/env python3
"""Validates the documents that the tests before this one have collected: `documents_test.py FOLDER SOURCE`.

README.md beside this file says which ones these are. All are validated by python3-jsonschema, and with AJV, the folder
of the npm package, by it as well."""
import collections
import json
import multiprocessing
import os
import pathlib
import subprocess
import sys
import warnings

source = pathlib.Path(sys.argv[2])
sys.path.insert(0, str(source / "tests" / "support"))
import cbor  # noqa: E402

warnings.simplefilter("ignore", DeprecationWarning)
try:
    import jsonschema
except ImportError:
    print("python3-jsonschema is missing")
    sys.exit(77)

WANTED = {"mesh", "boundary", "report", "pass_report", "evolve_log"}
schemas = {file.name.split(".")[0]: json.loads(file.read_text()) for file in (source / "formats").glob("*.schema.json")}
store = {f"{name}.schema.json": schema for name, schema in schemas.items()}
validators = {name: jsonschema.Draft202012Validator(
                  schema, resolver=jsonschema.RefResolver(f"{name}.schema.json", schema, store=store))
              for name, schema in schemas.items()}


def parts_of(file):
    """What of a file has a schema, each with the schema's name: documents say themselves what they are; lines of
    reports and logs do not, and the option that wrote them does. A mesh may carry a problem."""
    data = file.read_bytes()
    kind = file.name.split("-")[0]
    for document in cbor.sequence(data) if file.suffix == ".cbor" else [json.loads(data)]:
        name = document.get("format", "").removeprefix("pliant-") if kind == "document" else kind
        yield name, document
        if name == "mesh" and "problem" in document:
            yield "problem", document["problem"]


def validate(file):
    """The names of the schemas, and what they refuse."""
    names, faults = [], []
    try:
        for name, document in parts_of(file):
            names.append(name)
            if name not in validators:
                faults.append(f"{file}: no schema for '{name}'")
                continue
            faults += [f"{file}: {error.json_path}: {error.message[:200]}"
                       for error in validators[name].iter_errors(document)]
    except (AssertionError, AttributeError, IndexError, ValueError) as error:
        faults.append(f"{file}: cannot be read: {error!r}")
    return names, faults


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


def faults_by_ajv(files):
    documents = [[name, str(file), document] for file in files for name, document in parts_of(file)]
    done = subprocess.run(["node", "--input-type=module", "-e", AJV, "--", os.environ["AJV"]], text=True,
                          capture_output=True, input=json.dumps({"schemas": schemas, "documents": documents}))
    return done.stdout.splitlines() + ([done.stderr] if done.returncode else [])


def main():
    folder = pathlib.Path(sys.argv[1])
    files = [*folder.glob("*-*.json"), *folder.glob("*-*.cbor")]
    files.sort(key=lambda file: file.stat().st_size, reverse=True)
    large = [file for file in folder.glob("*.large") if not file.with_suffix("").exists()]
    if not files:
        print("no test that collects documents has run before this one")
        return 77
    with multiprocessing.Pool() as pool:
        found = pool.map(validate, files, chunksize=1)
    faults = [fault for _, some in found for fault in some]
    counts = collections.Counter(name for names, _ in found for name in names)
    tools = collections.Counter(file.name.split("-", 1)[1].rpartition("-")[0] for file in files)
    print(f"{len(files)} documents, of each tool and shape the smallest:",
          ", ".join(f"{n} of {name}" for name, n in sorted(counts.items())))
    print("written by", ", ".join(f"{tool} ({n})" for tool, n in sorted(tools.items())))
    print(f"not validated, since there are none below 16 MB: {len(large)} shapes", *sorted(file.name for file in large))
    if not faults and "AJV" in os.environ:
        faults = faults_by_ajv(files)
        print("validated by ajv as well")
    print("\n".join(faults))
    if "ALL_KINDS" in os.environ and not WANTED <= set(counts):
        print("no documents were collected of", WANTED - set(counts))
        return 1
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
