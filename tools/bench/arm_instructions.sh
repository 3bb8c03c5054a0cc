#!/usr/bin/env bash
# Counts the instructions that a frame of 640 x 480 costs on arm64 and armhf, by stage, in a booted
# kernel, and prints the milliseconds that this means on some cores. Takes a minute once everything
# is built.
# usage: tools/bench/arm_instructions.sh [--plain]
#   --plain   arm64 without NEON, too: what the compiler's vector code gains
set -euo pipefail
cd "$(dirname "$0")/../.."
case "${1:-}" in
  ''|--plain) ;;
  *) echo "usage: tools/bench/arm_instructions.sh [--plain]" >&2; exit 2 ;;
esac
tools/build.sh aspectc aspect-replay make_raw_frames guest_programs
build=build/release/tests/firmware
tests/firmware/prepare.sh inputs $build build/release/bin/aspectc build/release/bin/make_raw_frames \
  build/release/tests/recognition_table/rendered
tests/firmware/prepare.sh rootfs $build arm64 arm64

# The arm64 kernel runs programs of both.
tools/device_build.sh armhf

# count PROCESSOR PROGRAMS: a table
count() {
  python3 -B tests/firmware/instructions.py --arch arm64 --processor "$1" --build $build \
    --guest-programs $build/guest-arm64 --device-programs "$2" --replay build/release/bin/aspect-replay
}
count arm64 build/device-arm64/bin/stripped
count armhf build/device-armhf/bin/stripped
[ "${1:-}" = --plain ] || exit 0
plain=$PWD/build/device-arm64-plain
cmake --preset device-arm64 -B "$plain" -DBUILD_TESTING=OFF \
  -DCMAKE_CXX_FLAGS_RELEASE="-O3 -DNDEBUG -fno-tree-vectorize -fno-tree-slp-vectorize" >"$plain.log"
cmake --build "$plain" --target stripped-aspect-replay
echo "without vector code:"
count arm64 "$plain/bin/stripped"
