#!/usr/bin/env bash
# evolve --resume with another end or other frames gives the bytes of one run with these options; what is damaged, missing
# or left over among earlier frames is named, with what to do, and stays as it is.
. "${BASH_SOURCE%/*}/../common.bash"
for tool in evolve advect flipdelaunay refine coarsen bspline2mesh; do
  has_tool "$tool" || { echo "$tool is not built" >&2; exit 77; }
done
step='advect --vx=-y --vy=x --dt 0.1 | flipdelaunay | refine --max-area 0.2 | coarsen'
start=disk.json

# Where frames go: a series or numbered files in the folder $1; --log and --history beside them.
outputs() {
  if [ "$form" = series ]; then printf '%s\n' -o "$1/frames.jsonl"; else printf '%s\n' --frames "$1/frames/%03d.json"; fi
  printf '%s\n' --log "$1/log" --history "$1/history"
}
# evolve_in FOLDER OPTIONS...
evolve_in() {
  local -a where
  mkdir -p "$1"
  mapfile -t where < <(outputs "$1")
  run 0 evolve "${where[@]}" "${@:2}" "$step" "$start"
}
# The folder's files without what the clock says, and without the note of the options, which names those of the last run.
contents() {
  local file
  for file in "$1"/frames*; do
    if [ -d "$file" ]; then (cd "$file" && md5sum -- *.json); else md5sum <"$file"; fi
  done
  sed 's/"seconds":[^,}]*//g' "$1/log"
  awk -F, 'NR == 1 { for (k = 1; k <= NF; ++k) timed[k] = $k ~ /seconds$/ }
           { for (k = 1; k <= NF; ++k) printf "%s,", timed[k] ? "" : $k; print "" }' "$1/history"
}
same_run() { cmp -s <(contents "$1") <(contents "$2") || fail "$form, $3: not the bytes of one run"; }
# as_one FIRST... -- SECOND... [-- THIRD...]: runs with these options, the later ones resumed, equal the last one alone.
as_one() {
  for form in series numbered; do
    rm -rf parts whole
    local -a options=()
    local word resume=()
    for word in "$@" --; do
      if [ "$word" != -- ]; then options+=("$word"); continue; fi
      evolve_in parts "${options[@]}" "${resume[@]}"
      resume=(--resume)
      last=("${options[@]}")
      options=()
    done
    evolve_in whole "${last[@]}"
    same_run parts whole "$*"
    # Once more: done is done.
    cp -r parts before
    evolve_in parts "${last[@]}" --resume
    diff -r parts before >/dev/null || fail "$form, $*: a finished run changed"
    rm -rf before
  done
}

# An end that is no whole step: the step that was shortened for it is made again.
as_one --until 0.55 --every 2 -- --until 1.1 --every 2
as_one --until 0.55 -- --until 1.1
as_one --until 0.55 --every 2 -- --steps 8 --every 2
as_one --steps 3 --every 2 -- --steps 8 --every 2
as_one --steps 3 -- --until 0.75
as_one --until 0.05 -- --until 0.3
as_one --until 0.25 --every 3 -- --until 0.55 --every 3 -- --until 0.95 --every 3
as_one --until 0.3000000000001 --every 3 -- --until 0.8 --every 3
as_one --until 0.3 --every 3 -- --until 0.3000000000001 --every 3 -- --until 0.5 --every 3
as_one --until 0.25 --at 0.15,0.2 -- --until 0.5 --at 0.15,0.2
# Frames at other times, as far as those that are there are frames of both.
as_one --until 0.5 --at 0.25 -- --until 1 --at 0.25,0.75
as_one --until 0.5 --at 0.25 -- --until 0.7 --at 0.25,0.35,0.65
as_one --until 0.5 -- --until 0.7 --at 0.35,0.65
as_one --until 0.5 --at 0.25 -- --until 0.75 --at 0.25,0.5,0.75
# Steps of uneven length.
bspline2mesh --max-turning 40 --field 'velocity=-y,x' "$SOURCE/samples/examples/disk.json" >turning.json
start=turning.json even=$step
step='advect --velocity-field velocity --dt 0.3 | flipdelaunay'
as_one --until 0.5 --cfl 0.25 --every 3 -- --until 0.8 --cfl 0.25 --every 3
as_one --until 0.5 --cfl 0.25 -- --until 0.8 --cfl 0.25
as_one --steps 5 --cfl 0.25 -- --steps 9 --cfl 0.25
as_one --until 0.5 --cfl 0.25 --at 0.2 -- --until 0.8 --cfl 0.25 --at 0.2,0.6
# A flow that has become steady is at its end, until less change is asked for.
advect --dt 1e-9 --vx 0 --vy 0 --field 'velocity=1,1' disk.json >steady.json
start=steady.json step="advect --vx 0 --vy 0 --dt 0.1 --field 'velocity=exp(-20*t)+x,y'"
for every in '' '--every 1' '--every 3'; do
  # shellcheck disable=SC2086
  {
    as_one --steps 50 --until-steady 1e-3 $every
    as_one --until 0.25 --until-steady 1e-3 $every -- --until 9 --until-steady 1e-3 $every
    as_one --until 9 --until-steady 1e-3 $every -- --until 9 --until-steady 1e-5 $every
    evolve_in parts --until 9 --until-steady 1e-2 $every --resume
  }
  same_run parts whole 'a flow that is steady by less'
