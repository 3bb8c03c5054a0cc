#!/bin/sh
# Compiles the scenes of a folder, recognises its frames and scores the result.
# usage: golden_test.sh PROGRAMS DATA WORK CONFIG DEMANDS...
# PROGRAMS and DATA are folders; WORK is made anew; DEMANDS go to aspect-score. Where the data has a
# regions.csv, every frame has to show that many regions in one object.
set -eu
programs=$1 data=$2 work=$3 config=$4
shift 4

rm -rf "$work"
mkdir -p "$work"
indexes=
for scene in "$data"/*.b; do
  name=$(basename "$scene" .b)
  "$programs/aspectc" "$scene" -o "$work/$name.aspect" --level 4 --no-store --progress never
  indexes="$indexes --index $name.aspect"
done

cd "$work"
# shellcheck disable=SC2086  # one word an option and a name; neither holds spaces
"$programs/aspect-replay" $indexes --config "$data/$config" --overlay overlays "$data/frames" \
  >seen.ndjson

symmetries=
if [ -f "$data/symmetries.csv" ]; then symmetries="$data/symmetries.csv"; fi
"$programs/aspect-score" "$data/truth.csv" seen.ndjson ${symmetries:+--symmetries "$symmetries"} \
  --table --sheet sheet.png --overlays overlays "$@"

if [ -f "$data/regions.csv" ]; then
  tail -n +2 "$data/regions.csv" | while IFS=, read -r name count; do
    found=$(grep "/$name\.[a-z]*\"" seen.ndjson | grep -o '"regions":[0-9]*' | tr '\n' ' ')
    if [ "$found" != "\"regions\":$count " ]; then
      echo "$name: found $found; one object of $count regions was expected" >&2
      exit 1
    fi
  done
fi
