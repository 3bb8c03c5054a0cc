#!/usr/bin/env bash
# Builds the release preset; the programs are then in build/release/bin.
# usage: tools/build.sh [TARGET...]   (without a target: the programs, not the tests)
set -euo pipefail
cd "$(dirname "$0")/.."
[ $# -gt 0 ] || set -- programs
cmake --preset release >build_configure.log 2>&1 || { cat build_configure.log >&2; exit 1; }
rm -f build_configure.log
cmake --build --preset release --target "$@"
