# shellcheck shell=bash disable=SC2034,SC2154
# Sourced: a Debian 12 of its own, from where this machine's apt has its packages.

# suites: of Debian, a line each, as "ADDRESS SUITE"
suites() {
  # shellcheck disable=SC2016  # apt's own placeholders
  apt-get indextargets --format '$(ORIGIN) $(COMPONENT) $(REPO_URI) $(RELEASE)' 'Created-By: Packages' |
    sed -n 's/^Debian main //p' | sort -u
}

# make_chroot ROOT ARCHIVES: bare; what was fetched once is kept in ARCHIVES
make_chroot() {
  local root=$1 archives=$2 mirror
  mirror=$(suites | awk '$2 == "bookworm" { print $1; exit }')
  [ -n "$mirror" ] || stop "apt on this machine knows no packages of Debian 12 (bookworm)"
  rm -rf --one-file-system "$root"
  mkdir -p "$root" "$archives/base" "$archives/apt/partial"
  debootstrap --variant=minbase --cache-dir="$archives/base" bookworm "$root" "$mirror" >"$log" 2>&1 ||
    { tail -n 5 "$log"; stop "debootstrap"; }
  suites | awk '{ print "deb", $1, $2, "main" }' >"$root/etc/apt/sources.list"
  cp -L /etc/resolv.conf "$root/etc/resolv.conf"
  [ ! -e /etc/hosts ] || cp -L /etc/hosts "$root/etc/hosts"
  {
    apt-config dump | grep -E '^Acquire::(http|https|Check-Valid-Until)' || true
    # Not what a newcomer has, and changes nothing but what a second run fetches.
    echo 'APT::Sandbox::User "root";'
    echo 'Binary::apt::APT::Keep-Downloaded-Packages "true";'
  } >"$root/etc/apt/apt.conf.d/90clean-room"
}

# within ROOT ARCHIVES COMMAND: in a mount namespace of its own, which takes all mounts with it
within() {
  # shellcheck disable=SC2016
  unshare --mount --fork bash -c '
    set -e
    root=$1 archives=$2
    mount -t proc proc "$root/proc"
    mount -t sysfs -o ro sysfs "$root/sys"
    mount -t tmpfs tmpfs "$root/tmp"
    mount --bind "$archives/apt" "$root/var/cache/apt/archives"
    exec chroot "$root" env -i HOME=/root TERM=dumb LC_ALL=C.UTF-8 DEBIAN_FRONTEND=noninteractive \
      PATH=/usr/sbin:/usr/bin:/sbin:/bin bash -c "cd /root; $3"
  ' within "$@"
}
