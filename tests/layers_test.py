#!/usr/bin/env python3
"""Reads the #includes of every source and fails when a folder includes one that is above it or beside it on its floor,
when another library appears outside the folder that it belongs to, or when lib/README.md draws another picture."""
import collections
import pathlib
import re
import sys
import unittest

ROOT = pathlib.Path(__file__).resolve().parent.parent

# From the ground up; folders on one floor do not know each other.
FLOORS = [
    ["geometry"],
    ["boundary"],
    ["mesh"],
    ["ops", "flow", "fem", "quality"],
    ["improve"],
    ["generate"],
    ["evolve", "formats"],
    ["tools"],
]
FLOOR = {folder: height for height, floor in enumerate(FLOORS) for folder in floor}

# The folders that may use a library at all, and whether a header may include it.
ROOMS = [
    (re.compile(r"Eigen/|eigen3/"), {"geometry", "boundary", "mesh", "ops", "quality", "flow", "fem", "improve"}, False),
    (re.compile(r"boost/"), {"geometry"}, False),
    (re.compile(r"ceres/|glog/"), {"improve"}, False),
    (re.compile(r"nlohmann/json_fwd\.hpp"), {"formats"}, True),
    (re.compile(r"nlohmann/(?!json_fwd\.hpp)|simdjson|tiny_gltf|expat|zlib|zstd"), {"formats"}, False),
    (re.compile(r"librsvg/|cairo"), {"formats"}, False),
    (re.compile(r"muParser"), {"tools"}, False),
    (re.compile(r"CLI/"), {"tools"}, True),
    (re.compile(r"catch2?/"), set(), False),
]

INCLUDE = re.compile(r'^\s*#\s*include\s*[<"]([^>"]+)[>"]', re.MULTILINE)


def folder_of(path):
    """The folder that a file, or an include as it is written, belongs to; None for other libraries."""
    parts = pathlib.PurePosixPath(path).parts
    if parts[:2] == ("lib", "pliant"):
        parts = parts[1:]
    if parts[0] == "pliant":
        return parts[1]
    return parts[0] if parts[0] in FLOOR and len(parts) > 1 else None


def faults_of(path, text):
    """What is wrong with the includes of one file, in sentences; `path` is relative to the root."""
    here = folder_of(path)
    if here not in FLOOR:
        return [f"{path}: the folder {here} is on no floor"]
    faults = []
    for target in INCLUDE.findall(text):
        there = folder_of(target)
        if there is not None and there not in FLOOR:
            faults.append(f"{path}: {target} is on no floor")
        elif there is not None and there != here and FLOOR[there] >= FLOOR[here]:
            where = "beside" if FLOOR[there] == FLOOR[here] else "above"
            faults.append(f"{path}: includes {target}, and {there} is {where} {here}")
        for library, rooms, in_headers in ROOMS:
            if there is None and library.match(target):
                if here not in rooms:
                    faults.append(f"{path}: includes {target}, which does not belong into {here}")
                elif path.endswith(".h") and not in_headers:
                    faults.append(f"{path}: includes {target} in a header")
    return faults


def sources():
    """The C++ files of the product."""
    return [file for folder in ("lib", "formats", "tools") for file in sorted((ROOT / folder).rglob("*"))
            if file.suffix in (".h", ".cpp")]


def arrows():
    """For each folder, the other folders that its files include; tools include their own rooms without a folder."""
    found = collections.defaultdict(set)
    for file in sources():
        here = folder_of(file.relative_to(ROOT).as_posix())
        for target in INCLUDE.findall(file.read_text(encoding="utf-8")):
            there = folder_of(target)
            if there in FLOOR and there != here:
                found[here].add(there)
    return dict(found)


def rooms():
    """The folders that hold code, as lib/README.md names them."""
    folders = {file.parent.relative_to(ROOT).as_posix() for file in sources()} | {"formats", "formats/report/page"}
    return {folder.removeprefix("lib/pliant/") for folder in folders}


