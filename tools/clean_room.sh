#!/usr/bin/env bash
# Tries the packages of build/packages where nothing else of Aspect is: in a clean Debian 12 a newcomer
# installs them, compiles a mesh, recognises a frame and builds a program, each command timed; then all
# is purged, and nothing may stay. Packages for boards are unpacked into a root file system of their
# processor and run in an emulator. Its last line is a summary; exit 0 or 1.
# usage: tools/clean_room.sh [--setup] [arm64|armhf]...
#   --setup      installs what this needs first (debootstrap, lintian, emulators, cross compilers)
#   arm64 armhf  which boards' packages; without any: those that are there
# Run tools/package.sh before. Needs root, and Debian's packages over the network: what was fetched is
# kept in build/clean_room, so that a second run is quick. Its folders are made below
# ASPECT_CLEAN_ROOM, or build/clean_room.
set -euo pipefail
cd "$(dirname "$0")/.."
stop() { echo "clean_room: $1" >&2; exit 1; }

setup_packages=(debootstrap lintian qemu-user-static gcc-aarch64-linux-gnu gcc-arm-linux-gnueabihf python3)
[ "$(id -u)" -eq 0 ] || stop "run this as root: it makes a root file system and changes into it"
if [ "${1-}" = --setup ]; then
  shift
  apt-get update -q && DEBIAN_FRONTEND=noninteractive apt-get install -q -y --no-install-recommends "${setup_packages[@]}"
fi
boards=("$@")
for board in "$@"; do
  case $board in arm64|armhf) ;; *) echo "usage: tools/clean_room.sh [--setup] [arm64|armhf]..." >&2; exit 2 ;; esac
done
for program in debootstrap lintian unshare python3; do
  command -v $program >/dev/null || stop "$program is not there; run tools/clean_room.sh --setup"
done
packages=$PWD/build/packages
ls "$packages"/aspect-compiler_*_amd64.deb >/dev/null 2>&1 || stop "no packages in build/packages; run tools/package.sh"
if [ ${#boards[@]} -eq 0 ]; then
  for board in arm64 armhf; do
    ! ls "$packages"/aspectd_*_$board.deb >/dev/null 2>&1 || boards+=("$board")
  done
fi
folder=${ASPECT_CLEAN_ROOM:-$PWD/build/clean_room}
mkdir -p "$folder"
folder=$(cd "$folder" && pwd)
output=$folder/output
summary=()
# part COMMAND...: its last line goes into the summary, or is the last one.
part() {
  "$@" | tee "$folder/part"
  summary+=("$(tail -n 1 "$folder/part")")
}

echo "== lintian"
lines=$(lintian --allow-root --fail-on none "$packages"/*.deb 2>&1) || true
echo "${lines:-nothing}"
echo
part packaging/clean_room/newcomer.sh "$packages" "$folder" "$output"
for board in "${boards[@]}"; do
  echo
  part packaging/clean_room/board.sh "$board" "$packages" "$folder" "$output"
done
echo
[ -z "$lines" ] || { echo "clean_room: failed: lintian says $(wc -l <<<"$lines") lines, above"; exit 1; }
printf -v all '%s; ' "${summary[@]}"
echo "clean_room: passed: ${all}lintian says nothing"