done
start=disk.json step=$even

# The user is told; where the note of the options is gone, it goes back all the same.
form=series
rm -rf parts whole
evolve_in whole --until 1 --every 2
evolve_in parts --until 0.55 --every 2
cp -r parts ended
evolve_in parts --until 1 --every 2 --resume
says 'goes on from the frame at time 0.4'
says 'time 0.55'
rm -rf parts && cp -r ended parts
rm parts/frames.jsonl.step
evolve_in parts --until 1 --every 2 --resume
same_run parts whole "without a note"
for note in '# evolve --every two' '# evolve --until' '# another' ''; do
  { printf '%s\n' "$note" && tail -n +2 ended/frames.jsonl.step; } >parts/frames.jsonl.step
  mapfile -t where < <(outputs parts)
  run 2 evolve "${where[@]}" --until 1 --every 2 --resume "$step" disk.json
  says 'parts/frames.jsonl.step does not tell what made the frames; remove it'
done

# A step with a line's end in quotes is compared whole.
step="advect --vx='-y
 + 0' --vy=x --dt 0.1"
as_one --until 0.25 -- --until 0.5
step=$even form=series
rm -rf whole
evolve_in whole --until 1 --every 2
# Killed where the frame is gone and the note still tells of the end before; or where the frame is half written.
rm -rf parts && cp -r ended parts
head -n 3 ended/frames.jsonl >parts/frames.jsonl
evolve_in parts --until 1 --every 2 --resume
same_run parts whole "killed after the cut"
for bytes in 1 100; do
  rm -rf parts && cp -r ended parts
  head -n 4 whole/frames.jsonl | tail -n 1 | head -c $bytes >>parts/frames.jsonl
  evolve_in parts --until 1 --every 2 --resume
  same_run parts whole "half a frame"
done

# Frames that the options choose are never removed, and a run that is refused changes nothing.
refused() { # refused TEXT OPTIONS...: status 2
  local -a where
  mapfile -t where < <(outputs parts)
  cp -r parts before
  run 2 evolve "${where[@]}" --resume "${@:2}" "$step" disk.json
  says "$1"
  diff -r parts before >/dev/null || fail "$form: a refused run changed something"
  rm -rf before
}
for form in series numbered; do
  rm -rf parts
  evolve_in parts --until 0.55 --at 0.15,0.35
  refused 'evolve --at 0.15 --at 0.35 --until 0.55' --until 1 --at 0.15
  refused 'the options that choose frames differ' --until 1 --at 0.15,0.25,0.35
  refused 'the options that choose frames differ' --until 1 --at 0.25
  refused 'the options that choose frames differ' --until 1
  refused 'the options that choose frames differ' --until 1 --every 2
  refused 'the options that choose frames differ' --until 1 --at 0.15,0.35 --cfl 1
  echo 'no log' >parts/log
  cp -r parts before
  mapfile -t where < <(outputs parts)
  run 3 evolve "${where[@]}" --resume --until 1 --at 0.15,0.35 "$step" disk.json
  says 'parts/log:1'
  diff -r parts before >/dev/null || fail "$form: a run with a wrong log changed something"
  rm -rf before
done

