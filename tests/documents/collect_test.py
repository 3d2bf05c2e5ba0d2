#!/usr/bin/env python3
"""What stands in for the tools keeps what a tool writes, whichever way, and what is kept is refused if it is wrong.

Usage: collect_test.py PROGRAM, which is collect_documents."""
import json
import os
import pathlib
import re
import signal
import stat
import subprocess
import sys
import tempfile
import unittest

here = pathlib.Path(__file__).resolve().parent
source = here.parent.parent
program = sys.argv.pop(1)
# A tool that writes what the environment says, whatever its options. It needs to start fast.
TOOL = """#!/bin/sh
cat "$OUT"
cp -R "$FILES/." .
case $STATUS in -*) kill "$STATUS" $$ ;; esac
exit "$STATUS"
"""
LINE = '{"format": "pliant-mesh", "version": 1}\n'


def example(name):
    return json.loads(re.search(r"```json\n(.*?)```", (source / "formats" / f"{name}.md").read_text(), re.S)[1])


class Collection(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        for name in ("work", "kept", "links", "tools"):
            (self.folder / name).mkdir()
        for tool in ("refine", "qualityreport", "evolve", "export-svg"):
            (self.folder / "links" / tool).symlink_to(program)
            file = self.folder / "tools" / tool
            file.write_text(TOOL)
            file.chmod(file.stat().st_mode | stat.S_IXUSR)

    def run_tool(self, words, out=b"", files=None, status=0, stdout=subprocess.PIPE):
        """Runs the tool. Returns the process, and the texts that are kept by now, by kind, tool and form."""
        (self.folder / "out").write_bytes(out)
        made = pathlib.Path(tempfile.mkdtemp(dir=self.folder))
        for name, text in (files or {}).items():
            (made / name).parent.mkdir(exist_ok=True)
            (made / name).write_text(text)
        path = f"{self.folder}/links:{self.folder}/tools:{os.environ['PATH']}"
        done = subprocess.run(words, cwd=self.folder / "work", stdout=stdout, env={
            **os.environ, "PATH": path, "DOCUMENTS": str(self.folder / "kept"), "OUT": str(self.folder / "out"),
            "FILES": str(made), "STATUS": str(status)})
        kept = {}
        for file in (self.folder / "kept").iterdir():
            kept.setdefault(re.sub("-[0-9a-f]{16}", "", file.name), []).append(file.read_bytes())
        return done, kept

    def test_standard_output(self):
        done, kept = self.run_tool(["refine"], LINE.encode())
        self.assertEqual((done.stdout, kept), (LINE.encode(), {"document-refine.json": [LINE[:-1].encode()]}))
        for mode, before in (("w", ""), ("a", "what was there\n")):
            file = self.folder / "work/out"
            file.write_text(before)
            with open(file, mode) as out:
                kept = self.run_tool(["qualityreport"], b'{"a": 1}\n', stdout=out)[1]
            self.assertEqual(file.read_text(), before + '{"a": 1}\n')
            self.assertEqual(kept["report-qualityreport.json"], [b'{"a": 1}'])
            for each in (self.folder / "kept").iterdir():
                each.unlink()
        self.assertEqual(self.run_tool(["refine"], b"no document {\n{\n")[1], {})
        self.assertEqual(self.run_tool(["export-svg"], LINE.encode())[1], {})

    def test_named_files(self):
        for number, words in enumerate((["-o", "a"], ["-oa"], ["-qo", "a"], ["-qoa"], ["--output", "a"], ["--output=a"],
                                        ["-v", "x", "-o", "a"])):
            text = json.dumps({"format": "pliant-mesh", f"case {number}": 0})
            kept = self.run_tool(["refine", *words], files={"a": text + "\n"})[1]
            self.assertIn(text.encode(), kept.get("document-refine.json", []), words)
        for option, kind in (("--report", "pass_report"), ("--log", "evolve_log")):
            for number, words in enumerate(([option, "b"], [option + "=b"])):
                kept = self.run_tool(["evolve", *words], files={"b": f'{{"{number}": 1}}\n'})[1]
                self.assertIn(f'{{"{number}": 1}}'.encode(), kept.get(f"{kind}-evolve.json", []), words)
        kept = self.run_tool(["qualityreport", "-o", "z"], files={"z": '{"z": 1}\n'})[1]
        self.assertEqual(kept["report-qualityreport.json"], [b'{"z": 1}'])

    def test_numbered_files(self):
        (self.folder / "work/f").mkdir()
        (self.folder / "work/f/7.json").write_text('{"old": 1}\n')
        os.utime(self.folder / "work/f/7.json", (1, 1))
        frames = {"f/0.json": '{"a": 1}\n', "f/1.json": '{"b": 1}\n', "f/step": '{"c": 1}\n'}
        self.run_tool(["evolve", "--frames", "f/%d.json"], files=frames)
        kept = self.run_tool(["evolve", "--frames=%05d.json"], files={"00003.json": '{"d": 1}\n'})[1]
        self.assertEqual(set(kept["document-evolve.json"]), {b'{"a": 1}', b'{"b": 1}', b'{"d": 1}'})

    def test_tools_that_fail(self):
        done, kept = self.run_tool(["refine"], b'{"a": 1}\n{"b": ', status=4)
        self.assertEqual((done.returncode, kept), (4, {"document-refine.json": [b'{"a": 1}']}))
        done, kept = self.run_tool(["refine"], bytes.fromhex("a1616101a161"), status=-signal.SIGTERM)
        self.assertEqual(done.returncode, -signal.SIGTERM)
        self.assertEqual(kept["document-refine.cbor"], [bytes.fromhex("a1616101")])
        # Else half a document is a fault, and is kept to be found.
        kept = self.run_tool(["refine"], b'{"c": 1}\n{"b": ')[1]
        self.assertIn(b'{"b": ', kept["document-refine.json"])
        kept = self.run_tool(["refine"], bytes.fromhex("a1616101a161"))[1]
        self.assertIn(bytes.fromhex("a161"), kept["document-refine.cbor"])

    def test_shapes(self):
        lines = ['{"a": [2, 37], "b": "x"}', '{"a": [5, 6], "b": ""}', '{"a": [5, 6, 7, 8, 9], "b": ""}',
                 '{"a": [1, 2, 3], "b": ""}']
        kept = self.run_tool(["refine"], "\n".join([*lines, ""]).encode())[1]["document-refine.json"]
        self.assertEqual(set(kept), {lines[1].encode(), lines[3].encode()})
        for line in ('{"a": [5, -6], "b": ""}', '{"a": [5, 1e-6], "b": ""}', '{"a": [null, 6], "b": ""}', '{"b": ""}',
                     '{"a": 5, "b": ""}', '{"a": [], "b": ""}', '{"a": [5, 6], "b": {}}',
                     '{"a": [5, 6], "b": "", "c": true}'):
            kept = self.run_tool(["refine"], line.encode() + b"\n")[1]["document-refine.json"]
            self.assertIn(line.encode(), kept)
        # {"a": [1, 2]}, as an array and as typed ones of integers without and with a sign and of fractions.
        forms = [bytes.fromhex(text) for text in ("a16161820102", "a16161d840420102", "a16161d848420102",
                                                  "a16161d855480000803f00000040")]
        kept = self.run_tool(["refine"], b"".join(forms))[1]["document-refine.cbor"]
        self.assertEqual(set(kept), {forms[0], *forms[2:]})
        kept = self.run_tool(["refine"], b'{"d": "' + b"x" * (16 << 20) + b'"}\n')[1]
        self.assertIn("document-refine.json.large", kept)

    def test_validation(self):
        alone = {name: value for name, value in os.environ.items() if name not in ("AJV", "ALL_KINDS")}

        def validation(documents):
            for name, document in documents.items():
                data = document if isinstance(document, bytes) else json.dumps(document).encode()
                (self.folder / "kept" / name).write_bytes(data)
            done = subprocess.run([sys.executable, here / "documents_test.py", self.folder / "kept", source],
                                  capture_output=True, text=True, env=alone)
            if done.returncode == 77:
                self.skipTest(done.stdout)
            return done

        mesh, log = example("mesh"), example("evolve_log")
        good = validation({"document-refine-1.json": mesh, "evolve_log-evolve-1.json": log,
                           "document-import-svg-1.json.large": b"2000000"})
        self.assertEqual(good.returncode, 0, good.stdout + good.stderr)
        self.assertIn("1 shapes document-import-svg-1.json.large", good.stdout)
        bad = validation({
            "document-refine-2.json": {**mesh, "degree": 1.5},
            "document-refine-3.json": {**mesh, "problem": {"version": 2}},
            "document-refine-4.json": {"a": 1},
            "evolve_log-evolve-5.json": {**log, "colour": "red"},
            "document-refine-6.json": b'{"b": ',
            "document-refine-7.cbor": b"\xa1\x61"})
        self.assertEqual(bad.returncode, 1, bad.stdout + bad.stderr)
        for number, text in ((2, "degree"), (3, "version"), (4, "no schema"), (5, "colour"), (6, "cannot be read"),
                             (7, "cannot be read")):
            self.assertRegex(bad.stdout, rf"-{number}\.(json|cbor): .*{text}")
        self.assertNotRegex(bad.stdout, r"-1\.json: ")


if __name__ == "__main__":
    sys.exit(unittest.main(verbosity=1))
