#!/usr/bin/env bash
# Holds every #include "..." of runtime/, compiler/ and tools/ against tools/layers.txt.
# usage: layers_test.sh SOURCE_DIR
set -euo pipefail
cd "$1"
declare -A allowed
while IFS=: read -r folder others; do
  case $folder in ''|'#'*) continue ;; esac
  allowed[$folder]=" $folder $others "
done <tools/layers.txt

bad=0 seen=0
while IFS=: read -r file line; do
  folder=$(dirname "$file"); case $folder in tools/*) folder=tools ;; esac
  target=$(dirname "${line#*\"}"); case $target in tools/*) target=tools ;; esac
  seen=$((seen + 1))
  if [ -z "${allowed[$folder]+x}" ]; then
    echo "$file: folder $folder is not in tools/layers.txt; add a line for it"; bad=1
  elif [[ "${allowed[$folder]}" != *" $target "* ]]; then
    echo "$file: includes $target, which tools/layers.txt does not allow $folder to use"; bad=1
  fi
done < <(grep -rhoH --include='*.h' --include='*.cpp' '^#include "[^"]*' runtime compiler tools)
[ "$seen" -gt 100 ] || { echo "only $seen includes found: is this the source tree?"; exit 1; }
echo "$seen includes checked"
exit $bad
