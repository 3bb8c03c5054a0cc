#!/usr/bin/env bash
# Prints the project's figures as Markdown, for RESULTS.md: models, accuracy on frames of another ray
# tracer, the thesis's pose experiment, milliseconds. About three minutes on two cores.
# usage: tools/bench/figures.sh [CASES]   CASES: folder with rendered/ and real/ [../shared/cases]
set -euo pipefail
cd "$(dirname "$0")/../.."
cases=${1:-../shared/cases}
bin=build/release/bin
out=build/figures
mkdir -p "$out"

row() {  # row STATS.json: one line of the table of models
  python3 - "$1" <<'PY'
import json, sys
s = json.load(open(sys.argv[1]))
print("| {object} | {level} | {views} | {clusters} | {area_fraction:.4f} | {kib:.1f} | {seconds[total]:.1f} |".format(
    kib=s["index_bytes"] / 1024, **s))
PY
}
model() {  # model SCENE LEVEL: compiles it and prints its row
  local name
  name=$(basename "$1" .b)
  "$bin/aspectc" "$1" --level "$2" --no-store -o "$out/$name.$2.aspect" --stats "$out/$name.$2.json" >/dev/null
  row "$out/$name.$2.json"
}

echo "### Models"
echo "| object | level | views | clusters | area | KiB | s |"
echo "| --- | --- | --- | --- | --- | --- | --- |"
for level in 4 5 6; do model tests/data/rendered/cube.b $level; done
for name in l_shape blockcyl1 blockcyl2 pegblock; do model "tests/data/rendered/$name.b" 5; done
mkdir -p "$out/models"
five=()
for name in cube l_shape blockcyl1 blockcyl2 pegblock; do five+=(--index "$out/$name.5.aspect"); done
echo
echo "The thesis's objects (compiler/models):"
echo
echo "| object | level | views | clusters | area | KiB | s |"
echo "| --- | --- | --- | --- | --- | --- | --- |"
rendered=$out
out=$out/models
for name in cube l_shape blockcyl1 blockcyl2 blockcyl3 pegblock dumbbell holeblock; do
  model "compiler/models/$name.b" 6
done
model compiler/models/truck.b 5

echo
echo "### The thesis's pose experiment, level 6"
for views in 100 1000; do
  echo '```'
  for name in blockcyl1 blockcyl2 l_shape pegblock; do
    "$bin/aspect-eval" --index "$out/$name.6.aspect" --scene "compiler/models/$name.b" --views $views --seed 1 |
      if [ $name = blockcyl1 ]; then sed -n '1,/^blockcyl1/p'; else grep -m1 "^$name"; fi
  done
  echo '```'
done
out=$rendered

echo
echo "### Frames of another ray tracer, five indexes of level 5"
for set in clean camera tint multi; do
  [ -d "$cases/rendered/$set" ] || { echo "$set: not here, skipped"; continue; }
  "$bin/aspect-replay" "${five[@]}" --config "$cases/rendered/$set/camera.toml" \
    "$cases/rendered/$set/frames" >"$out/$set.ndjson"
  echo "$set:"
  echo '```'
  "$bin/aspect-score" "$cases/rendered/$set/truth.csv" "$out/$set.ndjson" \
    --symmetries tests/data/rendered/symmetries.csv
  echo '```'
done

echo
echo "### Sticker regions of real/rubik_robot"
for frame in 2x2x2-random-03_R:rubik_robot 2x2x2-random-04_B:rubik_robot \
             3x3x3-random-01_F:rubik_robot_3x3x3 4x4x4-random-02_B:rubik_robot_4x4x4; do
  picture=$cases/real/rubik_robot/img/${frame%%:*}.png
  [ -f "$picture" ] || { echo "${frame%%:*}: not here, skipped"; continue; }
  "$bin/aspect-replay" --index "$out/cube.5.aspect" --config "tests/data/real/${frame##*:}.toml" "$picture" |
    python3 -c 'import json, sys; f = json.loads(sys.stdin.readline())
print("-", f["frame"].split("/")[-1], sum(o["regions"] for o in f["objects"]), "regions")'
done

echo
echo "### Milliseconds on one core"
echo '```'
"$bin/aspect-bench" --benchmark_filter=-compile_to_level --benchmark_repetitions=5 --benchmark_report_aggregates_only=true 2>/dev/null |
  grep -E '^(Benchmark|.*_median)'
echo '```'
