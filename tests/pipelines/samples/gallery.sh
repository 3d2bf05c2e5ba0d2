#!/usr/bin/env bash
# The gallery is drawn again by its script: certified meshes, small pictures.
. "${BASH_SOURCE%/*}/../common.bash"
for file in /usr/share/openclipart/svg /usr/share/fonts/truetype/dejavu/DejaVuSans.ttf; do
  [ -e "$file" ] || { echo "$file is missing" >&2; exit 77; }
done
for tool in import-svg bspline2mesh qualityreport export-svg; do
  has_tool "$tool" || exit 77
done

run 0 "$SOURCE/samples/gallery/make" drawn
for picture in "$SOURCE"/samples/gallery/*.svg; do
  name=$(basename "$picture")
  [ -s "drawn/$name" ] || fail "$name is not drawn"
  (($(wc -c <"drawn/$name") < 60000)) || fail "$name is larger than 60 kB"
  grep -q ' 0 invalid, 0 degenerate' "drawn/$name" || fail "$name: $(grep '<desc>' "drawn/$name")"
  grep -qF "($name)" "$SOURCE/samples/gallery/README.md" || fail "$name is not in the gallery's README"
done
finish
