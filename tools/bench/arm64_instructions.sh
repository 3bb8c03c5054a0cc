#!/usr/bin/env bash
# Counts the instructions that a frame of 640 x 480 costs on arm64, by stage, in a booted kernel, and
# prints the milliseconds that this means on two cores. Takes half a minute once everything is built.
# usage: tools/bench/arm64_instructions.sh
set -euo pipefail
cd "$(dirname "$0")/../.."
tools/build.sh aspectc aspect-replay make_raw_frames guest_programs
build=build/release/tests/firmware
tests/firmware/prepare.sh inputs $build build/release/bin/aspectc build/release/bin/make_raw_frames \
  build/release/tests/tools/score/rendered
tests/firmware/prepare.sh rootfs $build arm64 arm64
exec python3 -B tests/firmware/instructions.py --arch arm64 --build $build \
  --guest-programs $build/guest-arm64 --device-programs build/device-arm64/bin/stripped \
  --replay build/release/bin/aspect-replay
