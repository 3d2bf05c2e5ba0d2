# Sourced by each case: checks that count, a scratch directory, sample documents, and what each tool needs to run.
# The environment holds TOOLS (the names of all tools), PATH with them and with the programs of this folder, and SOURCE
# (the root of the repository).
set -uo pipefail
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
cd "$scratch" || exit 1
failures=0

fail() {
  echo "FAIL: $*" >&2
  failures=$((failures + 1))
}
finish() {
  ((failures == 0)) || { echo "$failures checks failed" >&2; exit 1; }
  exit 0
}

# run STATUS COMMAND...: runs it with its output in `out` and its messages in `err`, and checks the status.
run() {
  local expected=$1 status=0
  shift
  "$@" >out 2>err || status=$?
  ((status == expected)) || fail "status $status, not $expected: $* ($(head -c 300 err))"
}
# says TEXT: the last run's messages hold the text.
says() { grep -qF -- "$1" err || fail "expected '$1' in the message: $(head -c 400 err)"; }
silent() { [ ! -s err ] || fail "expected no message: $(head -c 400 err)"; }
no_output() { [ ! -s out ] || fail "expected no output: $(head -c 100 out)"; }
# same A B: the files hold the same bytes.
same() { cmp -s "$1" "$2" || fail "$1 and $2 differ"; }

# The tools that are tested: those that were built.
built=()
for tool in $TOOLS; do
  if command -v "$tool" >/dev/null; then built+=("$tool"); else echo "$tool is not built" >&2; fi
done
has_tool() { [[ " ${built[*]} " == *" $1 "* ]]; }
# The tools that run a stage, so that each reads meshes and writes meshes: the test's own, and all that were built.
mesh_filters=(passthrough)
mapfile -t stages < <(stage_names)
((${#stages[@]} > 0)) || { echo "stage_names names no stage" >&2; exit 1; }
for tool in "${stages[@]}"; do
  if has_tool "$tool"; then mesh_filters+=("$tool"); fi
done
# What a tool must be told beside its input, one word a line.
needs() {
  case $1 in
    advect) printf '%s\n' --dt 0.01 --vx 0 --vy 0 ;;
    diffuse | navierstokes) printf '%s\n' --problem "$scratch/problem.json" --dt 0.01 ;;
    measure) printf '%s\n' --face '*:area' --csv /dev/null ;;
  esac
}
# filter TOOL [ARGUMENTS...]
filter() {
  local tool=$1
  shift
  local -a required
  mapfile -t required < <(needs "$tool")
  "$tool" "${required[@]}" "$@"
}

echo '{"format": "pliant-problem", "version": 1, "diffuse": {"field": "c", "materials": {"*": {}}, "initial": 1},
  "navierstokes": {"materials": {"*": {"viscosity": 1}}, "conditions": [{"curve": "*", "velocity": [0, 0]}]}}' >problem.json
sample_mesh disk 2 >disk.json
sample_mesh three 2 >three.json
sample_mesh tangled 2 >tangled.json
for time in 0 1 2 3; do sample_mesh disk 2 "$time"; done >series.jsonl
