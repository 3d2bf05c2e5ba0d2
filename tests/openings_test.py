#!/usr/bin/env python3
"""Every C++ file opens in line 1 with `// path: sentence.`, its own path from the root of the repository."""
import pathlib
import sys
import unittest

ROOT = pathlib.Path(__file__).resolve().parent.parent


def fault_of(path, text):
    """What is wrong with the opening of a file, in a sentence; None where nothing is."""
    lines = text.split("\n")
    start = f"// {path}: "
    if not lines[0].startswith(start):
        return f"{path}: line 1 should be `{start}what the file is for, in a sentence.`, not `{lines[0]}`"
    opening = []
    for line in lines:
        if not line.startswith("// "):
            break
        opening.append(line[3:])
    sentence = " ".join(opening)[len(path) + 2:].strip()
    if len(sentence) < 10 or sentence[-1] not in ".?!":
        return f"{path}: the opening should be a sentence that ends, not `{sentence}`"
    return None


class Openings(unittest.TestCase):
    def test_every_file_opens_with_its_path_and_a_sentence(self):
        files = [file for folder in ("lib", "formats", "tools", "tests") for file in sorted((ROOT / folder).rglob("*"))
                 if file.suffix in (".h", ".cpp") and "node_modules" not in file.parts]
        self.assertGreater(len(files), 300)
        faults = [fault for file in files
                  if (fault := fault_of(file.relative_to(ROOT).as_posix(), file.read_text(encoding="utf-8")))]
        self.assertEqual([], faults, "\n" + "\n".join(faults))

    def test_a_sentence_may_go_on_in_the_next_line(self):
        self.assertIsNone(fault_of("lib/a.h", "// lib/a.h: what a stranger\n// understands.\n#pragma once\n"))

    def test_other_openings_are_faults(self):
        for text in ("#pragma once  // lib/a.h: what a stranger understands.\n",
                     "#include <array>  // lib/a.h: what a stranger understands.\n",
                     "// What a stranger understands.\n",
                     "\n// lib/a.h: what a stranger understands.\n",
                     "// lib/b.h: what a stranger understands.\n",
                     "// lib/a.h: what a stranger\n#pragma once\n",
                     "// lib/a.h\n#pragma once\n",
                     ""):
            with self.subTest(text):
                self.assertIsNotNone(fault_of("lib/a.h", text))


if __name__ == "__main__":
    sys.exit(unittest.main(verbosity=1))
