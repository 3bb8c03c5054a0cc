#!/usr/bin/env bash
# Every component installs what installed_files.txt says, and nothing else; the service names the
# program where it is installed.
# usage: installed_files_test.sh BUILD LIBDIR
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
build=$1
libdir=$2
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
wrong=0
say() { echo "$1"; wrong=1; }

sed -E '/^#/d; s|LIBDIR|'"$libdir"'|; s/^([a-z]+) +\? +/\1 ? /; s/^([a-z]+) +([^? ])/\1 ! \2/' \
  "$here/installed_files.txt" >"$folder/expected"
for component in $(cut -d' ' -f1 "$folder/expected" | uniq); do
  cmake --install "$build" --prefix "$folder/$component" --component "$component" >/dev/null
  files=()
  [ ! -e "$folder/$component" ] || mapfile -t files < <(cd "$folder/$component" && find . ! -type d | sed 's|^\./||' | sort)
  declare -A explained=()
  while read -r _ kind pattern; do
    met=0
    for file in "${files[@]}"; do
      # shellcheck disable=SC2053  # a pattern is meant
      [[ $file == $pattern ]] || continue
      met=1
      explained[$file]=1
    done
    [ $met = 1 ] || [ "$kind" = '?' ] || say "$component does not install $pattern"
  done < <(grep "^$component " "$folder/expected")
  for file in "${files[@]}"; do
    [ -n "${explained[$file]-}" ] || say "$component installs $file, of which installed_files.txt does not say so"
  done
  echo "$component: ${#files[@]} files"
  unset explained
done

prefix=$(sed -n 's/^CMAKE_INSTALL_PREFIX:PATH=//p' "$build/CMakeCache.txt")
service=$folder/aspectd/lib/systemd/system/aspectd.service
grep -q "^ExecStart=${prefix%/}/bin/aspectd " "$service" || say "ExecStart is not ${prefix%/}/bin/aspectd"
! grep -q '^# Install as' "$service" || say "the installed service says where to install it"
exit $wrong
