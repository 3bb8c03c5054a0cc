#!/usr/bin/env bash
# Sets up, builds, and does the main job on real input: compiles objects into class indexes, then
# recognises recorded frames that something else rendered (POV-Ray) or photographed. Installs and
# builds what that needs and no more.
# usage: tools/demo.sh [--short|--fine]    --short: coarser indexes, as CI runs it; --fine: finer
# Leaves everything in build/demo: contact sheets as rendered.png, cluttered.png and real.png, and a
# page of each for a browser, with the reasons for every answer, as rendered.page/index.html and so on.
set -euo pipefail
cd "$(dirname "$0")/.."
level=4 compiling='1 minute'
case "${1:-}" in
  '') ;;
  --short) level=3 compiling='half a minute' ;;
  --fine) level=5 compiling='3 minutes' ;;
  *) echo "usage: tools/demo.sh [--short|--fine]" >&2; exit 2 ;;
esac

# step WHAT: what comes now, and how long it takes on two cores that have nothing else to do
number=0 begun=$SECONDS
step() {
  number=$((number + 1))
  echo "== $number of 4, $(((SECONDS - begun) / 60)) min $(((SECONDS - begun) % 60)) s gone: $1"
}

step 'packages: 201 MB, 1 to 2 minutes; a second where they are installed'
tools/setup.sh demo
step 'aspectc, aspect-replay and aspect-score: 2 to 3 minutes; a second where they are built'
tools/build.sh demo_programs

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

# recognise SET CONFIGURATION SCORE_OPTIONS... -- INDEX_NAME...: frames of tests/data/SET, a table, a sheet
recognise() {
  local set=$1 config=$2 scoring=() indexes=() name
  shift 2
  while [ "$1" != -- ]; do scoring+=("$1"); shift; done
  shift
  for name in "$@"; do indexes+=(--index "$out/$name.aspect"); done
  "$bin/aspect-replay" "${indexes[@]}" --config "tests/data/$set/$config" \
    --overlay "$out/$set" --html "$out/$set.page" --truth "tests/data/$set/truth.csv" "${scoring[@]}" \
    "tests/data/$set/frames" >"$out/$set.ndjson"
  "$bin/aspect-score" "tests/data/$set/truth.csv" "$out/$set.ndjson" --table \
    --sheet "$out/$set.png" --overlays "$out/$set" "${scoring[@]}"
}

step "seven objects become indexes: $compiling"
compile tests/data/rendered cube l_shape blockcyl1 blockcyl2 pegblock
compile tests/data/real rubik_03 rubik_04

step "frames are recognised: 10 seconds"
echo "-- rendered by POV-Ray"
recognise rendered camera.toml --symmetries tests/data/rendered/symmetries.csv \
  -- cube l_shape blockcyl1 blockcyl2 pegblock
echo "-- before photographs, other shapes about, and touching"
recognise cluttered camera.toml --symmetries tests/data/rendered/symmetries.csv \
  -- cube l_shape blockcyl1 blockcyl2 pegblock
echo "-- photographs"
recognise real segmentation.toml -- rubik_03 rubik_04
echo "== done in $(((SECONDS - begun) / 60)) min $(((SECONDS - begun) % 60)) s; pictures: $out/rendered.png $out/cluttered.png $out/real.png; for a browser: $out/{rendered,cluttered,real}.page/index.html"
