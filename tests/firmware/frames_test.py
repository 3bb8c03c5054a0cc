#!/usr/bin/env python3
"""Recorded frames through a kernel's V4L2 node: every byte arrives, and aspectd says of each what
aspect-replay says of it on this machine; in three formats, on single- and multi-planar devices."""

import statistics
import zlib

import daemon_contract as contract
from context import OBJECTS, check, run

FORMATS = ("YUYV", "NV12", "RGB3")
BYTES_PER_PIXEL = {"YUYV": 2, "NV12": 1.5, "RGB3": 3}
WIDTH, HEIGHT = 640, 480
PLANES = {"single": 1, "multi": 2}  # as vivid's parameter multiplanar counts
# Periods of a 60th of a second that each picture stands: longer than the slowest build takes for a
# frame, so that aspectd, which takes the newest one, sees them all.
HOLD = 8
READY_MS = 100
PEAK_KIB = 8 * 1024


def frames_name(fourcc):
    return "frames.%dx%d.%s" % (WIDTH, HEIGHT, fourcc)


def feeder_script(name, fourcc):
    """The file is played once before, so that its last frame stands when a reader starts."""
    file = "/test/" + frames_name(fourcc)
    return ("""loop %d %d %s
play %s 1
run grab /dev/video0 %d %d %s 60 >%s.grabbed &
wait 100
play %s 2
wait 800
run name=%s; . /test/steps; start_aspectd
wait 250
play %s %d
run name=%s; . /test/steps; stop_aspectd
""" % (WIDTH, HEIGHT, fourcc, file, WIDTH, HEIGHT, fourcc, name, file, name, file, HOLD,
               name)).encode()


def grabbed_right(outcome, name, frames):
    """Bytes and order of what the loop gives, seen by a program that is not aspectd."""
    rows = [line.split() for line in outcome.text(name + ".grabbed").splitlines()]
    numbers = [int(row[0]) for row in rows]
    # While the stream starts, vivid may leave one out.
    check(numbers[1:] == list(range(numbers[1], numbers[1] + len(rows) - 1)),
          "%s: frames are lost: %s" % (name, numbers))
    known = ["%08x" % zlib.crc32(frame) for frame in frames]
    seen = contract.collapsed([row[2] for row in rows])
    check(seen == [known[-1]] + known,
          "%s: other frames arrived than were sent:\n%s\n%s" % (name, seen, known))


def recognised_right(outcome, name, expected):
    found = contract.events(outcome.text(name + ".log"))
    results = contract.collapsed([contract.result_of(event.text)
                                  for event in contract.frames(found)])
    wanted = contract.collapsed([expected[-1]] + expected)
    for number, (result, want) in enumerate(zip(results, wanted)):
        check(result == want, "%s: result %d is not aspect-replay's:\n%s\n%s" % (
            name, number, result, want))
    check(len(results) == len(wanted), "%s: %d different results, not %d" % (
        name, len(results), len(wanted)))
    check(outcome.text(name + ".status").strip() == "0", name + ": aspectd did not exit with 0")
    return found


def figures(name, found):
    """Printed; what breaks a promise is returned, since the rest is worth seeing then, too."""
    ready_ms = contract.ready(found) * 1000
    peak_kib = next(event.sample()["peak"] for event in found if event.source == "sample")
    lines = [event.value for event in contract.frames(found)]
    costs_ms = [line["elapsed_ms"] for line in lines]
    latencies_ms = [line["capture"]["latency_ms"] for line in lines]
    print("%s: ready after %.1f ms, peak memory %d KiB; million instructions: %.2f a frame, %.2f from "
          "capture to result" % (name, ready_ms, peak_kib, statistics.mean(costs_ms),
                                 statistics.median(latencies_ms)))
    if ready_ms > READY_MS:
        return ["%s: ready after %.1f ms" % (name, ready_ms)]
    # The driver's buffers count, and those of RGB3 are half as large again.
    if name == "single_YUYV" and peak_kib > PEAK_KIB:
        return ["%s: %d KiB of memory at its peak" % (name, peak_kib)]
    return []


def frames_test(context):
    files, script = {}, ""
    for planes, parameter in PLANES.items():
        if parameter > 1:
            script += ". /test/steps; load_vivid multiplanar=%d\n" % parameter
        for fourcc in FORMATS:
            name = planes + "_" + fourcc
            files["test/%s.feed" % name] = feeder_script(name, fourcc)
            files["test/%s.toml" % name] = contract.configuration(
                [index + ".aspect" for index in OBJECTS], WIDTH, HEIGHT, fourcc)
            script += "feeder </test/%s.feed >%s.fed; wait\n" % (name, name)
    broken = []
    outcome = context.boot("frames", script, files, [frames_name(f) for f in FORMATS])

    for fourcc in FORMATS:
        with open(context.frame_file(frames_name(fourcc)), "rb") as file:
            data = file.read()
        size = int(WIDTH * HEIGHT * BYTES_PER_PIXEL[fourcc])
        frames = [data[at:at + size] for at in range(0, len(data), size)]
        expected = [contract.result_of(line) for line in context.replayed(frames_name(fourcc))]
        check(len(expected) == len(frames), "aspect-replay read %d frames" % len(expected))
        for planes in PLANES:
            name = planes + "_" + fourcc
            grabbed_right(outcome, name, frames)
            broken += figures(name, recognised_right(outcome, name, expected))
    check(not broken, "; ".join(broken))


if __name__ == "__main__":
    run(frames_test)