# An end before the last frame, or before the beginning: said, and nothing changes.
for form in series numbered; do
  rm -rf parts
  evolve_in parts --until 0.55 --every 2
  silent
  cp -r parts before
  for past in '--until 0.3' '--until 0.5' '--until -1' '--steps 2' '--steps 5' '--steps 2 --until 3' '--steps 9 --until 0.1'; do
    # shellcheck disable=SC2086
    evolve_in parts $past --every 2 --resume
    says 'the last frame, at time 0.55 after 5 steps, lies beyond the end'
    evolve_in parts -q --until 0.3 --every 2 --resume
    silent
    diff -r parts before >/dev/null || fail "$form: an end before the last frame changed something"
  done
  evolve_in parts --until 0.55 --every 2 --resume
  silent
  rm -rf before
done
sample_mesh disk 2 2 >later.json
run 0 evolve --until 1 --log log "$step" later.json
says 'the mesh is at time 2, later than --until 1'
cmp -s out later.json || fail "a mesh that is late does not pass through"
run 0 evolve -q --until 1 "$step" later.json
silent
run 0 evolve --until 2 "$step" later.json
silent
run 0 evolve --until 3 --at 1,2.5 "$step" later.json
says '--at 1 lies before the first frame, at time 2'
run 0 evolve --until 3 --at 2,2.5 "$step" later.json
silent

# Damaged frames: the place, the fault, and what to do. What is said leads on.
damaged() { # damaged TEXT...
  local -a where
  mapfile -t where < <(outputs parts)
  cp -r parts before
  run 3 evolve "${where[@]}" --resume --steps 8 --every 1 "$step" disk.json
  local text
  for text in "$@"; do says "$text"; done
  diff -r parts before >/dev/null || fail "$form: damaged frames changed"
  rm -rf before
}
rm -rf whole good
form=series
evolve_in whole --steps 8 --every 1
evolve_in good --steps 6 --every 1
for fault in begin end zero junk last; do
  rm -rf parts && cp -r good parts
  line=4 text='not begin as a mesh document does'
  case $fault in
    begin) sed -i '4s/^.//' parts/frames.jsonl ;;
    end) sed -i '4s/.$//' parts/frames.jsonl
      text='not end as a mesh document does' ;;
    zero) python3 -c 'import sys; p = sys.argv[1]; t = bytearray(open(p, "rb").read()); k = t.index(b"\n") + 200
t[k:k + 9] = bytes(9); open(p, "wb").write(t)' parts/frames.jsonl
      line=2 text='bytes that are zero' ;;
    junk) sed -i '4s/.*//' parts/frames.jsonl ;;
    last) sed -i '7s/"points":/"paints":/' parts/frames.jsonl
      line=7 text='points' ;;
  esac
  damaged "parts/frames.jsonl:$line: " "$text" "head -n $((line - 1))" 'the frame before'
  head -n $((line - 1)) parts/frames.jsonl >kept && mv kept parts/frames.jsonl
  evolve_in parts --steps 8 --every 1 --resume
  same_run parts whole "after the remedy for $fault"
done
rm -rf parts && cp -r good parts
sed -i '1s/.$//' parts/frames.jsonl
damaged 'parts/frames.jsonl:1: ' 'without it, evolve begins anew'

form=numbered
rm -rf whole good
evolve_in whole --steps 8 --every 1
evolve_in good --steps 6 --every 1
for fault in truncated empty middle; do
  rm -rf parts && cp -r good parts
  number=6 text='does not end as a mesh document does'
  case $fault in
    truncated) truncate -s -100 parts/frames/006.json ;;
    empty) : >parts/frames/006.json
      text='does not begin as a mesh document does' ;;
    middle) truncate -s -1 parts/frames/003.json
      number=3 ;;
  esac
  damaged "parts/frames/00$number.json: " "$text" 'remove it and those after it, and --resume goes on from the frame before'
  for ((; number <= 6; ++number)); do rm "parts/frames/00$number.json"; done
  evolve_in parts --steps 8 --every 1 --resume
  same_run parts whole "after the remedy for $fault"
done
rm -rf parts && cp -r good parts
sed -i 's/"points":/"paints":/' parts/frames/006.json
damaged 'parts/frames/006.json: ' points 'remove it'
sed -i 's/"points":/"paints":/' parts/frames/000.json
damaged 'parts/frames/000.json: ' points 'begins anew'

