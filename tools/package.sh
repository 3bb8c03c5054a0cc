#!/usr/bin/env bash
# Builds Debian packages, with what they need built first, and leaves them in build/packages.
# usage: tools/package.sh [amd64|arm64|armhf]...   (without any: all three)
#   amd64         aspect-compiler, libaspect, libaspect-dev, aspectd, aspect-doc and, where the Python
#                 module is built, python3-aspect: for a workstation with Debian 12
#   arm64, armhf  aspectd (static), libaspect and libaspect-dev: for a board, without any of the
#                 compiler's libraries
# What is needed to build them: tools/setup.sh build; for boards tools/setup.sh test. The same tree in
# the same folder gives the same bytes. tools/clean_room.sh tries them.
set -euo pipefail
cd "$(dirname "$0")/.."
[ $# -gt 0 ] || set -- amd64 arm64 armhf
for processor in "$@"; do
  case "$processor" in
    amd64|arm64|armhf) ;;
    *) echo "usage: tools/package.sh [amd64|arm64|armhf]..." >&2; exit 2 ;;
  esac
done
umask 022
SOURCE_DATE_EPOCH=$(date -d "$(sed -n 's/^ -- .*>  //p' packaging/changelog | head -n 1)" +%s)
export SOURCE_DATE_EPOCH
mkdir -p build/packages

# quietly COMMAND...: what it says only where it fails
quietly() {
  "$@" >build/packages/log 2>&1 || { cat build/packages/log >&2; exit 1; }
  rm -f build/packages/log
}

for processor in "$@"; do
  if [ "$processor" = amd64 ]; then
    folder=build/package-amd64
    settings=()
    # A first build joins sources, which is quicker.
    [ -e $folder/CMakeCache.txt ] || settings=(-DASPECT_JOIN=ON)
    quietly cmake --preset package-amd64 "${settings[@]}"
    cmake --build --preset package-amd64 --target packaged
  else
    folder=build/device-$processor
    tools/device_build.sh "$processor"
    cmake --build --preset "device-$processor" --target packaged
  fi
  rm -f build/packages/*_"$processor".deb
  quietly cpack --config "$folder/CPackConfig.cmake" -B build/packages/tree
  rm -rf build/packages/tree/_CPack_Packages
  mv -f build/packages/tree/*.deb build/packages
  rmdir build/packages/tree
done
for package in build/packages/*.deb; do
  printf '%s: %d KiB\n' "$(basename "$package")" $((($(stat -c %s "$package") + 1023) / 1024))
done
