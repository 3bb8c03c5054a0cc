#!/usr/bin/env bash
# Builds the compiler, compiles the thesis's objects and puts a table of what came of it, beside the
# thesis's own (../shared/thesis), at the top of RESULTS.md. TRUCK:7 takes most of the time.
# usage: tools/bench/thesis_tables.sh [OBJECT:LEVEL ...]   as in CUBE:7 LARGE_MESH:5 [all]
# ASPECT_SHARED: the shared folder, where it is another one than ../shared
set -euo pipefail
cd "$(dirname "$0")/../.."
mkdir -p build/bench
tools/build.sh aspectc >build/bench/build.log || { cat build/bench/build.log >&2; exit 1; }
exec python3 tools/bench/thesis_tables.py "$@"
