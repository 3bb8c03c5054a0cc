#!/usr/bin/env bash
# Sets up, builds, and does the main job on real input: compiles objects into class indexes, then
# recognises recorded frames that something else rendered (POV-Ray) or photographed.
# usage: tools/demo.sh [--short]    --short: coarser indexes, as CI runs it
# Leaves everything in build/demo, the contact sheets as rendered.png and real.png.
set -euo pipefail
cd "$(dirname "$0")/.."
level=5
case "${1:-}" in
  '') ;;
  --short) level=3 ;;
  *) echo "usage: tools/demo.sh [--short]" >&2; exit 2 ;;
esac

tools/setup.sh
tools/build.sh

bin=build/release/bin
out=build/demo
rm -rf "$out"
mkdir -p "$out"

# compile FOLDER NAME...: every scene into $out/NAME.aspect
compile() {
  local folder=$1 name
  shift
  for name in "$@"; do
    "$bin/aspectc" "$folder/$name.b" -o "$out/$name.aspect" --level "$level" --no-store \
      --stats "$out/$name.json" --progress always
  done
}

# recognise SET FOLDER SCORE_OPTIONS... -- INDEX_NAME...: frames of tests/data/SET, a table, a sheet
recognise() {
  local set=$1 config=$2 scoring=() indexes=() name
  shift 2
  while [ "$1" != -- ]; do scoring+=("$1"); shift; done
  shift
  for name in "$@"; do indexes+=(--index "$out/$name.aspect"); done
  "$bin/aspect-replay" "${indexes[@]}" --config "tests/data/$set/$config" \
    --overlay "$out/$set" "tests/data/$set/frames" >"$out/$set.ndjson"
  "$bin/aspect-score" "tests/data/$set/truth.csv" "$out/$set.ndjson" --table \
    --sheet "$out/$set.png" --overlays "$out/$set" "${scoring[@]}"
}

echo "== compiling"
compile tests/data/rendered cube l_shape blockcyl1 blockcyl2 pegblock
compile tests/data/real rubik_03 rubik_04

echo "== frames rendered by POV-Ray"
recognise rendered camera.toml --symmetries tests/data/rendered/symmetries.csv \
  -- cube l_shape blockcyl1 blockcyl2 pegblock
echo "== photographs"
recognise real segmentation.toml -- rubik_03 rubik_04
echo "== pictures: $out/rendered.png $out/real.png"
