#!/usr/bin/env bash
# Runs the README's pipeline word for word, on the tools of the PATH: the argument is the source folder.
set -euo pipefail
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
cd "$scratch"
ln -s "$1/samples" samples
# The indented block that starts with "set -o pipefail".
awk '/^    set -o pipefail/ { on = 1 } on && !/^    / { exit } on { print substr($0, 5) }' "$1/README.md" >pipeline
grep -q bspline2mesh pipeline
bash -eu pipeline >report
grep -Eq '^triangles .* invalid +0$' report
grep -q '<svg' next.svg
