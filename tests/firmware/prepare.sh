#!/usr/bin/env bash
# What the firmware tests feed and boot. What is newer than what it is made of is kept.
# usage: prepare.sh inputs FOLDER ASPECTC MAKE_RAW_FRAMES COMPILED
#          recorded frames, and indexes: those of the folder COMPILED where another test left them
#        prepare.sh rootfs FOLDER ARCH PROCESSOR
#          aspectd for PROCESSOR, and kernel and root file system for ARCH, as dpkg names it
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
root=$(cd "$here/../.." && pwd)
rendered=$root/tests/data/rendered

make_frames() {
  local folder=$1 make_raw_frames=$2
  # Two of each object.
  local pictures=(000 001 002 003 004 022 026 030 043 054)
  if [ "$make_raw_frames" -nt "$folder/small.64x48.RGB3" ]; then
    pictures=("${pictures[@]/#/$rendered/frames/}")
    "$make_raw_frames" "$folder" "${pictures[@]/%/.png}"
  fi
}

make_indexes() {
  local folder=$1 aspectc=$2 compiled=$3 object
  for object in blockcyl1 blockcyl2 cube l_shape pegblock; do
    if [ "$folder/$object.aspect" -nt "$aspectc" ]; then
      continue
    elif [ "$compiled/$object.aspect" -nt "$aspectc" ]; then
      cp "$compiled/$object.aspect" "$folder"
    else
      "$aspectc" "$rendered/$object.b" -o "$folder/$object.aspect" --no-store --level 4 --progress never
    fi
  done
}

make_rootfs() {
  local image=$1/rootfs-$2 arch=$2 aspectd=$root/build/device-$3/bin/stripped/aspectd
  "$root/tools/device_build.sh" "$3"
  if [ -e "$image" ] && [ -z "$(find "$aspectd" "$root/firmware_configs/rootfs" -newer "$image")" ]; then
    return
  fi
  "$root/firmware_configs/rootfs/make_rootfs.sh" --arch "$arch" --aspectd "$aspectd" \
    --packages "$root/build/firmware/packages" --output "$image" \
    --module virtio_pci --module virtio_console \
    --module "vivid n_devs=1 node_types=0x101 num_inputs=2 input_types=0xc num_outputs=1 output_types=1"
}

mkdir -p "$2"/{frames,indexes}
case $1 in
  inputs)
    make_frames "$2/frames" "$4"
    make_indexes "$2/indexes" "$3" "$5"
    ;;
  rootfs) make_rootfs "$2" "$3" "$4" ;;
  *)
    echo "prepare: see the head of this file" >&2
    exit 2
    ;;
esac
