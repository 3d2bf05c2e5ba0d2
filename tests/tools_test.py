#!/usr/bin/env python3
"""Each tool is told of wherever tools are listed: a program, a man page, a row in the README; each stage has its entry in
the table of stages. The environment may hold TOOLS, the names of the programs that CMake builds."""
import os
import pathlib
import re
import sys
import unittest

ROOT = pathlib.Path(__file__).resolve().parent.parent


def read(path):
    return (ROOT / path).read_text(encoding="utf-8")


def tools():
    """The tools that there are: each has a source with its name at the top of tools/."""
    return {file.stem for file in (ROOT / "tools").glob("*.cpp")}


def rows(page):
    """The tools that have a row in the README's section of tools, as a list: a tool that stands twice is there twice."""
    section = page.split("\n## The tools\n")[1].split("\n## ")[0]
    return re.findall(r"^\| `([\w-]+)` \| \S.* \|$", section, re.MULTILINE)


def stages(table):
    """The names and the classes of the stages in the text of tools/stages/table.cpp."""
    return re.findall(r'Entry\{"(\w+)", make<(\w+)>\}', table)


class Tools(unittest.TestCase):
    def test_there_are_tools(self):
        self.assertGreater(len(tools()), 10)

    @unittest.skipUnless("TOOLS" in os.environ, "CMake tells the programs")
    def test_each_source_of_a_tool_is_a_program_that_is_built(self):
        self.assertEqual(sorted(tools()), sorted(os.environ["TOOLS"].split()))

    def test_each_tool_has_a_man_page_and_each_man_page_a_tool(self):
        self.assertEqual(sorted(tools()), sorted(page.stem for page in (ROOT / "man").glob("*.1")))

    def test_each_tool_has_one_row_in_the_readme(self):
        self.assertEqual(sorted(tools()), sorted(rows(read("README.md"))))

    def test_each_stage_has_an_entry_in_the_table_and_is_a_tool(self):
        headers = "".join(file.read_text(encoding="utf-8") for file in sorted((ROOT / "tools/stages").glob("*.h")))
        entries = stages(read("tools/stages/table.cpp"))
        self.assertGreater(len(entries), 4)
        self.assertEqual(sorted(re.findall(r"class (\w+) (?:final )?: public Stage\b", headers)),
                         sorted(made for _, made in entries))
        self.assertLessEqual({name for name, _ in entries}, tools())

    def test_rows_are_those_of_the_section_and_say_something(self):
        page = "# P\n| `a` | b |\n## The tools\n| tool | does |\n| `c-d` | makes e |\n| `f` | |\n\n## Next\n| `g` | h |\n"
        self.assertEqual(["c-d"], rows(page))


if __name__ == "__main__":
    sys.exit(unittest.main(verbosity=1))