class Layers(unittest.TestCase):
    def test_the_sources_keep_to_their_floors(self):
        self.assertGreater(len(sources()), 30)
        faults = [fault for file in sources()
                  for fault in faults_of(file.relative_to(ROOT).as_posix(), file.read_text(encoding="utf-8"))]
        self.assertEqual([], faults, "\n" + "\n".join(faults))

    def test_the_page_of_the_library_draws_the_floors_and_the_arrows_that_there_are(self):
        page = (ROOT / "lib/README.md").read_text(encoding="utf-8")
        drawn = [re.split(r" +", line.strip()) for line in re.findall(r"^    ([a-z ]+)$", page, re.MULTILINE)]
        self.assertEqual([sorted(floor) for floor in reversed(FLOORS)], [sorted(floor) for floor in drawn])
        told = {here: set(there.split()) for here, there in re.findall(r"^    (\w+) *-> (.+)$", page, re.MULTILINE)}
        self.assertEqual(arrows(), told)

    def test_the_page_of_the_library_has_a_sentence_for_each_room(self):
        page = (ROOT / "lib/README.md").read_text(encoding="utf-8")
        told = re.findall(r"^\| `([^`]+)` \| .*\.( \|)$", page, re.MULTILINE)
        self.assertEqual(sorted(rooms()), sorted(room for room, _ in told))

    def test_no_folder_has_more_than_thirty_files(self):
        folders = collections.Counter(
            file.parent for top in ("lib", "formats", "tools", "tests", "man", "samples")
            for file in (ROOT / top).rglob("*")
            if file.is_file() and not {"node_modules", "out", "build", "__pycache__"} & set(file.parts))
        self.assertEqual({}, {str(folder): count for folder, count in folders.items() if count > 30})

    def test_no_source_has_more_than_350_lines(self):
        files = sources() + [file for file in (ROOT / "tests").rglob("*") if file.suffix in (".h", ".cpp", ".py")
                             and "node_modules" not in file.parts]
        long = {str(file): lines for file in files
                if (lines := len(file.read_text(encoding="utf-8").splitlines())) > 350}
        self.assertEqual({}, long)

    def test_an_include_below_or_within_is_allowed(self):
        self.assertEqual([], faults_of("lib/pliant/ops/a.cpp", '#include "pliant/mesh/mesh.h"\n#include <vector>\n'))
        self.assertEqual([], faults_of("tools/a.cpp", '#include "formats/picture/svg.h"\n#include <CLI/CLI.hpp>\n'))
        self.assertEqual([], faults_of("formats/a.cpp", '#include "formats/b.h"\n'))

    def test_an_include_above_is_a_fault(self):
        self.assertIn("above", faults_of("lib/pliant/mesh/a.h", '#include "pliant/ops/b.h"\n')[0])
        self.assertIn("above", faults_of("lib/pliant/mesh/a.h", '  #  include <formats/b.h>\n')[0])

    def test_an_include_beside_is_a_fault(self):
        self.assertIn("beside", faults_of("lib/pliant/ops/a.cpp", '#include "pliant/quality/b.h"\n')[0])

    def test_a_library_outside_its_room_is_a_fault(self):
        self.assertIn("does not belong", faults_of("lib/pliant/mesh/a.cpp", "#include <nlohmann/json.hpp>\n")[0])
        self.assertIn("in a header", faults_of("lib/pliant/ops/a.h", "#include <Eigen/Core>\n")[0])
        self.assertIn("in a header", faults_of("formats/a.h", "#include <nlohmann/json.hpp>\n")[0])
        self.assertIn("does not belong", faults_of("tools/a.h", "#include <nlohmann/json_fwd.hpp>\n")[0])

    def test_names_of_json_values_may_be_in_headers_of_formats(self):
        self.assertEqual([], faults_of("formats/a.h", "#include <nlohmann/json_fwd.hpp>\n"))

    def test_installed_headers_need_no_header_of_another_library(self):
        """The installed ones are those that CMake lists, and all that they include must be among them."""
        lists = (ROOT / "formats/CMakeLists.txt").read_text(encoding="utf-8")
        installed = [f"formats/{name}" for name in re.findall(r"[\w/]+\.h\b", lists)]
        self.assertGreater(len(installed), 10)
        for header in installed:
            for target in INCLUDE.findall((ROOT / header).read_text(encoding="utf-8")):
                self.assertNotIn("nlohmann", target, header)
                if target.startswith("formats/"):
                    self.assertIn(target, installed, header)

    def test_a_folder_on_no_floor_is_a_fault(self):
        self.assertEqual(1, len(faults_of("lib/pliant/util/a.h", "")))
        self.assertEqual(1, len(faults_of("lib/pliant/ops/a.h", '#include "pliant/util/a.h"\n')))


if __name__ == "__main__":
    sys.exit(unittest.main(verbosity=1))