# A frame is missing between others: nothing is taken for a frame of this run that is none.
rm -rf parts && cp -r good parts
rm parts/frames/004.json
refused 'there is no parts/frames/004.json, but parts/frames/005.json and 1 after it are there' --steps 8 --every 1
says 'to go on from parts/frames/003.json'
rm parts/frames/005.json
refused 'parts/frames/006.json is there' --steps 8 --every 1
rm parts/frames/006.json
echo 'not a frame' >parts/frames/009.json
mkdir parts/frames/010.json
cp parts/frames/000.json parts/frames/2024.json.old
evolve_in parts --steps 8 --every 1 --resume
[ "$(cat parts/frames/009.json)" = 'not a frame' ] || fail "a file that is no frame was touched"
rm -r parts/frames/009.json parts/frames/010.json parts/frames/2024.json.old
same_run parts whole "after the frames beyond a gap are gone"
rm parts/frames/000.json
refused 'to begin anew' --steps 8 --every 1
# A fresh run removes all old frames of the pattern, also beyond a gap, but nothing that is no frame.
echo 'not a frame' >parts/frames/012.json
evolve_in parts --steps 1
[ "$(cd parts/frames && echo *)" = '000.json 001.json 012.json step' ] || fail "left by a fresh run: $(ls parts/frames)"
for pattern in 'p%d.json' 'p%4d.json' './p%03d%%.json' 'p%d/mesh.json' '%d'; do
  mkdir between && cd between || exit 1
  run 0 evolve --steps 5 --every 1 --frames "$pattern" "$step" ../disk.json
  rm -- "$(printf "$pattern" 3)"
  run 2 evolve --steps 9 --every 1 --resume --frames "$pattern" "$step" ../disk.json
  says "$(printf "$pattern" 4) and 1 after it"
  run 0 evolve --steps 1 --frames "$pattern" "$step" ../disk.json
  rm out err
  [ "$(find . -type f | wc -l)" = 3 ] || fail "$pattern: $(find . -type f | tr '\n' ' ')"
  cd .. && rm -r between
done
# What the step reads is not removed as an old frame.
advect --dt 1e-9 --vx 0 --vy 0 --field 'velocity=1,0' disk.json >flow7.json
run 2 evolve --steps 1 --frames 'flow%d.json' 'advect --flow flow7.json --outside nearest --dt 0.1' disk.json
says 'would be overwritten'

# Files of steps as editors write them.
printf '# a step\nadvect --vx=1 --vy=0 --dt 0.1 |\n flipdelaunay\n' >plain.txt
run 0 evolve --steps 2 --step plain.txt disk.json
mv out plain
reads() {
  run 0 evolve --steps 2 --step step.txt disk.json
  same out plain
}
{ printf '\xef\xbb\xbf' && cat plain.txt; } >step.txt
reads
{ printf '\xef\xbb\xbf' && sed 's/$/\r/' plain.txt; } >step.txt
reads
printf 'advect --vx=1 --vy=0 --dt 0.1 \\\r\n |\r\n"flip\\\r\ndelaunay"\r\n\r\n' >step.txt
reads
says_of() { # says_of TEXT...: status 2
  run 2 evolve --steps 2 --step step.txt disk.json
  local text
  for text in "$@"; do says "$text"; done
}
printf '\xef\xbb\xbfadvect --vx=1 --vy=0 --dt 0.1 | flip' >step.txt
says_of 'line 1, column 33' "no stage 'flip'"
printf 'advect --vx=1 --vy=0 \0 --dt 0.1' >step.txt
says_of 'line 1, column 22' 'of code 0'
printf 'advect --vx="1\0" --vy=0 --dt 0.1' >step.txt
says_of 'line 1, column 15' 'of code 0'
printf "advect --vx='1\\0' --vy=0 --dt 0.1" >step.txt
says_of 'line 1, column 15' 'of code 0'
printf 'advect --vx=1\\\0 --vy=0 --dt 0.1' >step.txt
says_of 'line 1, column 15' 'of code 0'
printf 'advect --vx=1 --vy=0 --dt 0.1\radvect' >step.txt
says_of 'of code 13'
iconv -t UTF-16 plain.txt >step.txt 2>/dev/null || printf '\xff\xfea\0d\0' >step.txt
says_of 'UTF-16'
printf '\xef\xbb\xbf' >step.txt
says_of 'the step is empty'
run 2 evolve --steps 2 --step /dev/zero disk.json
says 'longer than 1 MiB'
finish
