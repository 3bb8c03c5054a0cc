#!/usr/bin/env python3
"""Twenty thousand frames: not one is missing in the log, and memory and descriptors at the end are
those of the beginning, to the page. The frames are small, so that a minute is enough."""

import json

import daemon_contract as contract
from context import check, run

FRAMES = 20000
FRAME_FILE = "small.64x48.RGB3"
WIDTH, HEIGHT, FOURCC = 64, 48, "RGB3"
PICTURES = 10
EXTRA = '[recognition]\nranking = "classes"\ntop = 1\n'
SAMPLES = 20
SETTLED_S = 5  # the first sample
LINES = "/run/results/seen.ndjson"


def feeder_script():
    period_ms = 1000 / 59.94
    between_ms = int(FRAMES * period_ms / (SAMPLES + 1))
    sampled = "".join("sleep %.3f; sample s%02d; " % (between_ms / 1000, i) for i in range(SAMPLES))
    # One round of all pictures more than asked for, so that the last sample sees them all.
    return """loop %d %d %s
play /test/%s 1
run . /test/steps; start_aspectd
wait %d
run . /test/steps; sample first
run (. /test/steps; %s) &
play /test/%s 1 %d
run . /test/steps; sample last
run . /test/steps; stop_aspectd
""" % (WIDTH, HEIGHT, FOURCC, FRAME_FILE, 1000 * SETTLED_S, sampled, FRAME_FILE,
       FRAMES // PICTURES + 1)


def long_run_test(context):
    # The timings stay those of 640 x 480: a part of them is cut out and put in.
    script = """. /test/steps
load_vivid ccs_cap_mode=1 ccs_out_mode=2
feeder </test/feed >feeder.log
"""
    files = {"test/feed": feeder_script().encode(),
             "test/aspectd.toml": contract.configuration(
                 ["cube.aspect"], WIDTH, HEIGHT, FOURCC, extra=EXTRA, file=LINES)}
    outcome = context.boot("long_run", script, files, [FRAME_FILE], limit_s=500)

    files = contract.rotated(outcome.files, LINES.rsplit("/", 1)[1])
    text = "".join(outcome.text(name) for name in files)
    lines = [json.loads(line) for line in text.splitlines()]
    frames = [line for line in lines if "objects" in line]
    print("%d frames, %d KiB of lines in %d files, %.2f million instructions each" % (
        len(frames), len(text) // 1024, len(files),
        sum(frame["elapsed_ms"] for frame in frames) / len(frames)))
    check(len(frames) >= FRAMES, "only %d frames in the log" % len(frames))
    numbers = [frame["sequence"] for frame in frames]
    gaps = [pair for pair in zip(numbers[1:], numbers[2:]) if pair[1] != pair[0] + 1]
    check(not gaps, "frames are missing in the log after: %s" % gaps[:10])
    check(any(frame["objects"] for frame in frames), "nothing was ever seen")
    states = [line["state"] for line in lines if "state" in line]
    check(states == [contract.STREAMING], "states were told: %s" % states)

    found = contract.events(outcome.text("aspectd.log"))
    samples = [event.sample() for event in found if event.source == "sample"]
    samples = [sample for sample in samples if sample["name"] != "stop"]
    check(len(samples) >= SAMPLES, "only %d samples" % len(samples))
    for key in ("rss", "descriptors"):
        values = sorted({sample[key] for sample in samples})
        print("%s: %s in %d samples" % (key, values, len(samples)))
        check(len(values) == 1, "%s is not constant: %s" % (
            key, [(sample["name"], sample[key]) for sample in samples]))
    check(outcome.text("aspectd.status").strip() == "0", "aspectd did not exit with 0")


if __name__ == "__main__":
    run(long_run_test)
