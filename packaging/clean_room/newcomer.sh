#!/usr/bin/env bash
# shellcheck disable=SC1091,SC2154
# A newcomer's way with a workstation's packages, in a Debian of its own, and that nothing stays
# behind. Leaves the index and the exact results for boards in OUTPUT. Its last line is a summary.
# usage: newcomer.sh PACKAGES FOLDER OUTPUT   (as root; tools/clean_room.sh calls it)
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
source=$(cd "$here/../.." && pwd)
packages=$1
folder=$2
output=$3
root=$folder/amd64
archives=$folder/archives
mkdir -p "$folder" "$output"
log=$folder/log
. "$here/steps.sh"
. "$here/chroot.sh"

echo "== a clean Debian 12"
begin=$(date +%s)
make_chroot "$root" "$archives"
within "$root" "$archives" "apt-get -q update" >"$log" 2>&1 || { tail -n 3 "$log"; stop "apt-get update"; }
echo "made in $(($(date +%s) - begin)) s"
cp "$packages"/*_amd64.deb "$packages"/*_all.deb "$root/root"
cp "$here"/cube.obj "$here"/cube.mtl "$here"/exact_results.c "$root/root"
python3 "$source/tests/packaging/ppm_of_png.py" "$source/tests/data/rendered/frames/030.png" "$root/root/frame.ppm"
step_file=$(find "$source/tests" "$source/compiler" \( -name '*.step' -o -name '*.stp' \) -size +1k 2>/dev/null | sort | head -n 1)

inside() { within "$root" "$archives" "$1"; }
type_in() { try "$1" inside "$1"; }
saw_cube() { grep -q "$1" <<<"$said"; }

echo
echo "== a newcomer's way"
# What the C example wants is installed along: not everybody writes C.
type_in "apt install -y ./*.deb gcc libc6-dev pkgconf"
type_in "aspectc cube.obj -o cube.aspect"
step_note="no STEP"
if [ -z "$step_file" ]; then
  echo "  skipped: STEP, of which there is no sample in tests/"
elif ! inside "ls /usr/lib/aspect/aspect_step.so" >/dev/null 2>&1; then
  echo "  skipped: STEP, which this aspect-compiler was built without"
else
  cp "$step_file" "$root/root/part.step"
  type_in "aspectc part.step --missing-colour 0.7,0.7,0.7 -o part.aspect"
  step_note="with STEP"
fi
type_in "aspect-replay --index cube.aspect /usr/share/aspect/rendered/frames/030.png"
check "the frame is named" saw_cube '"verdict":"match".*"object":"cube".*"pose"'
# shellcheck disable=SC2016
type_in 'gcc /usr/share/doc/libaspect-dev/examples/recognise.c $(pkg-config --cflags --libs aspect) -o recognise && ./recognise cube.aspect frame.ppm'
check "the C example names it" saw_cube '^cube [01]'
python_note="no python3-aspect"
if ls "$packages"/python3-aspect_*_amd64.deb >/dev/null 2>&1; then
  type_in "python3 -c \"import aspect, numpy; print(aspect.Recogniser('cube.aspect', format='rgb').recognise(numpy.fromfile('frame.ppm', 'uint8')[15:].reshape(512, 512, 3)))\""
  check "Python names it" saw_cube 'aspect.Object cube, match'
  python_note="with Python"
fi
ours="aspect-compiler libaspect libaspect-dev aspectd aspect-doc"
[ "$python_note" = "no python3-aspect" ] || ours+=" python3-aspect"
newcomer_commands=$commands
newcomer_seconds=$command_seconds

echo
echo "== what else should work"
check "the C example builds with CMake" inside "apt-get -q -y install cmake make >/dev/null && cmake -S /usr/share/doc/libaspect-dev/examples -B build && cmake --build build && build/recognise cube.aspect frame.ppm | grep '^cube '"
check "exact results are printed" inside "gcc exact_results.c \$(pkg-config --cflags --libs aspect) -o exact_results && ./exact_results cube.aspect frame.ppm >exact"
cp "$root/root/cube.aspect" "$root/root/frame.ppm" "$root/root/exact" "$output"
check "every program tells its version" inside "for p in aspectc aspect-replay aspect-eval aspect-export aspect-report aspect-score aspect-calibrate aspectd; do \$p --version | grep '[0-9]\\.[0-9]' || exit 1; done"
check "aspectd reads an example, up to the camera that is not here" inside "sed 's/part.aspect/cube.aspect/' /usr/share/doc/aspectd/examples/x86_box.toml >x86_box.toml; aspectd --config x86_box.toml --check 2>&1 | grep '^aspectd: camera /dev/video0: '"
check "the service's user is there and can do nothing else" inside "getent passwd aspectd | grep /nologin && id -nG aspectd | grep -w video"
check "the unit is understood" inside "systemd-analyze verify --man=no aspectd.service"
check "installing again is quiet" inside "dpkg -i ./aspectd_*.deb ./libaspect_*.deb"
check "every file is as it was packed" inside "! dpkg -V $ours | grep ."

echo
echo "== and away again"
inside "dpkg -L $ours | sort -u" >"$folder/ours"
inside "systemctl enable aspectd; install -d /var/lib/aspect; echo indexes = [] >/etc/aspect/aspectd.toml" >"$log" 2>&1
check "they are purged" inside "apt purge -y $ours"
check "dpkg knows none of them" inside "! dpkg-query -W -f '\${Package} \${db:Status-Status}\\n' $ours 2>/dev/null | grep -v not-installed | grep ."
still_there() {
  local file
  while read -r file; do
    # Folders that others have as well.
    if [ -e "$root$file" ] && { [ ! -d "$root$file" ] || [[ $file == *aspect* && $file != /etc/aspect ]]; }; then echo "$file"; fi
  done <"$folder/ours" | grep .
}
check "none of their files is there" not still_there
check "the owner's own configuration is" inside "rm /etc/aspect/aspectd.toml && rmdir /etc/aspect"
check "nothing else has its name" inside "! find / -xdev -iname '*aspect*' -not -path '/root/*' -not -path '/var/cache/apt/*' -not -path '*/aspectratio*' | grep ."
check "the user stays, as Debian has it, and owns nothing" inside "getent passwd aspectd && ! find / -xdev -user aspectd | grep ."

rm -rf --one-file-system "$root"
[ ${#failed[@]} -eq 0 ] || stop "${failed[0]}"
[ "$newcomer_commands" -le 6 ] || stop "$newcomer_commands commands, where a newcomer should need six"
awk "BEGIN { exit !($newcomer_seconds <= 600) }" || stop "$newcomer_seconds s, where a newcomer should need no more than 600"
awk "BEGIN { printf \"newcomer: $newcomer_commands commands in %.0f s, $step_note, $python_note, $checks checks\n\", $newcomer_seconds }"
