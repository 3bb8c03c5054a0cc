#!/usr/bin/env bash
# How well objects that nothing was tuned on are recognised: renders frames of five with POV-Ray,
# compiles them at level 5 and scores. Takes half an hour. Photographs behind the objects are those
# beside CASES_TOOLS, as make_frames.py has them.
# usage: tools/bench/held_out.sh CASES_TOOLS OUT   (the folder of make_frames.py, and one for all of it)
set -euo pipefail
[ $# -eq 2 ] || { echo "usage: tools/bench/held_out.sh CASES_TOOLS OUT" >&2; exit 2; }
root=$(cd "$(dirname "$0")/../.." && pwd)
bin=$root/build/release/bin
tools=$(realpath "$1")
mkdir -p "$2"
cp "$1"/make_frames.py "$1"/score.py "$1"/objects.py "$2"
cat "$root/tools/bench/held_out_objects.py" >>"$2/objects.py"
cd "$2"
seed=7701
for set in clean:60 camera:60 tint:30 multi:20 touch:25 clutter:40 empty:40; do
  mode=${set%:*}
  [ -e "$mode/truth.csv" ] || /usr/bin/python3 make_frames.py "$mode" --backgrounds "$tools/../real" --mode "$mode" --frames "${set#*:}" --seed $seed
  seed=$((seed + 1))
done
indexes=()
for object in wedge t_shape stairs house knob; do
  "$bin/aspectc" "clean/$object.b" --level 5 -o "$object.aspect"
  indexes+=(--index "$object.aspect")
done
for mode in clean camera tint multi touch clutter empty; do
  "$bin/aspect-replay" "${indexes[@]}" --config $mode/camera.toml $mode/frames >$mode.ndjson
  echo "== $mode"
  /usr/bin/python3 score.py $mode/truth.csv $mode.ndjson
done
