#!/usr/bin/env bash
# Builds the compiler, compiles objects from level 3 up, and puts what it costs by the number of
# views (without those along borders) at the top of RESULTS.md; the curve itself is drawn into
# build/bench/cost_curve.svg.
# usage: tools/bench/cost_curve.sh [OBJECT:HIGHEST_LEVEL ...]   [CUBE:8 BLOCKCYL2:8 TRUCK:7]
set -euo pipefail
cd "$(dirname "$0")/../.."
mkdir -p build/bench
tools/build.sh aspectc >build/bench/build.log || { cat build/bench/build.log >&2; exit 1; }
exec python3 tools/bench/cost_curve.py "$@"
