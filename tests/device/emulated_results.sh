#!/usr/bin/env bash
# Builds the device's tests for a processor, runs them in an emulator (CMAKE_CROSSCOMPILING_EMULATOR
# of its toolchain), and compares their summaries with those of native_results.sh.
# usage: emulated_results.sh arm64|armhf RESULTS TEST...
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
. "$here/rounds.sh"
processor=$1
results=$2
shift 2
cd "$here/../.."
build=$PWD/build/device-$processor

# What the programs are built with, then OpenCV and what it needs; the C++ library comes with the
# cross compiler.
libraries=(libv4l-dev libjpeg62-turbo-dev)
opencv=(libopencv-core406 libopencv-imgproc406 libtbb12 liblapack3 libblas3 libgfortran5 libglx0
  libglvnd0 libx11-6 libxcb1 libxau6 libxdmcp6 libbsd0 libmd0 zlib1g)
packages=$PWD/build/firmware/packages
firmware_configs/rootfs/fetch_packages.sh "$processor" "$packages" "${libraries[@]}" "${opencv[@]}"
library_path=$(find "$packages/$processor" -name '*.so.*' -printf '%h\n' | sort -u | paste -sd:)

log=$build.log
mkdir -p build
cmake --preset "device-$processor" -DASPECT_JOIN=ON "-DASPECT_DEVICE_PACKAGES=$packages/$processor" >"$log" 2>&1 &&
  cmake --build --preset "device-$processor" -j "${CMAKE_BUILD_PARALLEL_LEVEL:-$(nproc)}" --target "$@" >>"$log" 2>&1 || { cat "$log" >&2; exit 1; }

export ASPECT_SAMPLES=$results/samples
# The emulator's, not ours.
export QEMU_SET_ENV=LD_LIBRARY_PATH=$library_path
failed=0
for test in "$@"; do
  log=$build/$test.log
  begin=$SECONDS
  here_is='no success'
  if ctest --test-dir "$build" -R "^$test\$" --no-tests=error -V >"$log" 2>&1; then
    here_is=$(summary "$test" "$log")
  fi
  wanted=$(cat "$results/$test.txt")
  if [ "$here_is" = "$wanted" ]; then
    echo "$test: $here_is, $((SECONDS - begin)) s"
  else
    echo "$test: $here_is; on this machine: $wanted" >&2
    tail -n 40 "$log" >&2
    failed=1
  fi
done
exit $failed
