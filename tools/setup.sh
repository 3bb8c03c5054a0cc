#!/usr/bin/env bash
# Installs the packages (Debian 12) that something of Aspect needs. Does nothing when all are there.
# usage: tools/setup.sh [demo|build|test]
#   demo    what tools/demo.sh builds and runs
#   build   that, and all programs with all they can do
#   test    that, and all tests, in emulators and under sanitizers as well (without a word: this)
# What tries packages (debootstrap, lintian) is no test's: tools/clean_room.sh --setup installs it.
set -euo pipefail

demo_packages=(
  g++ cmake ninja-build                                  # the compiler of Debian 12 and its drivers
  libeigen3-dev libflatbuffers-dev flatbuffers-compiler  # the runtime's libraries
  libembree-dev libtbb-dev libsqlite3-dev                # the compiler's
  pkgconf libminizip-dev libexpat1-dev
  libassimp-dev libpng-dev libxxhash-dev libmeshoptimizer-dev
  libcli11-dev libfmt-dev nlohmann-json3-dev libtomlplusplus-dev  # the tools'
  libopencv-core-dev libopencv-imgproc-dev libopencv-imgcodecs-dev
)
build_packages=(
  libopencv-videoio-dev                                  # videos as frames
  libopencv-calib3d-dev                                  # boards and lenses: aspect-calibrate's
  libv4l-dev                                             # the camera's: formats that are not ours
  libmosquitto-dev libcpp-httplib-dev libssl-dev libgpiod-dev  # the daemon's outputs
  libbenchmark-dev                                       # aspect-bench's
  pybind11-dev python3-dev python3-numpy                 # the Python module's
  libocct-data-exchange-dev                              # STEP files: 37 MB with what it needs
)
test_packages=(
  catch2 python3 python3-pil                             # tests
  mandoc zsh                                             # which read manual pages and completions
  chromium chromium-driver fonts-dejavu-core            # which read pages
  libdxflib-dev                                          # whose colours ours are compared with
  povray                                                 # the renderer that ours is compared with
  mosquitto                                              # the broker that MQTT is tested with
  g++-aarch64-linux-gnu g++-arm-linux-gnueabihf          # what boards run is compiled with these
  qemu-user-static                                       # and tested in this
  qemu-system-arm qemu-system-x86 kmod busybox-static    # whole boards, with their kernels
)

case "${1:-test}" in
  demo) wanted=("${demo_packages[@]}") ;;
  build) wanted=("${demo_packages[@]}" "${build_packages[@]}") ;;
  test) wanted=("${demo_packages[@]}" "${build_packages[@]}" "${test_packages[@]}") ;;
  *) echo "usage: tools/setup.sh [demo|build|test]" >&2; exit 2 ;;
esac

missing=()
for package in "${wanted[@]}"; do
  status=$(dpkg-query -W -f='${db:Status-Status}' "$package" 2>/dev/null || true)
  [ "$status" = installed ] || missing+=("$package")
done
if [ ${#missing[@]} -eq 0 ]; then
  echo "setup: all packages are installed (tools/clean_room.sh needs its own: --setup)"
  exit 0
fi

as_root=()
if [ "$(id -u)" -ne 0 ]; then
  command -v sudo >/dev/null || { echo "setup: run this as root, or install sudo: ${missing[*]}" >&2; exit 1; }
  as_root=(sudo)
fi
echo "setup: installing ${missing[*]}"
"${as_root[@]}" apt-get update -q
"${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get install -q -y --no-install-recommends "${missing[@]}"
