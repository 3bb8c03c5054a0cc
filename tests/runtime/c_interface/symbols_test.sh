#!/usr/bin/env bash
# libaspect.so shows what aspect.h declares and nothing else, and needs nothing of the compiler.
# usage: symbols_test.sh SOURCE_DIR libaspect.so
set -euo pipefail
shown=$(nm -D --defined-only "$2" | awk '$2 != "A" { sub(/@.*/, "", $3); print $3 }' | sort)
declared=$(grep -o '^ASPECT_API [^(]*(' "$1/runtime/c_interface/aspect.h" |
  sed 's/($//; s/.*[ *]//' | sort)
[ "$(echo "$declared" | wc -l)" -ge 10 ] || { echo "few functions in aspect.h: is this it?"; exit 1; }
diff <(echo "$declared") <(echo "$shown") ||
  { echo "< declared in aspect.h, > shown by the library; see runtime/c_interface/libaspect.map"; exit 1; }
if readelf -d "$2" | grep -E 'NEEDED.*(opencv|embree|sqlite|assimp|tbb|TK|mosquitto)'; then
  echo "libaspect.so needs a library that is not for devices"; exit 1
fi
for language in "-x c -std=c99" "-x c -std=c11" "-x c++ -std=c++11" "-x c++ -std=c++20"; do
  # shellcheck disable=SC2086
  echo '#include <aspect.h>' | ${CC:-cc} $language -I "$1/runtime/c_interface" -Wall -Wextra \
    -Wpedantic -Werror -fsyntax-only -
done
echo "$(echo "$shown" | wc -l) functions"
