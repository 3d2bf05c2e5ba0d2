#!/usr/bin/env bash
# Archives and compressed files that are not read are named with what unpacks them; what decompresses to very much ends.
. "${BASH_SOURCE%/*}/../common.bash"

tar -cf disk.tar disk.json
gzip -c disk.tar >disk.tgz
gzip -c disk.json | gzip -c >twice.gz
python3 - <<'PYTHON'
import bz2
import lzma
import zipfile

document = open("disk.json", "rb").read()
open("disk.bz2", "wb").write(bz2.compress(document))
open("disk.xz", "wb").write(lzma.compress(document))
open("disk.lzma", "wb").write(lzma.compress(document, lzma.FORMAT_ALONE))
with zipfile.ZipFile("disk.zip", "w", zipfile.ZIP_DEFLATED) as archive:
    archive.write("disk.json")
for name, magic in (("lz4", b"\4\"M\x18"), ("Z", b"\x1f\x9d\x90"), ("7z", b"7z\xbc\xaf\x27\x1c"), ("rar", b"Rar!\x1a\7")):
    open("disk." + name, "wb").write(magic + document)
PYTHON
tools=(passthrough)
for tool in bspline2mesh import-svg import-msh qualityreport; do
  if has_tool "$tool"; then tools+=("$tool"); fi
done
while read -r file words; do
  for tool in "${tools[@]}"; do
    run 3 "$tool" "$file"
    says "$tool: $file: this is $words"
    no_output
    run 3 "$tool" - <"$file"
    says "$tool: standard input: this is $words"
  done
done <<'WORDS'
disk.tar a tar archive: extract its files first, by tar -xf FILE
disk.tgz a tar archive: extract its files first, by tar -xf FILE
twice.gz a file that was compressed twice: decompress it once, by gzip -dc FILE or zstd -dc FILE, and give that to the tool
disk.bz2 a file that bzip2 compressed: bzip2 -dc FILE | TOOL reads it
disk.xz a file that xz compressed: xz -dc FILE | TOOL reads it
disk.lzma a file that lzma compressed: xz -dc FILE | TOOL reads it
disk.lz4 a file that lz4 compressed: lz4 -dc FILE | TOOL reads it
disk.Z a file that compress made (.Z): gzip -dc FILE | TOOL reads it
disk.zip a zip archive: extract its files first, by unzip FILE
disk.7z a 7z archive: extract its files first, by 7z x FILE
disk.rar a rar archive: extract its files first
WORDS
run 0 passthrough <(gzip -dc twice.gz)
same out disk.json

# A small file that decompresses to more than memory holds: the file, the place, and no trace of the system's own words.
{ printf '{"format":"pliant-mesh","points":['; head -c 200000000 /dev/zero; } | gzip -1 >mesh.gz
{ printf '$MeshFormat\n'; head -c 200000000 /dev/zero; } | gzip -1 >msh.gz
head -c 200000000 /dev/zero | gzip -1 >zeros.gz
# within STATUS TOOL FILE: runs it with little memory.
within() {
  local expected=$1 status=0
  shift
  (ulimit -v 200000; exec "$@") >out 2>err || status=$?
  ((status == expected)) || fail "status $status, not $expected, with little memory: $* ($(head -c 300 err))"
  no_output
}
if (ulimit -v 200000 && passthrough disk.json >out 2>err); then
  within 4 passthrough mesh.gz
  says 'passthrough: mesh.gz:1: frame 0: the document that begins here has not ended after '
  says ' MB of what gzip had compressed, and there is no memory for more: a smaller one is wanted'
  within 4 passthrough msh.gz
  says 'passthrough: msh.gz: the file has not ended after '
  # What is no document takes no memory.
  within 3 passthrough zeros.gz
  says 'passthrough: zeros.gz:1: frame 0: '
  if has_tool import-svg; then
    within 3 import-svg zeros.gz
    says 'import-svg: zeros.gz: is longer than '
    says ' MB once gzip decompresses it, and there is no memory for more'
  fi
fi
finish
