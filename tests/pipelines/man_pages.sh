#!/usr/bin/env bash
# Each tool has a man page that is lint clean and names every option of --help, and no others.
. "${BASH_SOURCE%/*}/common.bash"
command -v mandoc >/dev/null || { echo "mandoc is missing" >&2; exit 77; }

for tool in "${built[@]}"; do
  page=$SOURCE/man/$tool.1
  [ -e "$page" ] || { fail "man/$tool.1 is missing"; continue; }
  mandoc -T lint -W warning "$page" >lint || fail "man/$tool.1: $(head -n 3 lint)"
  mandoc -T ascii -O width=200 "$page" | col -b >text
  "$tool" --help >help
  grep -oE -- '(^|[ ,])--?[a-zA-Z][a-zA-Z-]*' help | tr -d ' ,' | sort -u >options
  while IFS= read -r option; do
    grep -qE -- "(^|[^-[:alnum:]])$option([^-[:alnum:]]|\$)" text || fail "man/$tool.1 does not name $option"
  done <options
  # The options that the page lists, on lines such as `.It Fl o , -output Ar FILE`.
  awk '/^\.It Fl/ {
    for (i = 3; i <= NF && ($i == "Fl" || $i !~ /^[A-Z]/); ++i) if ($i != "," && $i != "Fl") print "-" $i
  }' "$page" >listed
  grep -q . listed || fail "man/$tool.1 lists no option"
  while IFS= read -r option; do
    grep -qxF -e "$option" options || fail "man/$tool.1 lists $option, which $tool --help does not name"
  done <listed
done
for page in "$SOURCE"/man/*.[0-9]; do
  mandoc -T lint -W warning "$page" >lint || fail "${page##*/}: $(head -n 3 lint)"
done
finish
