#!/bin/sh
# Every frame of regions.csv has to show that many regions in one object.
# usage: regions_test.sh REGIONS.csv SEEN.ndjson
set -eu
[ "$(wc -l <"$1")" -gt 1 ] || { echo "$1: has no frames" >&2; exit 1; }
tail -n +2 "$1" | while IFS=, read -r name count; do
  found=$(grep "/$name\.[a-z]*\"" "$2" | grep -o '"regions":[0-9]*' | tr '\n' ' ')
  if [ "$found" != "\"regions\":$count " ]; then
    echo "$name: found $found; one object of $count regions was expected" >&2
    exit 1
  fi
done
