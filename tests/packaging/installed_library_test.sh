#!/usr/bin/env bash
# Projects outside the tree build with the installed library, by CMake and by pkg-config, in C and in
# C++, and find a cube in a frame that POV-Ray rendered, where it stands: 1 before the camera.
# usage: installed_library_test.sh BUILD LIBDIR ASPECTC
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
source=$(cd "$here/../.." && pwd)
build=$1
libdir=$2
aspectc=$3
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
fail() { echo "$1" >&2; exit 1; }
cd "$folder"

for component in lib dev; do
  cmake --install "$build" --prefix "$folder/first" --component $component >/dev/null
done
# What is installed may be moved.
mv first prefix
example=prefix/share/doc/libaspect-dev/examples
[ "$(wc -l <$example/recognise.c)" -le 32 ] || fail "the example is longer than 32 lines"

"$aspectc" "$source/compiler/models/cube.b" --level 1 --no-store --progress never -o cube.aspect >/dev/null
python3 "$here/ppm_of_png.py" "$source/tests/data/rendered/frames/030.png" frame.ppm

build_out_of_tree() {
  { cmake -S "$1" -B "$2" -G Ninja -DCMAKE_C_COMPILER_WORKS=ON \
      -DCMAKE_CXX_COMPILER_WORKS=ON "-DCMAKE_PREFIX_PATH=$folder/prefix" && cmake --build "$2"; } >log 2>&1 ||
    { cat log; fail "$1 does not build"; }
}
build_out_of_tree $example by_cmake
build_out_of_tree "$here/consumer" cpp_by_cmake

export PKG_CONFIG_PATH=$folder/prefix/$libdir/pkgconfig
read -ra flags < <(pkg-config --cflags --libs aspect)
cc -std=c99 -Wall -Wextra -Werror $example/recognise.c "${flags[@]}" -o by_pkg_config

export LD_LIBRARY_PATH=$folder/prefix/$libdir
for program in by_cmake/recognise cpp_by_cmake/consumer ./by_pkg_config; do
  said=$($program cube.aspect frame.ppm)
  echo "$program: $said"
  awk '$1 == "cube" && $2 > 0.5 && $4^2 < 0.0001 && $5^2 < 0.0001 && ($6 - 1)^2 < 0.0001 { right = 1 }
    END { exit !(right && NR == 1) }' <<<"$said" || fail "not a cube at 0 0 1"
done
