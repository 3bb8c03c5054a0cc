#!/usr/bin/env bash
# systemd's own opinion of the unit: every line understood, and little that the service could do
# to the system that it runs on.
# usage: systemd_unit_test.sh UNIT
set -euo pipefail
most=2.5  # systemd rates from 0, safe, to 10; 2.0 was measured with version 252
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
# The program need not be installed here.
sed 's|^ExecStart=[^ ]*|ExecStart=/bin/true|' "$1" >"$folder/aspectd.service"

said=$(systemd-analyze verify --man=no "$folder/aspectd.service" 2>&1) || { echo "$said" >&2; exit 1; }
[ -z "$said" ] || { echo "$said" >&2; exit 1; }

rating=$(systemd-analyze security --offline=true --no-pager "$folder/aspectd.service")
exposure=$(sed -nE 's/.*Overall exposure level for [^:]*: ([0-9.]+).*/\1/p' <<<"$rating")
echo "exposure: $exposure of 10"
awk -v exposure="$exposure" -v most="$most" 'BEGIN { exit !(exposure > 0 && exposure <= most) }' ||
  { grep -v '✓' <<<"$rating" >&2; exit 1; }
