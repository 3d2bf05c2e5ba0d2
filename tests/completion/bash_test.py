#!/usr/bin/env python3
"""Completion in bash: every option of every tool, choices, files, and names with any characters, by calling the function
as bash does and by pressing Tab in a terminal. The environment holds TOOLS; the tools are on the PATH."""
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

import names
from terminal import SHOW, Terminal
from typed import InEveryShell

TOOLS = os.environ["TOOLS"].split()
LOAD = 'for tool in $TOOLS; do source <("$tool" --completion bash) || exit 9; done\n'


def options_of(tool):
    lines = subprocess.run([tool, "--help"], capture_output=True, text=True, check=True).stdout.partition("\nOptions:\n")[2]
    return {name for line in lines.splitlines() for name in re.findall(r"^  (-\S+)", line)[:1] for name in re.sub("{.*?}", "", name).split(",")}


class Case(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.scratch = tempfile.TemporaryDirectory()
        cls.folder = pathlib.Path(cls.scratch.name)
        names.write(cls.folder)

    @classmethod
    def tearDownClass(cls):
        cls.scratch.cleanup()

    def bash(self, script, shell="bash"):
        done = subprocess.run([shell, "--norc", "--noprofile", "-c", LOAD + script], cwd=self.folder, capture_output=True,
                              env={**os.environ, "LC_ALL": "C.UTF-8"})
        self.assertEqual((done.stderr.decode(), done.returncode), ("", 0))
        return done.stdout.decode()


class Called(Case):
    """The function, called with the words as they are."""

    def replies(self, *words, at=None, bare=True, tool=None):
        """What bash would put in place of the last word; `bare` takes the quotes off. `tool` is what an alias stands for."""
        at = len(words) - 1 if at is None else at
        quoted = " ".join("'" + word.replace("'", "'\\''") + "'" for word in words)
        function = "_pliant_" + (tool or words[0]).replace("-", "_")
        end = 'eval "COMPREPLY=(${COMPREPLY[*]})"\n' if bare else ""
        return self.bash(f"COMP_WORDS=({quoted}) COMP_CWORD={at}\n{function}\n{end}"
                         "((${#COMPREPLY[@]})) && printf '%s\\0' \"${COMPREPLY[@]}\"; true").split("\0")[:-1]

    def test_scripts_are_bash(self):
        for tool in TOOLS:
            script = subprocess.run([tool, "--completion", "bash"], capture_output=True, check=True).stdout
            done = subprocess.run(["bash", "-n"], input=script, capture_output=True)
            self.assertEqual((done.returncode, done.stderr), (0, b""), tool)

    def test_every_option_of_help_is_offered_and_nothing_else(self):
        for tool in TOOLS:
            wanted = options_of(tool)
            self.assertGreater(len(wanted), 7)
            self.assertEqual(set(self.replies(tool, "-")), wanted, tool)

    def test_options_by_their_beginning(self):
        self.assertEqual(self.replies("refine", "--max-t"), ["--max-turning", "--max-triangles"])
        self.assertEqual(self.replies("refine", "--fa"), ["--face-area"])

    def test_an_option_that_was_given_is_not_offered_again_unless_it_may_be(self):
        self.assertEqual(self.replies("refine", "--min-angle", "20", "--min-"), ["--min-size"])
        self.assertEqual(self.replies("refine", "--min-angle=20", "--min-"), ["--min-size"])
        self.assertEqual(self.replies("refine", "--face-area", "a=1", "--fa"), ["--face-area"])

    def test_no_options_after_two_dashes(self):
        self.assertEqual(self.replies("refine", "--", "-"), [])
        self.assertEqual(self.replies("refine", "--", "mesh"), ["mesh.json"])

    def test_choices(self):
        self.assertEqual(self.replies("export-msh", "--format", ""), ["msh41", "msh22"])
        self.assertEqual(self.replies("export-msh", "--format=msh2"), ["--format=msh22"])
        self.assertEqual(self.replies("export-msh", "--format", "=", "msh2"), ["msh22"])
        self.assertEqual(self.replies("qualityreport", "--format", "h"), ["html"])
        self.assertEqual(self.replies("coarsen", "--thin", ""), ["keep", "refine"])
        self.assertEqual(self.replies("advect", "--method", ""), ["euler", "midpoint", "rk4", "dopri5"])
        self.assertIn("magma", self.replies("export-svg", "--colormap", ""))
        self.assertEqual(self.replies("refine", "--completion", ""), ["bash", "zsh"])

    def test_nothing_where_a_number_or_a_text_is_wanted(self):
        for words in (["refine", "--max-area", ""], ["refine", "--size", "m"], ["qualityreport", "--title", ""],
                      ["advect", "--vx=", ], ["evolve", ""]):
            self.assertEqual(self.replies(*words), [], words)

    def test_files(self):
        documents = {"mesh.json", "in lines.json", "series.jsonl", "cut.json", "boundary.json", "problem.json", "folder"}
        self.assertEqual(set(self.replies("refine", "", bare=False)), documents)
        self.assertEqual(set(self.replies("import-svg", "", bare=False)), {"drawing.svg", "folder"})
        self.assertEqual(self.replies("refine", "-o", "no"), ["notes.txt"])
        self.assertEqual(self.replies("refine", "-ono"), ["-onotes.txt"])
        self.assertEqual(self.replies("refine", "--output=no"), ["--output=notes.txt"])
        self.assertEqual(self.replies("import-svg", "no"), ["notes.txt"])  # no drawing begins so
        self.assertEqual(self.replies("evolve", "refine", "mesh"), ["mesh.json"])
        self.assertEqual(self.replies("evolve", "--step", "step.txt", "mesh"), ["mesh.json"])
        self.assertEqual(self.replies("diffuse", "--problem", "pro"), ["problem.json"])

    def test_names_of_the_input(self):
        areas = [face + "=" for face in names.FACES]
        for file in ("mesh.json", "in lines.json", "series.jsonl", "cut.json"):
            self.assertEqual(self.replies("refine", file, "--face-area", ""), areas, file)
            self.assertEqual(self.replies("refine", "--face-area", "", file, at=2), areas, file)
        self.assertEqual(self.replies("bspline2mesh", "boundary.json", "--face-area", "pl"), ["plain="])
        self.assertEqual(self.replies("bspline2mesh", "boundary.json", "--face-area=pl"), ["--face-area=plain="])
        self.assertEqual(self.replies("qualityreport", "--face", "", "mesh.json", at=2), names.FACES)
        self.assertEqual(self.replies("refine", "-q", "--min-angle", "20", "mesh.json", "--size-field", ""), names.FIELDS)
        self.assertEqual(self.replies("advect", "--velocity-field", "v", "mesh.json", at=2), ["velocity"])
        self.assertEqual(self.replies("measure", "mesh.json", "--curve", ""), ["outline:", "inner wall:", "*:"])
        self.assertEqual(self.replies("measure", "mesh.json", "--face", "plain:a"), [])
        self.assertEqual(self.replies("diffuse", "--set", "", "mesh.json", at=2), ["conductivity="])
        self.assertEqual(self.replies("diffuse", "--set", "", "--problem", "problem.json", at=2), ["k=", "rate="])
        self.assertEqual(self.replies("advect", "--flow", "mesh.json", "--flow-field", "t"), ["temperature"])
        self.assertEqual(self.replies("evolve", "refine", "mesh.json", "--completion", "z"), ["zsh"])
        self.assertEqual(self.replies("export-svg", "--color", "field:", "mesh.json", at=2),
                         ["field:" + field for field in names.FIELDS])
        self.assertIn("shape", self.replies("export-svg", "--color", "sh"))
        self.assertEqual(self.replies("advect", "mesh.json", "--field", "temperature@pl"), ["temperature@plain="])

    def test_an_alias_asks_the_tool_that_it_stands_for(self):
        for tool in ("advect", "refine"):
            self.assertIn("--face" if tool == "refine" else "--flow", " ".join(self.replies("short", "--f", tool=tool)))
        self.assertEqual(self.replies("short", "--velocity-field", "v", "mesh.json", at=2, tool="advect"), ["velocity"])
        self.assertEqual(self.replies("short", "mesh.json", "--size-field", "te", tool="refine"), ["temperature"])

    def test_flows(self):
        text = subprocess.run(["advect", "--flow", "help"], capture_output=True, text=True, check=True).stdout
        flows = set(re.findall(r"^(\w+)$", text, re.M))
        self.assertGreater(len(flows), 3)
        self.assertLessEqual(flows, set(self.replies("advect", "--flow", "")))
        self.assertIn("cylinder:radius=", self.replies("advect", "--flow", "cylinder:"))
        self.assertNotIn("cylinder:radius=1,radius=", self.replies("advect", "--flow", "cylinder:radius=1,"))
        self.assertEqual(self.replies("advect", "--flow", "mesh"), ["mesh.json"])

    def test_no_input_no_names_and_nothing_is_waited_for(self):
        os.mkfifo(self.folder / "pipe")
        try:
            for file in ("pipe", "missing.json", "notes.txt", "-", "folder"):
                self.assertEqual(self.replies("refine", file, "--face-area", ""), [], file)
        finally:
            (self.folder / "pipe").unlink()

    def test_words_are_never_run(self):
        self.replies("refine", "$(touch ran)", "`touch ran`", "--face-area", "$(touch ran)")
        self.assertFalse((self.folder / "ran").exists())


class Typed(InEveryShell, Case):
    """Tab in a terminal: what stands on the line afterwards is what the tool would be given."""

    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.terminals = []
        for start in ("", "source /usr/share/bash-completion/bash_completion\n"):
            if start and not os.path.exists(start.split()[1]):
                continue
            terminal = Terminal(["bash", "--norc", "--noprofile", "-i"], cls.folder, {"PS1": "$ ", "PS2": "> "})
            (cls.folder / "start.sh").write_text("bind 'set enable-bracketed-paste off'\n" + start + LOAD + SHOW)
            terminal.run("source ./start.sh; rm start.sh")
            cls.terminals.append(terminal)

    @classmethod
    def tearDownClass(cls):
        for terminal in cls.terminals:
            terminal.close()
        super().tearDownClass()

    def check(self, line, *words):
        for terminal in self.terminals:
            self.assertEqual(terminal.arguments(line), list(words), line)

    def test_a_dollar_in_quotes(self):
        self.check('qualityreport mesh.json --face "$HO'.replace("$", "\\$"), "qualityreport", "mesh.json", "--face", "$HOME")

    def test_unquoted_beginnings_with_characters_at_which_bash_cuts(self):
        self.check("qualityreport mesh.json --face a=", "qualityreport", "mesh.json", "--face", "a=b")
        self.check("qualityreport mesh.json --face x:", "qualityreport", "mesh.json", "--face", "x:y")
        self.check("export-svg mesh.json --color=field:tem", "export-svg", "mesh.json", "--color=field:temperature")
        self.check("advect --flow=cylinder:rad", "advect", "--flow=cylinder:radius=")
        self.check("advect mesh.json --field temperature@pl", "advect", "mesh.json", "--field", "temperature@plain=")

    def test_an_input_in_quotes(self):
        self.check("refine 'in lines.json' --size-field tem", "refine", "in lines.json", "--size-field", "temperature")


if __name__ == "__main__":
    sys.exit(unittest.main(verbosity=1))
