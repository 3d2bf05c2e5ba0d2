#!/usr/bin/env python3
# Runs every example of every man page as it is printed, on the inputs that ship in samples/examples.
import os
import re
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

SKIPPED = 77
source = Path(sys.argv[1])
failures = 0


def fail(text):
    global failures
    failures += 1
    print("FAIL:", text, file=sys.stderr)


def printed(page, form):
    """The page as `man` shows it, without overstriking."""
    text = subprocess.run(["mandoc", "-T", form, "-O", "width=200", page], capture_output=True, check=True).stdout
    return re.sub(".\b", "", text.decode())


def examples_of(text):
    """Pairs of a command and the lines printed behind it, of the section EXAMPLES."""
    found = re.search(r"^EXAMPLES$(.*?)^\S", text, re.M | re.S)
    pairs = []
    goes_on = False
    for line in found.group(1).splitlines() if found else []:
        if not line.startswith(" " * 11):
            goes_on = False
            continue
        line = line[11:]
        if line.startswith("$ "):
            pairs.append([line[2:], []])
        elif goes_on:
            pairs[-1][0] += "\n" + line
        elif pairs:
            pairs[-1][1].append(line)
        else:
            fail(f"an example does not start with '$ ': {line}")
            continue
        goes_on = (goes_on or line.startswith("$ ")) and line.rstrip().endswith(("\\", "|"))
    return pairs


def missing_program(command):
    words = re.findall(r"(?:^|[|;&\n]|\bdo)\s*([a-z][\w-]*)", command.replace("\\\n", " "))
    return next((w for w in words if w not in ("for", "do", "done") and shutil.which(w) is None), None)


def run_page(page):
    text = printed(page, "ascii")
    if printed(page, "utf8") != text and not printed(page, "utf8").isascii():
        in_examples = printed(page, "utf8").partition("\nEXAMPLES\n")[2].partition("\nSEE ALSO\n")[0]
        for line in in_examples.splitlines():
            if line.startswith(" " * 11) and not line.isascii():
                fail(f"{page.name}: what a terminal shows is not what must be typed: {line}")
    with tempfile.TemporaryDirectory() as folder:
        for example in (source / "samples/examples").iterdir():
            shutil.copy(example, folder)
        count = 0
        for command, output in examples_of(text):
            missing = missing_program(command)
            if missing:
                print(f"{page.name}: {missing} is missing, so the rest of the page is not run")
                break
            done = subprocess.run(["bash", "-c", "set -o pipefail\n" + command], cwd=folder, capture_output=True, timeout=120)
            count += 1
            if done.returncode != 0:
                fail(f"{page.name}: status {done.returncode} of\n{command}\n{done.stderr.decode()[:600]}")
            if output and done.stdout.decode().splitlines() != output:
                fail(f"{page.name}: another output is printed for\n{command}\nthan\n{done.stdout.decode()[:600]}")
        return count


if shutil.which("mandoc") is None:
    sys.exit(SKIPPED)
same = ["samples/examples/cells.json", "samples/three-cells/cells.json"]
if len({(source / name).read_bytes() for name in same}) != 1:
    fail(" and ".join(same) + " differ")
for page in sorted(source.glob("man/*.1")):
    if shutil.which(page.stem) is None:
        print(f"{page.stem} is not built")
        continue
    if run_page(page) == 0:
        fail(f"{page.name} has no example that runs")
sys.exit(1 if failures else 0)
