#!/usr/bin/env bash
# How well and how fast many parts are told apart: makes COUNT parts, many of them alike, compiles
# them at level 3, renders two frames of each with POV-Ray and recognises the first 5, 10, 30, 100...
# of them with as many indexes. A hundred parts take a quarter of an hour, and 8 MB.
# usage: tools/bench/many_parts.sh CASES_TOOLS OUT COUNT   (the folder of make_frames.py, and one for all of it)
set -euo pipefail
[ $# -eq 3 ] || { echo "usage: tools/bench/many_parts.sh CASES_TOOLS OUT COUNT" >&2; exit 2; }
root=$(cd "$(dirname "$0")/../.." && pwd)
bin=$root/build/release/bin
mkdir -p "$2"
cp "$1"/make_frames.py "$1"/objects.py "$2"
cat "$root/tools/bench/many_parts.py" >>"$2/objects.py"
cd "$2"
export ASPECT_PARTS=$3
[ -e all/truth.csv ] || /usr/bin/python3 make_frames.py all --mode camera --frames $((2 * $3)) --seed 9100
for scene in all/*.b; do
  index=$(basename "$scene" .b).aspect
  [ -e "$index" ] || echo "$scene $index"
done | xargs -r -P "$(nproc)" -n 2 sh -c '"$0" "$1" --level 3 --jobs 1 --no-store --progress never -o "$2"' "$bin/aspectc"

for count in 5 10 30 100 300 1000 3000 10000; do
  [ "$count" -le "$3" ] || break
  mkdir -p "$count/frames"
  cp objects.py all/camera.toml "$count"
  { head -n 1 all/truth.csv; awk -F, -v count="$count" 'NR > 1 && substr($2, 5) + 0 < count' all/truth.csv; } >"$count/truth.csv"
  tail -n +2 "$count/truth.csv" | cut -d, -f1 | sort -u | while read -r frame; do cp "all/$frame" "$count/$frame"; done
  indexes=()
  for ((k = 0; k < count; ++k)); do indexes+=(--index "$(printf 'part%05d.aspect' "$k")"); done
  "$bin/aspect-replay" "${indexes[@]}" --config "$count/camera.toml" "$count/frames" >"$count.ndjson"
  echo "== $count parts"
  /usr/bin/python3 "$root/tools/bench/many_parts_score.py" "$count" "$count.ndjson" --wrong "$count.wrong"
done
