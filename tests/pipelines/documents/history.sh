#!/usr/bin/env bash
# --history adds the tool and the options that count to the document; all tools pass it on, and nothing else changes.
. "${BASH_SOURCE%/*}/../common.bash"
examples=$SOURCE/samples/examples

# entries FILE: the tools and options of each document, a line a document.
entries() {
  python3 -c 'import json, sys
for line in open(sys.argv[1]):
    print("; ".join(" ".join([e["tool"]] + e["options"]) for e in json.loads(line).get("history", [])))' "$1"
}
# without FILE: the documents without their histories, byte for byte.
without() { sed -E 's/,"history":\[(\{[^}]*\},?)*\]//' "$1"; }

for tool in "${mesh_filters[@]}"; do
  filter "$tool" series.jsonl >plain.jsonl
  run 0 filter "$tool" --history --report report.jsonl -q series.jsonl -o told.jsonl
  same <(without told.jsonl) plain.jsonl
  options=$(needs "$tool" | sed 's|^/dev/null$|--csv|' | sort | grep -vx -- '--csv' | paste -sd ' ')
  while read -r line; do
    [ "$(tr ' ' '\n' <<<"${line#"$tool"}" | sed '/^$/d' | sort | paste -sd ' ')" = "$options" ] ||
      fail "$tool is told as: $line"
  done < <(entries told.jsonl)
  [ "$(entries told.jsonl | wc -l)" = 4 ] || fail "$tool: not every frame has a history"
  [ "$tool" = passthrough ] || continue
  run 0 passthrough told.jsonl
  same out told.jsonl
  run 0 passthrough --history told.jsonl
  [ "$(entries out | sort -u)" = 'passthrough; passthrough' ] || fail "a second time: $(entries out)"
done

sed '1s/^{/{"history":7,/' disk.json >strange.json
run 0 passthrough strange.json
run 3 passthrough --history strange.json
says '/history'
says 'is no array'
if has_tool bspline2mesh; then
  for history in 7 '"import-svg"' '{"tool":"import-svg"}' null; do
    sed "1s/^{/{\"history\":$history,/" "$examples/disk.json" >strange.json
    run 3 bspline2mesh --history --no-refine strange.json
    says 'bspline2mesh: strange.json:1: frame 0: /history: is no array of tools'
    says '(column 12)'
    no_output
    run 0 bspline2mesh --no-refine strange.json  # the member stays that of the boundary
    grep -qF "\"history\":$history" out || fail "a member that no tool knows is kept: $history"
  done
fi

if has_tool bspline2mesh && has_tool refine && has_tool import-svg && has_tool evolve; then
  import-svg -q --history --planar --degree=3 "$examples/drawing.svg" >drawing.json
  run 0 bspline2mesh --history --face-area 'close=0.02' --min-angle 20 --face-area 'above=0.03' "$examples/cells.json"
  [ "$(entries out)" = 'bspline2mesh --min-angle 20 --face-area close=0.02 --face-area above=0.03' ] ||
    fail "options are told as: $(entries out)"
  run 0 bspline2mesh --no-refine drawing.json
  [ "$(entries out)" = 'import-svg --degree 3 --planar' ] || fail "a boundary's history: $(entries out)"
  grep -q '"history".*"history"' out && fail 'the history is there twice'
  run 0 bspline2mesh --history --no-refine drawing.json
  [ "$(entries out)" = 'import-svg --degree 3 --planar; bspline2mesh --no-refine' ] || fail "a boundary's history: $(entries out)"

  step='advect --dt 0.01 --vx 1 --vy 0 | flipdelaunay'
  bspline2mesh --history --no-refine "$examples/disk.json" >disk-mesh.json
  run 0 evolve --add-history "$step" --steps 2 --every 1 disk-mesh.json -o run.jsonl
  [ "$(entries run.jsonl | sort -u)" = "bspline2mesh --no-refine; evolve $step --every 1" ] ||
    fail "evolve is told as: $(entries run.jsonl)"
  cp run.jsonl two.jsonl
  run 0 evolve --add-history "$step" --steps 3 --every 1 --resume -o run.jsonl disk-mesh.json
  same <(head -n 3 run.jsonl) two.jsonl
  evolve --add-history "$step" --steps 3 --every 1 disk-mesh.json -o three.jsonl
  same run.jsonl three.jsonl
  echo "$step" >step
  run 0 evolve --add-history --step step --steps 3 --every 1 disk-mesh.json
  same out three.jsonl
  [ "$(entries run.jsonl | sort -u | wc -l)" = 1 ] || fail 'a resumed run has another history'
  bspline2mesh --no-refine "$examples/disk.json" | sed '1s/^{/{"history":7,/' >strange.json
  run 3 evolve --add-history "$step" --steps 1 strange.json
  says 'evolve: strange.json:1: frame 0: /history: is no array'

  # Texts of the command line that a document cannot hold; names of files are any bytes.
  bspline2mesh --no-refine --field velocity=0,0 "$examples/disk.json" >$'\xe9.json'
  run 0 advect --dt 0.01 --flow $'\xe9.json' disk-mesh.json
  run 2 advect --history --dt 0.01 --flow $'\xe9.json' disk-mesh.json
  says 'the history takes UTF-8 only'
  run 2 bspline2mesh --no-refine --field $'\xe9=1' "$examples/disk.json"
  says 'the name is not UTF-8'
fi

if has_tool qualityreport; then
  filter passthrough --history disk.json >told.json
  run 0 qualityreport --format json told.json
  python3 -c 'import json, sys
(document, report) = [json.load(open(name)) for name in sys.argv[1:]]
sys.exit(document["history"] != report["history"])' told.json out || fail 'the report has another history'
  run 0 qualityreport told.json
  tail -n 2 out | head -n 1 | grep -qx 'made by' || fail 'the report does not tell the history'
  tail -n 1 out | grep -q '^passthrough [0-9]' || fail "the report tells $(tail -n 1 out)"
  run 0 qualityreport disk.json
  grep -q 'made by' out && fail 'a report tells a history that is not there'
  run 0 qualityreport --format json disk.json
  grep -q '"history"' out && fail 'a report has a history that is not there'
fi
finish
