#!/usr/bin/env bash
# Makes a root file system whose only service is aspectd, as an archive that the kernel unpacks
# into memory (an initramfs): nothing on the board's storage is ever written.
# usage: make_rootfs.sh --arch ARCH --aspectd PROGRAM --packages FOLDER --output FILE
#                       [--overlay FOLDER] [--module "NAME [PARAMETER...]"]...
#   --arch      as dpkg names it: amd64, arm64
#   --aspectd   a static build for it
#   --packages  where kernel and busybox are, or are fetched to (fetch_packages.sh)
#   --output    FILE; the kernel that belongs to it is put beside it as FILE.kernel
#   --overlay   laid over the tree: etc/aspect/aspectd.toml, the indexes, more files
#   --module    loaded at start, in this order, each after those that it depends on;
#               none: those of USB cameras
set -euo pipefail

fail() {
  echo "make_rootfs: $1" >&2
  exit 1
}

here=$(cd "$(dirname "$0")" && pwd)
arch='' aspectd='' packages='' output='' overlay='' modules=()
while [ $# -gt 0 ]; do
  [ $# -ge 2 ] || fail "$1 needs a value"
  case $1 in
    --arch) arch=$2 ;;
    --aspectd) aspectd=$2 ;;
    --packages) packages=$2 ;;
    --output) output=$2 ;;
    --overlay) overlay=$2 ;;
    --module) modules+=("$2") ;;
    *) fail "$1 is not an option; see the head of this file" ;;
  esac
  shift 2
done
[ -n "$arch" ] && [ -n "$aspectd" ] && [ -n "$packages" ] && [ -n "$output" ] ||
  fail "--arch, --aspectd, --packages and --output are needed"
[ -f "$aspectd" ] || fail "$aspectd is not there: build aspectd for $arch first"
[ -z "$overlay" ] || [ -d "$overlay" ] || fail "$overlay is not a folder"
[ ${#modules[@]} -gt 0 ] || modules=(xhci-pci xhci-plat-hcd ehci-pci dwc2 uvcvideo)
PATH=$PATH:/usr/sbin:/sbin
command -v depmod >/dev/null || fail "depmod is not there: install the package kmod"
command -v busybox >/dev/null || fail "busybox is not there: install the package busybox-static"

"$here/fetch_packages.sh" "$arch" "$packages" "linux-image-$arch" busybox-static
kernel_tree=$packages/$arch/linux-image-$arch
version=$(ls "$kernel_tree/lib/modules")
kernel_modules=$kernel_tree/lib/modules/$version
[ -e "$kernel_modules/modules.dep" ] || depmod -b "$kernel_tree" "$version"

tree=$(mktemp -d)
trap 'rm -rf "$tree"' EXIT
chmod 755 "$tree"
cp -R "$here/skeleton/." "$tree"
mkdir -p "$tree"/{bin,dev,proc,sys,run,tmp,usr/bin,etc/aspect,etc/start.d}
install -m 755 "$packages/$arch/busybox-static/bin/busybox" "$tree/bin/busybox"
ln -s bin/busybox "$tree/init"
install -m 755 "$aspectd" "$tree/usr/bin/aspectd"

# copy_module NAME: with what it depends on, as modules.dep says. What is built in needs no copy.
copy_module() {
  local name=${1//-/_} line file
  if grep -qE "/${name//_/[-_]}\.ko$" "$kernel_modules/modules.builtin"; then return; fi
  line=$(grep -E "/${name//_/[-_]}\.ko:" "$kernel_modules/modules.dep") ||
    fail "linux-image-$arch has no module $1"
  for file in ${line/:/}; do
    install -D -m 644 "$kernel_modules/$file" "$tree/lib/modules/$version/$file"
  done
}
for module in "${modules[@]}"; do
  copy_module "${module%% *}"
  echo "$module" >>"$tree/etc/modules"
done
cp "$kernel_modules"/modules.{builtin,builtin.modinfo,order} "$tree/lib/modules/$version/"
depmod -b "$tree" "$version"

[ -z "$overlay" ] || cp -R "$overlay/." "$tree"
mkdir -p "$(dirname "$output")"
(cd "$tree" && find . | LC_ALL=C sort | busybox cpio -o -H newc -R 0:0 2>/dev/null) |
  gzip -1 -n >"$output.part"
cp "$kernel_tree"/boot/vmlinuz-* "$output.kernel"
mv "$output.part" "$output"
