#!/usr/bin/env bash
# Installs every package that Aspect is built, tested and demonstrated with (Debian 12).
# Does nothing when all are there.
set -euo pipefail

packages=(
  g++ cmake ninja-build                                  # the compiler of Debian 12 and its drivers
  libeigen3-dev libflatbuffers-dev flatbuffers-compiler  # the runtime's libraries
  libembree-dev libtbb-dev libsqlite3-dev                # the compiler's
  libassimp-dev libpng-dev libxxhash-dev
  libv4l-dev                                             # the camera's: formats that are not ours
  libcli11-dev libfmt-dev nlohmann-json3-dev libtomlplusplus-dev libopencv-dev  # the tools'
  pkgconf libmosquitto-dev libcpp-httplib-dev libssl-dev libgpiod-dev  # the daemon's outputs
)
test_packages=(
  catch2 libbenchmark-dev python3                        # tests and benchmarks
  libdxflib-dev                                          # whose colours ours are compared with
  povray                                                 # the renderer that ours is compared with
  mosquitto                                              # the broker that MQTT is tested with
)

device_packages=(
  g++-aarch64-linux-gnu g++-arm-linux-gnueabihf          # what boards run is compiled with these
  qemu-user-static                                       # and tested in this
  qemu-system-arm qemu-system-x86 kmod busybox-static    # whole boards, with their kernels
)

missing=()
for package in "${packages[@]}" "${test_packages[@]}" "${device_packages[@]}"; do
  status=$(dpkg-query -W -f='${db:Status-Status}' "$package" 2>/dev/null || true)
  [ "$status" = installed ] || missing+=("$package")
done
if [ ${#missing[@]} -eq 0 ]; then
  echo "setup: all packages are installed"
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
