#!/usr/bin/env python3
"""aspectd as it is operated, on a camera that works: checked, started, reloaded with a good and with
a bad configuration, read by some who stand still; and which system calls its loop makes."""

import json
import re
from collections import Counter

import daemon_contract as contract
from context import check, run

WIDTH, HEIGHT, FOURCC = 640, 480, "YUYV"
FRAMES = "frames.%dx%d.%s" % (WIDTH, HEIGHT, FOURCC)
FRAME_S = 1 / 59.94
PORT = 7200
PRIORITY = 20
PEAK_KIB = 8 * 1024
FIRST_TOP, SECOND_TOP = 1, 5

# vivid knows brightness, contrast up to 255, and no sharpness.
# A part of the picture only, so that a frame takes less than its period.
EXTRA = """[segmentation]
region_of_interest = [240, 160, 160, 160]
[camera.controls]
brightness = 200
contrast = 9999
sharpness = 1
[recognition]
ranking = "classes"
top = %%d
[output.tcp]
port = %d
[process]
cpus = [0]
lock_memory = true
realtime_priority = %d
""" % (PORT, PRIORITY)

# Linux, include/uapi/asm-generic/unistd.h: waiting, V4L2, and waking the thread that writes.
LOOP_CALLS = {73: "ppoll", 29: "ioctl", 64: "write"}

# Small buffers of sockets: a reader that stands still is too slow within seconds.
FEED = """loop %d %d %s
play /test/%s 1
run ifconfig lo up
run echo 4096 8192 8192 >/proc/sys/net/ipv4/tcp_rmem
run echo 4096 8192 8192 >/proc/sys/net/ipv4/tcp_wmem
run cp /test/first /test/aspectd.toml
run aspectd --config /test/aspectd.toml --check >check.txt 2>warnings.txt
run . /test/steps; start_aspectd
wait 1500
run cat /proc/$(cat /run/pid)/status >process.txt
run cut -d' ' -f40,41 /proc/$(cat /run/pid)/stat >scheduling.txt
locked brightness 150
mark begin trace
run . /test/steps; trace_calls begin
wait 1000
run . /test/steps; trace_calls end
mark end trace
mark begin good
run cp /test/second /test/aspectd.toml; kill -HUP $(cat /run/pid)
wait 1000
mark begin bad
run cp /test/broken /test/aspectd.toml; kill -HUP $(cat /run/pid)
wait 1000
mark begin slow
run nc 127.0.0.1 %d </dev/null >read.ndjson &
run nc 127.0.0.1 %d </dev/null | sleep 1000 &
run nc 127.0.0.1 %d </dev/null >/dev/null & usleep 50000; kill -STOP $!
wait 200
run . /test/steps; sample all
wait 8000
run . /test/steps; sample one
mark end slow
run . /test/steps; stop_aspectd
""" % (WIDTH, HEIGHT, FOURCC, FRAMES, PORT, PORT, PORT)


def configuration(indexes, top):
    return contract.configuration(indexes, WIDTH, HEIGHT, FOURCC, extra=EXTRA % top)


def checked_right(outcome):
    told = outcome.text("check.txt") + outcome.text("warnings.txt")
    for words in ("camera: /dev/video0: vivid", "YUYV 640 x 480 at 59.94 Hz", "brightness = 200",
                  "contrast = 255", "warning: contrast goes from 0 to 255, and 9999",
                  "warning: the camera has no control sharpness", "index: cube",
                  "output: TCP 127.0.0.1 port %d" % PORT):
        check(words in told, "--check does not say '%s':\n%s" % (words, told))


def process_right(outcome):
    status = outcome.text("process.txt")
    locked_kib, peak_kib = (int(re.search(key + r":\s*(\d+) kB", status).group(1))
                            for key in ("VmLck", "VmHWM"))
    print("locked memory: %d KiB, at its peak %d KiB" % (locked_kib, peak_kib))
    check(0 < locked_kib <= PEAK_KIB and peak_kib <= PEAK_KIB, "memory:\n" + status)
    check(re.search(r"Cpus_allowed_list:\s*0\n", status), "other processors:\n" + status)
    scheduling = outcome.text("scheduling.txt").split()
    check(scheduling == [str(PRIORITY), "1"], "priority and policy are %s" % scheduling)


