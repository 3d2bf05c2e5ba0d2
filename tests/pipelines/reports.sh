#!/usr/bin/env bash
# --report writes a JSON line a frame, -v says it, and neither touches the result.
. "${BASH_SOURCE%/*}/common.bash"

for tool in "${mesh_filters[@]}"; do
  filter "$tool" series.jsonl >plain.jsonl
  run 0 filter "$tool" series.jsonl --report report.jsonl
  silent
  same out plain.jsonl
  python3 - "$tool" <<'PYTHON' || fail "$tool: the report is not as documented: $(head -n 1 report.jsonl)"
import json, sys
lines = [json.loads(line) for line in open("report.jsonl")]
assert len(lines) == 4
for number, line in enumerate(lines):
    assert line["tool"] == sys.argv[1] and line["frame"] == number
    assert set(line) == {"tool", "frame", "time", "values", "refusals", "refused_at", "notes", "before", "after",
                         "missed_before", "missed_after", "growth", "seconds"}
    for missed in line["missed_before"], line["missed_after"]:
        assert set(missed) == {"invalid", "turned_over", "too_curved", "too_large", "too_poor"}
    assert all(isinstance(value, (int, float)) for value in line["values"].values())
    assert all(isinstance(value, int) and value > 0 for value in line["refusals"].values())
    for refused in line["refused_at"]:
        assert set(refused) == {"reason", "x", "y"} and refused["reason"] in line["refusals"]
    for reason, times in line["refusals"].items():
        places = sum(refused["reason"] == reason for refused in line["refused_at"])
        assert places <= 1000 and places in (0, times, 1000)
    assert set(line["seconds"]) == {"read", "check", "pass", "write", "quality"}
PYTHON
  run 0 filter "$tool" -v series.jsonl
  same out plain.jsonl
  says "$tool: frame 3, time "
done
run 0 passthrough -v disk.json
says 'passthrough: frame 0, time 0: triangles 24, half 0.5, '
says '  refused 3 times: would "invert"'
says '  refused 1200 times: too far, at (0.5, -2), (1.5, -2), (2.5, -2), ...'
says '  nothing was done'
says '  before: 24 triangles, 0 not valid, least logical angle '
says '  after: 24 triangles, 0 not valid, least logical angle '
says '  fields grew at most by: largest |u| 1 ('

# Before and after are what qualityreport says of input and output, and growth is their ratio.
if has_tool qualityreport; then
  sample_mesh three 3 >>series.jsonl
  for tool in "${mesh_filters[@]}"; do
    filter "$tool" series.jsonl --report report.jsonl >out.jsonl
    qualityreport --format json series.jsonl >before.jsonl
    qualityreport --format json out.jsonl >after.jsonl
    python3 - <<'PYTHON' || fail "$tool: before and after are not what qualityreport says"
import json
lines = {name: [json.loads(line) for line in open(name + ".jsonl")] for name in ("report", "before", "after")}
assert len(lines["report"]) == len(lines["after"]) == 5
for number, report in enumerate(lines["report"]):
    for when in "before", "after":
        said, measured = report[when], lines[when][number]
        metrics = measured["metrics"] if "metrics" in measured else measured
        for name in "triangles", "invalid", "degenerate":
            assert said[name] == measured[name], name
        for name in "logical_angle", "scaled_jacobian", "shape":
            assert said["min_" + name] == metrics[name]["min"], name
        assert said["max_distortion"] == metrics["distortion"]["max"]
        largest = [max(-low, high) for field in measured["fields"] for low, high in zip(field["min"], field["max"])]
        assert [field["largest"] for field in said["fields"]] == largest and largest
    for growth, was, now in zip(report["growth"], report["before"]["fields"], report["after"]["fields"]):
        assert growth["name"] == was["name"] == now["name"] and growth["component"] == was["component"]
        assert growth["largest"] == now["largest"] / was["largest"] and growth["l2"] == now["l2"] / was["l2"]
PYTHON
  done
fi

# documented TOOL REPORT [PAGE...]: the man page of the tool, or a page that it refers to, names each value of the
# reports; and the list of values in its section REPORT holds none that no report has.
documented() {
  python3 - "$SOURCE/man" "$@" <<'PYTHON' || fail "man/$1.1 and the values in reports of $1 differ"
import json, pathlib, re, sys
folder, tool, report, *others = sys.argv[1:]
page = (pathlib.Path(folder) / f"{tool}.1").read_text()
pages = page + "".join((pathlib.Path(folder) / f"{name}.1").read_text() for name in others)
named = set(re.findall(r"^\.(?:It )?Va (\w+)", pages, re.MULTILINE))
section = page.split(".Sh REPORT\n")[1].split("\n.Sh ")[0] if ".Sh REPORT\n" in page else ""
entries = set(re.findall(r"^\.It Va (\w+)", section, re.MULTILINE))
values = {name.split(":")[0] for line in open(report) for name in json.loads(line)["values"]}
assert values, "no report"
for fault, names in ("not documented", values - named), ("in no report", entries - values):
    if names:
        sys.exit(f"{tool}: {fault}: {', '.join(sorted(names))}")
PYTHON
}
for tool in "${stages[@]}"; do
  if ! has_tool "$tool"; then continue; fi
  case $tool in  # options that add values
    advect) more=(--keep-area) ;;
    smoothcurves) more=(--global) ;;  # refused by a build without Ceres
    *) more=() ;;
  esac
  filter "$tool" three.json --report report.jsonl >/dev/null
  filter "$tool" "${more[@]}" three.json --report more.jsonl >/dev/null 2>err && cat more.jsonl >>report.jsonl
  documented "$tool" report.jsonl
done
if has_tool bspline2mesh; then
  bspline2mesh --resolve "$SOURCE/samples/examples/overlapping.json" --report report.jsonl >/dev/null
  documented bspline2mesh report.jsonl refine
fi
if has_tool import-msh; then
  import-msh -q "$SOURCE/samples/examples/bad.msh" --report report.jsonl >/dev/null
  documented import-msh report.jsonl
fi
if has_tool import-svg; then
  import-svg --planar "$SOURCE/samples/examples/drawing.svg" --report report.jsonl >/dev/null
  documented import-svg report.jsonl
fi

# Frames that were done before a failure are reported.
run 4 passthrough --stop-at 2 series.jsonl --report report.jsonl
(($(wc -l <report.jsonl) == 2)) || fail "the report should have the two frames that were done"
finish
