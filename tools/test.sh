#!/usr/bin/env bash
# Sets up, builds and runs all tests: first the release build's, then those of the parsers and of
# the runtime under the address and undefined-behaviour sanitizers.
# usage: tools/test.sh [CTEST OPTIONS...]
set -euo pipefail
cd "$(dirname "$0")/.."
tools/setup.sh test
if command -v ccache >/dev/null; then
  # Tests read a precompiled header, which ccache takes with these settings only.
  export CMAKE_CXX_COMPILER_LAUNCHER=${CMAKE_CXX_COMPILER_LAUNCHER-ccache} CCACHE_SLOPPINESS=${CCACHE_SLOPPINESS-pch_defines,time_macros}
fi
tools/build.sh all
echo "== release"
ctest --test-dir build/release --output-on-failure -j2 "$@"

echo "== programs for boards"
tools/device_build.sh

echo "== sanitizers"
[ -e build/asan/CMakeCache.txt ] && join=() || join=(-DASPECT_JOIN=ON)
cmake --preset asan "${join[@]}" >/dev/null
cmake --build --preset asan --target sanitized_tests
ctest --test-dir build/asan --output-on-failure -j2 -L sanitized "$@"
