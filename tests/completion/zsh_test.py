#!/usr/bin/env python3
"""Completion in zsh: Tab pressed in a terminal, with the functions found by their names on fpath. The environment holds
TOOLS; the tools are on the PATH."""
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

# Lists what would be offered, in place of offering it: options by their beginnings, as zsh takes them from _arguments.
START = SHOW + r"""
PS1='$ ' PS2='> ' PROMPT_SP='' PROMPT_CR=''
unsetopt zle_bracketed_paste prompt_sp
fpath=($PWD/functions $fpath)
autoload -Uz compinit && compinit -u -D
zstyle ':completion:*' insert-tab false
bindkey -e
setopt no_beep no_list_ambiguous
"""


class Typed(InEveryShell, unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.scratch = tempfile.TemporaryDirectory()
        cls.folder = pathlib.Path(cls.scratch.name)
        names.write(cls.folder)
        (cls.folder / "functions").mkdir()
        for tool in TOOLS:
            script = subprocess.run([tool, "--completion", "zsh"], capture_output=True, check=True).stdout
            (cls.folder / "functions" / ("_" + tool)).write_bytes(script)
        (cls.folder / "start.zsh").write_text(START)
        cls.terminal = Terminal(["zsh", "-f", "-i"], cls.folder, {"PS1": "$ "})
        cls.terminal.run("source ./start.zsh; rm start.zsh")

    @classmethod
    def tearDownClass(cls):
        cls.terminal.close()
        cls.scratch.cleanup()

    def check(self, line, *words):
        self.assertEqual(self.terminal.arguments(line), list(words), line)

    def test_scripts_are_zsh(self):
        for tool in TOOLS:
            done = subprocess.run(["zsh", "-n", self.folder / "functions" / ("_" + tool)], capture_output=True)
            self.assertEqual((done.returncode, done.stderr), (0, b""), tool)

    def test_every_option_of_every_tool(self):
        """Each long option completes, typed but for its last letter, to itself or to a longer one."""
        for tool in TOOLS:
            text = subprocess.run([tool, "--help"], capture_output=True, text=True, check=True).stdout
            options = re.findall(r"^  (?:-\w,)?(--[\w-]+)", text.partition("\nOptions:\n")[2], re.M)
            self.assertGreater(len(options), 5)
            for option in options:
                got = self.terminal.arguments(f"{tool} {option[:-1]}")
                self.assertEqual(len(got), 2, (tool, option, got))
                self.assertTrue(got[1].rstrip("=") == option or any(o.startswith(got[1]) for o in options if o != option),
                                (tool, option, got))

    def test_choices(self):
        self.check("export-msh --format msh2", "export-msh", "--format", "msh22")
        self.check("export-msh --format=msh2", "export-msh", "--format=msh22")
        self.check("coarsen --thin k", "coarsen", "--thin", "keep")

    def test_flows(self):
        self.check("advect --flow cyl", "advect", "--flow", "cylinder")

    def test_files(self):
        self.check("import-svg dr", "import-svg", "drawing.svg")
        self.check("evolve refine mes", "evolve", "refine", "mesh.json")
        self.check("diffuse --problem pro", "diffuse", "--problem", "problem.json")
        self.check("diffuse --problem problem.json --set ra", "diffuse", "--problem", "problem.json", "--set", "rate=")

    def test_nothing_where_a_number_is_wanted(self):
        self.check("refine --max-area me", "refine", "--max-area", "me")
        self.check("evolve me", "evolve", "me")


if __name__ == "__main__":
    sys.exit(unittest.main(verbosity=1))
