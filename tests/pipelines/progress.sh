#!/usr/bin/env bash
# The progress line: on a terminal only, for long runs only, no wider than it, erased at the end.
. "${BASH_SOURCE%/*}/common.bash"
command -v script >/dev/null || exit 77

# on_terminal WIDTH COMMAND: what the command writes to a terminal of that width, in `screen`; its status.
on_terminal() {
  script -qefc "stty cols $1; $2" /dev/null >screen </dev/null
}
# drawings CHECKS: Python that looks at `lines`, the drawings of the line without their end codes, and at `screen`.
drawings() {
  python3 - "$1" <<'PYTHON' || fail "$1: $(cat -v screen | head -c 600)"
import sys
screen = open("screen", newline="").read()
parts = screen.split("\r")
lines = [part[:-3] for part in parts if part.endswith("\033[K") and len(part) > 3]
assert eval(sys.argv[1]), lines
PYTHON
}

on_terminal 60 'passthrough --naps 16 disk.json -o out.json' || fail "status $? on a terminal"
drawings 'lines and lines[0].startswith("passthrough: sleep [")'
drawings 'all(len(line) <= 59 and line.endswith(" s") for line in lines)'
drawings 'any(" naps, 1 s" in line and "#" in line and "%" in line for line in lines)'
drawings 'len(lines) <= 8'
drawings 'screen.endswith("\r\033[K")'
passthrough disk.json >plain.json
same out.json plain.json

# On a narrow terminal the line is shorter; in a series it counts frames.
on_terminal 25 'passthrough --naps 12 disk.json -o out.json'
drawings 'lines and all(len(line) == 24 and "[" not in line for line in lines)'
on_terminal 80 'passthrough --naps 4 series.jsonl >out.jsonl'
drawings 'any("2 frames, sleep [" in line for line in lines)'
drawings 'screen.endswith("\r\033[K")'

# Messages begin on a line that was erased.
on_terminal 80 'passthrough -v --naps 13 disk.json -o out.json'
drawings '"\r\033[Kpassthrough: frame 0, time 0: " in screen'
on_terminal 80 'passthrough --naps 12 --stop-at 2 series.jsonl -o out.jsonl' && fail "a failure is lost on a terminal"
drawings '"\r\033[Kpassthrough: series.jsonl: frame 2: told to stop" in screen'

# There is no progress line for short runs, on a dumb terminal, with -q, where the document goes to the same terminal, or
# where messages go to no terminal.
on_terminal 80 'passthrough disk.json -o out.json'
drawings 'screen == ""'
on_terminal 80 'TERM=dumb passthrough --naps 12 disk.json -o out.json'
drawings 'screen == ""'
on_terminal 80 'passthrough -q --naps 12 disk.json -o out.json'
drawings 'screen == ""'
on_terminal 80 'passthrough --naps 12 disk.json'
drawings 'not lines'
run 0 passthrough --naps 12 disk.json
silent
finish