def calls_right(outcome, during):
    """The loop's system calls; those of the threads that write are not among them."""
    calls = Counter(int(number) for number in re.findall(r"sys_enter: NR (\d+)",
                                                         outcome.text("calls.txt")))
    frames = len(contract.frames(during))
    check(frames > 30, "only %d frames while calls were traced" % frames)
    print("system calls a frame: " + ", ".join(
        "%s %.2f" % (LOOP_CALLS.get(number, number), count / frames)
        for number, count in sorted(calls.items())))
    check(set(calls) == set(LOOP_CALLS), "the loop calls %s" % sorted(calls))


def hypotheses(frames):
    return max(len(seen["hypotheses"]) for frame in frames for seen in frame.value["objects"])


def states(events):
    return [event.state() for event in events if event.state() is not None]


def sequences(frames):
    return [frame.value["sequence"] for frame in frames]


def gaps(numbers):
    return [pair for pair in zip(numbers, numbers[1:]) if pair[1] != pair[0] + 1]


def reloaded_right(before, good, bad):
    check(states(good) == ["reloaded"], "after a good file: %s" % states(good))
    check(hypotheses(contract.frames(before)) == FIRST_TOP, "not the first configuration")
    told = next(event for event in good if event.state() == "reloaded")
    after = [event for event in contract.frames(good) if event.time_s > told.time_s]
    check(hypotheses(after) == SECOND_TOP, "not the second configuration")
    numbers = sequences(contract.frames(before + good))
    missing = sum(after - before - 1 for before, after in gaps(numbers))
    took_s = told.time_s - good[0].time_s
    print("reload with %d indexes: %.1f ms, %d frames not shown" % (2, 1000 * took_s, missing))
    check(missing <= took_s / FRAME_S + 1, "%d frames are missing after a reload" % missing)

    check(states(bad) == ["reload_failed"], "after a bad file: %s" % states(bad))
    failure = next(event for event in bad if event.state() == "reload_failed")
    check("none.aspect: cannot be read" in failure.value["reason"], failure.text)
    check(hypotheses(contract.frames(bad)) == SECOND_TOP, "a bad file changed something")


def slow_readers_right(outcome, found, during):
    numbers = sequences(contract.frames(during))
    check(not gaps(numbers), "readers that stand still cost frames: %s" % gaps(numbers))
    descriptors = {event.sample()["name"]: event.sample()["descriptors"]
                   for event in found if event.source == "sample"}
    check(descriptors["one"] == descriptors["all"] - 2, "not let go: %s" % descriptors)
    check(any("a reader was too slow" in event.text for event in found if event.source == "log"),
          "the log says nothing of the slow reader")
    read = [json.loads(line)["sequence"] for line in outcome.text("read.ndjson").splitlines()
            if "objects" in line]
    check(not gaps(read), "the other reader misses lines: %s" % gaps(read))
    check(read[-1] >= numbers[-1], "the other reader did not get everything")
    print("slow and dead reader let go; %d frames without a gap meanwhile" % len(numbers))


def operation_test(context):
    files = {"test/feed": FEED.encode(),
             "test/first": configuration(["cube.aspect"], FIRST_TOP),
             "test/second": configuration(["cube.aspect", "l_shape.aspect"], SECOND_TOP),
             "test/broken": configuration(["none.aspect"], SECOND_TOP)}
    outcome = context.boot("operation", "feeder </test/feed >feeder.log\n", files, [FRAMES])
    found = contract.events(outcome.text("aspectd.log"), outcome.text("feeder.log"))
    marks = ("begin trace", "end trace", "begin good", "begin bad", "begin slow", "end slow")
    parts = contract.parts(found, marks)
    checked_right(outcome)
    process_right(outcome)
    calls_right(outcome, parts["begin trace"])
    reloaded_right(parts["begin trace"] + parts["end trace"], parts["begin good"],
                   parts["begin bad"])
    slow_readers_right(outcome, found, parts["begin slow"])
    check(outcome.text("aspectd.status").strip() == "0", "aspectd did not exit with 0")


if __name__ == "__main__":
    run(operation_test)
