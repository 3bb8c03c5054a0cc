# shellcheck shell=bash disable=SC2034,SC2154
# Sourced by the scripts beside it: commands that are shown, timed and counted, checks that are told.
commands=0
command_seconds=0
checks=0
failed=()

stop() {
  echo "clean_room: failed: $1"
  exit 1
}

# try WORD COMMAND...: shows what a newcomer types, runs COMMAND, and says how long it took. What it
# said is then in $said.
try() {
  local typed=$1 begin end
  shift
  echo
  echo "\$ $typed"
  commands=$((commands + 1))
  begin=$(date +%s%N)
  if ! "$@" >"$log" 2>&1; then
    tail -n 30 "$log"
    stop "$typed"
  fi
  end=$(date +%s%N)
  said=$(cat "$log")
  tail -n 3 "$log" | cut -c1-160
  command_seconds=$(awk "BEGIN { print $command_seconds + ($end - $begin) / 1e9 }")
  awk "BEGIN { printf \"  [%.1f s]\n\", ($end - $begin) / 1e9 }"
}

# check SENTENCE COMMAND...
check() {
  local sentence=$1
  shift
  checks=$((checks + 1))
  if "$@" >"$log" 2>&1; then
    echo "  ok: $sentence"
  else
    echo "  NOT: $sentence"
    head -n 20 "$log" | sed 's/^/    /'
    failed+=("$sentence")
  fi
}

not() { ! "$@"; }
nothing() { ! grep .; }
