#!/usr/bin/env bash
# Builds the release preset; the programs are then in build/release/bin.
# usage: tools/build.sh [TARGET...]   (without a target: the programs, not the tests)
# A first build compiles joined sources, which is quicker; once configured otherwise (see
# CONTRIBUTING.md) it stays so.
set -euo pipefail
cd "$(dirname "$0")/.."
[ $# -gt 0 ] || set -- programs
# Programs are built without the packages that tests need.
case "$*" in programs|demo_programs) tests=OFF ;; *) tests=ON ;; esac
[ -e build/release/CMakeCache.txt ] && join=() || join=(-DASPECT_JOIN=ON)
cmake --preset release -DBUILD_TESTING=$tests "${join[@]}" >build_configure.log 2>&1 || { cat build_configure.log >&2; exit 1; }
rm -f build_configure.log
cmake --build --preset release --target "$@"
