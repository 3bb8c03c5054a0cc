#!/usr/bin/env bash
# shellcheck disable=SC1091,SC2154
# A board's packages in a root file system of its processor, run in an emulator of that processor's
# programs. apt says what they need and fetches it; all of it is unpacked, but nobody's scripts are run:
# that needs a kernel that starts programs of another processor. Its last line is a summary.
# usage: board.sh arm64|armhf PACKAGES FOLDER OUTPUT   (as root; tools/clean_room.sh calls it)
#   OUTPUT   of newcomer.sh: an index that an x86-64 compiled, a frame, and what an x86-64 saw in it
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
processor=$1
packages=$2
folder=$3
output=$4
root=$folder/$processor
log=$folder/log
. "$here/steps.sh"
case $processor in
  arm64) triplet=aarch64-linux-gnu emulator=qemu-aarch64-static ;;
  armhf) triplet=arm-linux-gnueabihf emulator=qemu-arm-static ;;
esac
for program in $emulator $triplet-gcc; do
  command -v "$program" >/dev/null || stop "$program is not there; run tools/clean_room.sh --setup"
done

echo "== a root file system of $processor"
apt_folder=$folder/apt-$processor
mkdir -p "$apt_folder/lists/partial" "$apt_folder/cache/archives/partial"
: >"$apt_folder/status"
options=(-q -y -o "Dir::State=$apt_folder" -o "Dir::State::status=$apt_folder/status"
  -o "Dir::Cache=$apt_folder/cache" -o "APT::Architecture=$processor" -o "APT::Architectures=$processor"
  -o APT::Sandbox::User=root -o Debug::NoLocking=1)
# A list that its server is just renewing is there a moment later, or not needed.
apt-get "${options[@]}" update >"$log" 2>&1 || { sleep 5 && apt-get "${options[@]}" update >"$log" 2>&1; } ||
  echo "not all package lists of $processor could be had"
ours=("$packages"/aspectd_*_"$processor".deb "$packages"/libaspect_*_"$processor".deb "$packages"/libaspect-dev_*_"$processor".deb)
rm -f "$apt_folder"/cache/archives/aspect*.deb
check "apt finds all that they need" apt-get "${options[@]}" --no-install-recommends --download-only install "${ours[@]}" base-files libc-bin
[ ${#failed[@]} -eq 0 ] || stop "${failed[0]}"
rm -rf --one-file-system "$root"
mkdir -p "$root"
needed=0
for package in "$apt_folder"/cache/archives/*.deb; do
  case $(basename "$package") in aspect*|libaspect*) continue ;; esac
  dpkg-deb --fsys-tarfile "$package" | tar -x -C "$root" --keep-directory-symlink
  needed=$((needed + 1))
done
mkdir -p "$root/var/lib/dpkg/info" "$root/var/lib/dpkg/updates"
touch "$root/var/lib/dpkg/status" "$root/var/lib/dpkg/available"
echo "$processor" >"$root/var/lib/dpkg/arch"
check "dpkg unpacks them beside $needed others" dpkg --root="$root" --force-architecture --force-depends --unpack "${ours[@]}"

run() { "$emulator" -L "$root" "$@"; }
check "aspectd tells its version" bash -c "$emulator -L '$root' '$root/usr/bin/aspectd' --version | grep '[0-9]\\.[0-9]'"
check "aspectd is static" bash -c "! readelf -d '$root/usr/bin/aspectd' | grep NEEDED"
check_camera() {
  sed "s|part.aspect|$output/cube.aspect|" "$root/usr/share/doc/aspectd/examples/raspberry_pi_4.toml" >"$folder/board.toml"
  sed -i 's|^device = .*|device = "/dev/no-such-camera"|' "$folder/board.toml"
  ! run "$root/usr/bin/aspectd" --config "$folder/board.toml" --check >"$folder/checked" 2>&1 || return 1
  cat "$folder/checked"
  grep -q '^index: cube' "$folder/checked" && grep -q '^aspectd: camera /dev/no-such-camera: ' "$folder/checked"
}
check "aspectd --check reads an example and an index, up to the camera that is not here" check_camera
link_and_run() {
  "$triplet-gcc" "$here/exact_results.c" -I "$root/usr/include" -L "$root/usr/lib/$triplet" -laspect \
    -Wl,-rpath-link,"$root/usr/lib/$triplet:$root/lib/$triplet" -o "$folder/exact_results" || return 1
  # The root's own libraries, those of the build machine not.
  run "$folder/exact_results" "$output/cube.aspect" "$output/frame.ppm" >"$folder/exact"
}
check "a program links with libaspect and recognises a frame" link_and_run
check "it sees to the last bit what an x86-64 sees" cmp "$folder/exact" "$output/exact"
check "dpkg removes them" dpkg --root="$root" --force-architecture --purge libaspect-dev libaspect
check "nothing of the library stays" bash -c "! find '$root' -name '*libaspect*' | grep ."

rm -rf --one-file-system "$root"
[ ${#failed[@]} -eq 0 ] || stop "${failed[0]}"
echo "$processor: $checks checks, unpacked and emulated, scripts not run"
