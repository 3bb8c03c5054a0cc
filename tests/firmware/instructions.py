#!/usr/bin/env python3
"""Instructions that a frame of 640 x 480 costs on a device, by stage: aspect-replay in a guest
whose clock counts them. Called by tools/bench/arm_instructions.sh."""

import json

from context import OBJECTS, check, run

FRAME_FILE = "frames.640x480.YUYV"
# Name, GHz, and instructions a cycle, which are an assumption: what such integer code, mostly in the
# cache, does on cores that issue two in order, and on one that issues three out of order. No board
# was measured.
CORES = {"arm64": (("Cortex-A53, 1 GHz", 1.0, 1.0), ("Cortex-A72, 1.5 GHz", 1.5, 1.5)),
         "armhf": (("Cortex-A8, 1 GHz", 1.0, 1.0),)}


def mean(values):
    return sum(values) / len(values)


def print_table(frames, cores):
    rows = [(stage, mean([frame["stages_ms"][stage] for frame in frames]))
            for stage in frames[0]["stages_ms"]]
    rows.append(("all", mean([frame["elapsed_ms"] for frame in frames])))
    heads = ["%s, %g instructions a cycle: ms" % (core, rate) for core, _, rate in cores]
    print("| stage | million instructions | %s |\n| --- | ---: |%s" % (
        " | ".join(heads), " ---: |" * len(cores)))
    for stage, millions in rows:
        times = ["%.2f" % (millions / ghz / rate) for _, ghz, rate in cores]
        print("| %s | %.3f | %s |" % (stage, millions, " | ".join(times)))
    print("slowest frame: %.2f million" % max(frame["elapsed_ms"] for frame in frames))


def instructions(context):
    command = ["aspect-replay", "/test/" + FRAME_FILE]
    for name in OBJECTS:
        command += ["--index", "/test/%s.aspect" % name]
    # The file twice: what is touched for the first time costs the kernel's page faults.
    script = "%s /test/%s >all.ndjson\n" % (" ".join(command), FRAME_FILE)
    files = {"bin/aspect-replay": context.device_programs + "/aspect-replay"}
    outcome = context.boot("instructions", script, files, [FRAME_FILE])
    frames = [json.loads(line) for line in outcome.text("all.ndjson").splitlines()]
    check(len(frames) >= 2 and len(frames) % 2 == 0, "%d frames" % len(frames))
    frames = frames[len(frames) // 2:]
    print("%s, %d frames of %s, indexes: %s" % (
        context.processor, len(frames), FRAME_FILE, ", ".join(OBJECTS)))
    print_table(frames, CORES[context.processor])


if __name__ == "__main__":
    run(instructions)
