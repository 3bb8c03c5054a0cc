# For the scripts that run in the guest: `run . /test/steps; STEP` in a feeder's script. Everything
# that is worth a time goes into $log with that time in front, in seconds of CLOCK_MONOTONIC.
log=/run/results/${name:=aspectd}.log

# The daemon with /test/NAME.toml; its lines and its log are stamped.
start_aspectd() {
  rm -f /run/lines /run/errors
  mkfifo /run/lines /run/errors
  stamp line </run/lines >>"$log" &
  stamp log </run/errors >>"$log" &
  (
    echo aspectd | stamp exec >>"$log"
    status=0
    sh -c 'echo $$ >/run/pid; exec aspectd --config "$1"' - "/test/$name.toml" \
      >/run/lines 2>/run/errors || status=$?
    echo "$status" >"/run/results/$name.status"
  ) &
}

# Ends it in order, at most 5 s long.
stop_aspectd() {
  sample stop
  kill -TERM "$(cat /run/pid)"
  for _ in $(seq 500); do
    [ ! -e "/run/results/$name.status" ] || return 0
    usleep 10000
  done
  echo "aspectd does not end" | stamp stop >>"$log"
  kill -KILL "$(cat /run/pid)"
}

# One line: descriptors, memory in KiB. Rss is counted by walking the pages: exact.
sample() {
  process=/proc/$(cat /run/pid)
  echo "$1 descriptors=$(ls "$process/fd" | wc -l)" \
    "rss=$(awk '/^Rss:/ {print $2}' "$process/smaps_rollup")" \
    "peak=$(awk '/^VmHWM:/ {print $2}' "$process/status")" | stamp sample >>"$log"
}

# From begin to end, the system calls of aspectd's loop: the kernel's trace of them.
trace_calls() {
  tracing=/sys/kernel/tracing
  entries=$tracing/events/raw_syscalls/sys_enter/enable
  case $1 in
    begin)
      [ -e $entries ] || mount -t tracefs tracefs $tracing
      cat /run/pid >$tracing/set_event_pid
      echo 1 >$entries
      ;;
    end)
      echo 0 >$entries
      cat $tracing/trace >/run/results/calls.txt
      ;;
  esac
}

# Once more, with other parameters than the image's.
load_vivid() {
  for _ in $(seq 300); do
    if modprobe -r vivid 2>/dev/null; then break; fi
    usleep 10000
  done
  modprobe vivid n_devs=1 node_types=0x101 num_inputs=2 input_types=0xc num_outputs=1 \
    output_types=1 "$@"
}
