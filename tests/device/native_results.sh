#!/usr/bin/env bash
# Runs tests of the workstation's build with the little input that emulated ones have: leaves their
# summaries as RESULTS/TEST.txt, and what the compiler half made for them in RESULTS/samples: those of
# the tests' other run, so that an index is compiled once.
# usage: native_results.sh BIN RESULTS TEST...
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
. "$here/rounds.sh"
bin=$1
results=$2
shift 2
cd "$here/../.."
rm -rf "$results"
mkdir -p "$results" build/samples
ln -s "$PWD/build/samples" "$results/samples"
export ASPECT_SAMPLES=$results/samples
for test in "$@"; do
  "$bin/$test" >"$results/$test.log" 2>&1 || { cat "$results/$test.log" >&2; exit 1; }
  summary "$test" "$results/$test.log" >"$results/$test.txt"
done
