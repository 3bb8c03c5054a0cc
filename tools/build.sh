#!/usr/bin/env bash
# Builds the release preset; the programs are then in build/release/bin.
# usage: tools/build.sh [TARGET...]   (without a target: the programs, not the tests)
# A first build compiles joined sources, which is quicker; once configured otherwise (see
# CONTRIBUTING.md) it stays so.
set -euo pipefail
cd "$(dirname "$0")/.."
[ $# -gt 0 ] || set -- programs
# Programs alone are built without the packages that tests need; a build that has tests keeps them.
settings=()
[ -e build/release/CMakeCache.txt ] || settings=(-DASPECT_JOIN=ON -DBUILD_TESTING=OFF)
case "$*" in programs|demo_programs) ;; *) settings+=(-DBUILD_TESTING=ON) ;; esac
cmake --preset release "${settings[@]}" >build_configure.log 2>&1 || { cat build_configure.log >&2; exit 1; }
rm -f build_configure.log
cmake --build --preset release --target "$@"
