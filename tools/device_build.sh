#!/usr/bin/env bash
# Builds what runs on a board, static, for each processor asked for, and prints what it weighs.
# usage: tools/device_build.sh [arm64|armhf|x86_64]...   (without any: all three)
# The programs to copy to a board are then in build/device-PROCESSOR/bin/stripped. Libraries of
# another processor are fetched from Debian and unpacked below build/firmware, not installed.
set -euo pipefail
cd "$(dirname "$0")/.."
[ $# -gt 0 ] || set -- arm64 armhf x86_64
for processor in "$@"; do
  case "$processor" in
    arm64|armhf|x86_64) ;;
    *) echo "usage: tools/device_build.sh [arm64|armhf|x86_64]..." >&2; exit 2 ;;
  esac
done
packages=$PWD/build/firmware/packages
for processor in "$@"; do
  arch=${processor/x86_64/amd64}
  firmware_configs/rootfs/fetch_packages.sh "$arch" "$packages" libv4l-dev libjpeg62-turbo-dev
  # Joined, as the tests in emulators are: a build of both must not be one of each in turn.
  cmake --preset "device-$processor" -DASPECT_JOIN=ON "-DASPECT_DEVICE_PACKAGES=$packages/$arch" >device_configure.log 2>&1 || { cat device_configure.log >&2; exit 1; }
  rm -f device_configure.log
  cmake --build --preset "device-$processor" -j "${CMAKE_BUILD_PARALLEL_LEVEL:-$(nproc)}" --target stripped
  for program in build/device-"$processor"/bin/stripped/*; do
    printf '%s %s: %d KiB\n' "$processor" "$(basename "$program")" $(($(stat -c %s "$program") / 1024))
  done
done
