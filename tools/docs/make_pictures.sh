#!/usr/bin/env bash
# Makes the pictures of tools/docs with the programs that are built, and a copy of the pages beside
# them: build/docs.
# usage: tools/docs/make_pictures.sh [LEVEL]    of the indexes; 4 without it, lower is quicker
set -euo pipefail
cd "$(dirname "$0")/../.."
level=${1:-4}
bin=build/release/bin
out=build/docs
for program in aspectc aspect-replay aspect-eval; do
  [ -x "$bin/$program" ] || { echo "make_pictures: $bin/$program is missing; run tools/build.sh first" >&2; exit 1; }
done
rm -rf "$out"
mkdir -p "$out/pictures" "$out/made"
cp tools/docs/*.md "$out"

models=compiler/models
for segmented in '' --segmented; do
  "$bin/aspectc" render "$models/pegblock.b" --from 1,0.6,0.5 $segmented \
    -o "$out/pictures/$([ -n "$segmented" ] && echo regions || echo rendered).png"
done
indexes=() evaluated=()
for name in cube l_shape blockcyl1 blockcyl2 pegblock; do
  "$bin/aspectc" "tests/data/rendered/$name.b" -o "$out/made/$name.aspect" --level "$level" --no-store
  indexes+=(--index "$out/made/$name.aspect")
  evaluated+=(--index "$out/made/$name.aspect" --scene "tests/data/rendered/$name.b")
done
frame=$(ls tests/data/cluttered/frames | head -n 1)
"$bin/aspect-replay" "${indexes[@]}" --config tests/data/cluttered/camera.toml --dump "$out/made/stages" \
  --overlay "$out/made/found" "tests/data/cluttered/frames/$frame" >"$out/made/found.ndjson"
cp "$out"/made/stages/*_1_input.png "$out/pictures/input.png"
cp "$out"/made/stages/*_2_regions.png "$out/pictures/frame_regions.png"
cp "$out"/made/found/*.png "$out/pictures/found.png"
"$bin/aspectc" inspect "$out/made/pegblock.aspect" --sheet "$out/pictures/classes.png"
"$bin/aspectc" doctor "$models/l_shape.b" --picture "$out/pictures/doctor.png" >"$out/made/doctor.txt" || true
"$bin/aspect-eval" "${evaluated[@]}" --views 60 --plots "$out/pictures" >"$out/made/views.txt"
"$bin/aspect-eval" "${evaluated[@]}" --views 60 --clutter --recall "$out/pictures/recall.svg" >"$out/made/clutter.txt"
rm -rf "$out/made"
echo "make_pictures: $out has $(ls "$out/pictures" | wc -l) pictures"
