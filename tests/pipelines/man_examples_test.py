#!/usr/bin/env python3
# Runs every command that any man page shows, as it is printed and in the order of the page, in a copy of samples/examples.
# Where EVERY_PROGRAM is set, nothing may be missing; else a command of another program is left out, with what needs its files.
import os
import pathlib
import re
import shlex
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

SKIPPED = 77
source = Path(sys.argv[1])
failures = 0
must_run_all = "EVERY_PROGRAM" in os.environ
tools = set(os.environ["TOOLS"].split())


def fail(text):
    global failures
    failures += 1
    print("FAIL:", text, file=sys.stderr)


def printed(page, form):
    """The page as `man` shows it, without overstriking."""
    text = subprocess.run(["mandoc", "-T", form, "-O", "width=200", page], capture_output=True, check=True).stdout
    return re.sub(".\b", "", text.decode())


def examples_of(text):
    """Pairs of a command and the lines printed behind it, in the order of the page: displays that begin with "$ "."""
    pairs = []
    goes_on = is_display = False
    for line in text.splitlines():
        if not line.startswith(" " * 11):
            goes_on = is_display = False
            continue
        line = line[11:]
        if line.startswith("$ "):
            pairs.append([line[2:], []])
            is_display = True
        elif goes_on:
            pairs[-1][0] += "\n" + line
        elif is_display:
            pairs[-1][1].append(line)
        goes_on = is_display and is_open(pairs[-1][0])
    return pairs


def is_open(command):
    """Whether the next line belongs to the command: it ends with \\ or |, or in a quotation."""
    if command.rstrip().endswith(("\\", "|")):
        return True
    try:
        shlex.split(command)
    except ValueError:
        return True
    return False


def unmarked(page):
    """Lines of literal displays, of any section, that are commands of ours but do not begin with "$ "."""
    for block in re.findall(r"^\.Bd -literal.*?\n(.*?)^\.Ed", page.read_text(), re.M | re.S):
        words = block.split()
        if words and words[0] in tools:
            yield block.splitlines()[0]


def words_of(command):
    """The words as the shell has them; |, >, ; and such are words of their own."""
    lexer = shlex.shlex(command.replace("\\\n", " "), posix=True, punctuation_chars=True)
    lexer.whitespace_split = True
    return list(lexer)


def missing_program(command):
    words = words_of(command)
    starts = [words[k] for k in range(len(words)) if k == 0 or words[k - 1] in ("|", ";", "&&", "do")]
    return next((w for w in starts if w not in ("for", "do", "done") and shutil.which(w) is None), None)


def written(command):
    """The files that a command makes."""
    pairs = zip(words_of(command), words_of(command)[1:])
    return {file for before, file in pairs if before in (">", "-o", "--output", "--report", "--csv", "--history", "--log")
            and not file.startswith(("/dev/", "-"))}


def run_page(page):
    text = printed(page, "ascii")
    if printed(page, "utf8") != text and not printed(page, "utf8").isascii():
        for line in printed(page, "utf8").splitlines():
            if line.startswith(" " * 11 + "$ ") and not line.isascii():
                fail(f"{page.name}: what a terminal shows is not what must be typed: {line}")
    for line in unmarked(page):
        fail(f"{page.name}: a command in a display of its own begins with '$ ', so that it is run here: {line}")
    with tempfile.TemporaryDirectory() as folder:
        for example in (source / "samples/examples").iterdir():
            shutil.copy(example, folder)
        count = 0
        absent = set()  # files that a command without its program would have made
        for command, output in examples_of(text):
            missing = missing_program(command)
            lacking = absent & set(words_of(command))
            if missing in tools or (missing and must_run_all):
                fail(f"{page.name}: {missing} is missing for\n{command}")
            if missing or lacking:
                print(f"{page.name}: {missing or ', '.join(lacking)} is missing, so this is not run: {command}")
                absent |= written(command)
                continue
            done = subprocess.run(["bash", "-c", "set -o pipefail\n" + command], cwd=folder, capture_output=True, timeout=240)
            count += 1
            if done.returncode != 0:
                fail(f"{page.name}: status {done.returncode} of\n{command}\n{done.stderr.decode()[:600]}")
            if output and done.stdout.decode().splitlines() != output:
                fail(f"{page.name}: another output is printed for\n{command}\nthan\n{done.stdout.decode()[:600]}")
            for file in written(command):
                made = pathlib.Path(folder, file)
                if "$" not in file and not made.exists():
                    fail(f"{page.name}: there is no {file} after\n{command}")
        print(f"{page.name}: {count} commands")
        return count, len(examples_of(text))


if shutil.which("mandoc") is None:
    sys.exit(SKIPPED)
same = ["samples/examples/cells.json", "samples/three-cells/cells.json"]
if len({(source / name).read_bytes() for name in same}) != 1:
    fail(" and ".join(same) + " differ")
for page in sorted(source.glob("man/*.[15]")):
    if page.suffix == ".1" and shutil.which(page.stem) is None:
        print(f"{page.stem} is not built")
        continue
    ran, shown = run_page(page)
    if page.suffix == ".1" and (shown == 0 or (must_run_all and ran != shown)):
        fail(f"{page.name}: {ran} of {shown} commands run")
sys.exit(1 if failures else 0)
