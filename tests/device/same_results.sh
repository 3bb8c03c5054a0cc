#!/usr/bin/env bash
# Frames through aspect-replay of the workstation and through the static ones for boards, in an
# emulator where it is another processor: the same lines, byte for byte but for the times.
# Also that aspectd weighs less than 3 MiB everywhere.
# usage: same_results.sh BIN RESULTS x86_64|arm64|armhf...
#   BIN      the workstation's programs, with make_raw_frames
#   RESULTS  of native_results.sh: two indexes are taken from there
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
bin=$1
indexes=$2/samples
shift 2
cd "$here/../.."
folder=$PWD/build/device-frames
rm -rf "$folder"
mkdir -p "$folder"

pictures=(tests/data/rendered/frames/0{00,01,02,03,22}.png)
"$bin/make_raw_frames" "$folder" "${pictures[@]}"
{ printf 'P6\n640 480\n255\n'; head -c $((640 * 480 * 3)) "$folder/frames.640x480.RGB3"; } >"$folder/first.ppm"

# recognise OUTPUT PROGRAM...: without what differs from run to run
recognise() {
  local output=$1
  shift
  "$@" --index "$indexes/cube3" --index "$indexes/l_shape3" --config tests/data/rendered/camera.toml \
    "$folder" >"$output.raw" 2>"$output.log" || { cat "$output.log" >&2; exit 1; }
  sed -E 's/"elapsed_ms":[^,]*,//; s/"stages_ms":\{[^}]*\},?//' "$output.raw" >"$output"
}

tools/device_build.sh "$@" >"$folder.log" 2>&1 || { cat "$folder.log" >&2; exit 1; }
grep KiB "$folder.log"
failed=0
for processor in "$@"; do
  bytes=$(stat -c %s "build/device-$processor/bin/stripped/aspectd")
  [ "$bytes" -lt $((3 << 20)) ] || { echo "$processor: aspectd has 3 MiB or more" >&2; failed=1; }
done
recognise "$folder.native" "$bin/aspect-replay"
grep -q '"score"' "$folder.native" || { echo "nothing was recognised" >&2; exit 1; }
for processor in "$@"; do
  emulator=()
  case "$processor" in
    arm64) emulator=(qemu-aarch64-static) ;;
    armhf) emulator=(qemu-arm-static) ;;
  esac
  begin=$SECONDS
  recognise "$folder.$processor" "${emulator[@]}" "build/device-$processor/bin/stripped/aspect-replay"
  if cmp "$folder.native" "$folder.$processor"; then
    echo "$processor: $(wc -l <"$folder.native") frames alike, $((SECONDS - begin)) s"
  else
    diff "$folder.native" "$folder.$processor" | cut -c 1-400 >&2 || true
    failed=1
  fi
done

# refused WHAT ARGUMENT...: in one line that holds WHAT
refused() {
  local what=$1 said
  shift
  said=$(build/device-x86_64/bin/stripped/aspect-replay --index "$indexes/cube3" "$@" 2>&1) && failed=1
  if [ "$(wc -l <<<"$said")" != 1 ] || ! grep -qFe "$what" <<<"$said"; then
    echo "instead of '$what': $said" >&2
    failed=1
  fi
}
if [ -x build/device-x86_64/bin/stripped/aspect-replay ]; then
  refused '--overlay: pictures are drawn on workstations only' --overlay "$folder/none" "$folder/first.ppm"
  refused '--dump: pictures are drawn on workstations only' --dump "$folder/none" "$folder/first.ppm"
  refused 'not a picture that is read here' tests/data/rendered/frames/000.png
  cp "$folder/first.ppm" "$folder.avi"
  refused 'a video, which is read only where libopencv-videoio-dev was found' "$folder.avi"
fi
exit $failed
