#!/usr/bin/env bash
# Fetches Debian packages of any architecture and unpacks them, without installing anything and
# without telling this machine of another architecture: the lists of packages are kept in FOLDER.
# Sources and keys are those of this machine. What is there already is not fetched again; remove
# FOLDER/ARCH to have newer ones. No root needed.
# usage: fetch_packages.sh ARCH FOLDER PACKAGE...
#   ARCH     as dpkg names it: amd64, arm64, armhf
#   PACKAGE  unpacked into FOLDER/ARCH/PACKAGE; linux-image-ARCH is the newest kernel of that name
set -euo pipefail

fail() {
  echo "fetch_packages: $1" >&2
  exit 1
}

[ $# -ge 3 ] || fail "usage: fetch_packages.sh ARCH FOLDER PACKAGE..."
arch=$1
mkdir -p "$2/$arch" || fail "$2/$arch cannot be made"
folder=$(cd "$2/$arch" && pwd)
shift 2

# Two tests may want the same packages.
exec 9>"$folder/lock"
flock 9

missing=()
for package in "$@"; do
  [ -e "$folder/$package/.complete" ] || missing+=("$package")
done
[ ${#missing[@]} -gt 0 ] || exit 0

apt_folder=$folder/apt
mkdir -p "$apt_folder/lists/partial" "$apt_folder/cache/archives/partial"
: >"$apt_folder/status"
options=(
  -q -o "Dir::State=$apt_folder" -o "Dir::State::status=$apt_folder/status"
  -o "Dir::Cache=$apt_folder/cache" -o "APT::Architecture=$arch" -o "APT::Architectures=$arch"
  -o APT::Sandbox::User=root
)

# run WHAT COMMAND...: silent; one line where it fails
run() {
  local what=$1
  shift
  "$@" >"$apt_folder/log" 2>&1 ||
    fail "$what: $(grep -aE '^[EW]: ' "$apt_folder/log" | head -n 1 | grep . || tail -n 1 "$apt_folder/log")"
}

# A list that its server is just renewing is no reason to give up: the others may do.
apt-get "${options[@]}" update >"$apt_folder/log" 2>&1 ||
  echo "fetch_packages: not all package lists of $arch could be had" >&2

# The kernel's package without a version depends on the newest one with a version.
resolve() {
  local newest=
  case $1 in
    linux-image-*)
      newest=$(apt-cache "${options[@]}" depends "$1" 2>/dev/null |
        sed -n 's/^ *Depends: \(linux-image-.*\)/\1/p' | head -n 1)
      ;;
  esac
  echo "${newest:-$1}"
}

for package in "${missing[@]}"; do
  name=$(resolve "$package")
  rm -rf "$apt_folder/download" "$apt_folder/tree"
  mkdir -p "$apt_folder/download" "$apt_folder/tree"
  cd "$apt_folder/download"
  run "$package of $arch cannot be fetched" apt-get "${options[@]}" download "$name"
  run "$name of $arch cannot be unpacked" dpkg-deb -x ./*.deb "$apt_folder/tree"
  basename ./*.deb >"$apt_folder/tree/.complete"
  cd "$folder"
  rm -rf "$apt_folder/download" "${folder:?}/$package"
  mv "$apt_folder/tree" "$folder/$package"
done
