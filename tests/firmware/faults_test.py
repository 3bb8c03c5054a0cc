#!/usr/bin/env python3
"""What happens to cameras, done to one that aspectd streams from: each is told in the output and in
the log, and within two seconds of its cause's end frames come again. Nothing leaks."""

import daemon_contract as contract
from context import check, run

WIDTH, HEIGHT, FOURCC = 640, 480, "YUYV"
FRAMES = "frames.%dx%d.%s" % (WIDTH, HEIGHT, FOURCC)
BACK_WITHIN_S = 2.0
# The place, not the node: it comes back under another one.
DEVICE = "bus:platform:vivid-000"
# Its cost is not what is tested here: a small dark part of the picture is enough.
EXTRA = "[segmentation]\nregion_of_interest = [0, 0, 64, 64]\n"

PICTURE = """loop %d %d %s
play /test/%s 1
""" % (WIDTH, HEIGHT, FOURCC, FRAMES)

UNPLUG = """close
run echo vivid.0 >/sys/bus/platform/drivers/vivid/unbind
wait 600
"""


class Fault:
    """A name, what the feeder does while it lasts (then it is over), states of which at least one
    has to be told; none: it need not be seen from outside, but the stream has to go on."""

    def __init__(self, name, script, *states):
        self.name = name
        self.script = script
        self.states = states


# To add one, add an entry: the feeder's commands are at the head of feeder.cpp, the controls are
# vivid's (v4l2-ctl --list-ctrls, or drivers/media/test-drivers/vivid/vivid-ctrls.c).
FAULTS = [
    Fault("disconnect", "set disconnect 1\nwait 600\nclose\n" + PICTURE, "absent"),
    Fault("unbind", UNPLUG + "run . /test/steps; load_vivid\n" + PICTURE, "absent"),
    Fault("other_node", UNPLUG + "run . /test/steps; load_vivid vid_cap_nr=7 vid_out_nr=8\n"
          "nodes /dev/video7 /dev/video8\n" + PICTURE, "absent"),
    Fault("error_flag", "set 0x00f0f042 1\n", "damaged"),
    Fault("fatal_error", "set 0x00f0f046 1\n", "stalled", "failed"),
    Fault("reqbufs_error", "set 0x00f0f043 1\nset 0x00f0f046 1\n", "stalled", "failed"),
    Fault("qbuf_error", "set 0x00f0f044 1\n", "stalled", "failed"),
    Fault("streamon_error", "set 0x00f0f045 1\nset 0x00f0f046 1\n", "stalled", "failed"),
    Fault("silence", "set 0x00f0f040 100\nwait 2500\nset 0x00f0f040 0\n", "stalled"),
    Fault("some_lost", "set 0x00f0f040 30\nwait 500\nset 0x00f0f040 0\n"),
    Fault("wrapped", "set 0x00f0f026 1\nset 0x00f0f027 1\nset 0x00f0f046 1\n", "stalled", "failed"),
    Fault("not_wrapped", "set 0x00f0f026 0\nset 0x00f0f027 0\nset 0x00f0f046 1\n", "stalled",
          "failed"),
    Fault("no_signal", "set 0x00f0f03e 1\nwait 1500\nset 0x00f0f03e 0\n", "no_signal"),
    Fault("no_lock", "set 0x00f0f03e 2\nwait 1500\nset 0x00f0f03e 0\n", "no_signal"),
    Fault("taken", "set disconnect 1\nwait 300\nclose\nhold %d %d %s\nwait 800\nrelease\n" % (
        WIDTH, HEIGHT, FOURCC) + PICTURE, "busy"),
]


def script():
    text = PICTURE + "run . /test/steps; start_aspectd\nwait 1000\n"
    text += "run . /test/steps; sample before\n"
    for fault in FAULTS:
        # A frame of before may still be on its way: the first 150 ms are no proof.
        text += "mark begin %s\n%smark end %s\nwait 150\nawait aspectd.log %s %d\n" % (
            fault.name, fault.script, fault.name, contract.FRAME_TEXT, 1000 * BACK_WITHIN_S)
    return text + "run . /test/steps; sample after\nrun . /test/steps; stop_aspectd\n"


def verdict(fault, found):
    """What is wrong, or nothing; prints how long it took."""
    begin, end = contract.mark(found, "begin " + fault.name), contract.mark(found, "end " + fault.name)
    order = [known.name for known in FAULTS]
    place = order.index(fault.name) + 1
    until = contract.mark(found, "begin " + order[place]) if place < len(order) else end + BACK_WITHIN_S
    during = [event for event in found if begin <= event.time_s <= min(until, end + BACK_WITHIN_S)]
    told = [event for event in during if event.state() not in (None, contract.STREAMING)]
    states = sorted({event.state() for event in told})
    last_trouble_s = max([end] + [event.time_s for event in told])
    back = [event.time_s for event in contract.frames(during) if event.time_s > last_trouble_s]
    back_s = "%.3f s" % (back[0] - end) if back else "never"
    print("%s: told %s, back after %s" % (fault.name, ", ".join(states) or "nothing", back_s))
    wrong = []
    if not back:
        wrong.append("%s: not back at work within %g s" % (fault.name, BACK_WITHIN_S))
    if fault.states and not set(states) & set(fault.states):
        wrong.append("%s: told as %s, not as %s" % (fault.name, states, fault.states))
    for state in set(states) & set(fault.states):
        if not any(event.source == "log" and state in event.text for event in during):
            wrong.append("%s: no line of the log says %s" % (fault.name, state))
    return wrong


def faults_test(context):
    files = {"test/feed": script().encode(),
             "test/aspectd.toml": contract.configuration(
                 ["cube.aspect"], WIDTH, HEIGHT, FOURCC, device=DEVICE, extra=EXTRA)}
    outcome = context.boot("faults", "feeder </test/feed >feeder.log\n", files, [FRAMES])
    found = contract.events(outcome.text("aspectd.log"), outcome.text("feeder.log"))
    wrong = []
    for fault in FAULTS:
        wrong += verdict(fault, found)
    if not any("aspectd: /dev/video7: " in event.text for event in found):
        wrong.append("other_node: the camera was not found under its new node")
    samples = [event.sample() for event in found if event.source == "sample"]
    before, after = (next(sample for sample in samples if sample["name"] == name)
                     for name in ("before", "after"))
    print("before: %s\nafter:  %s" % (before, after))
    for key in ("descriptors", "rss"):
        if before[key] != after[key]:
            wrong.append("%s: %d before, %d after" % (key, before[key], after[key]))
    if outcome.text("aspectd.status").strip() != "0":
        wrong.append("aspectd exited with %s" % outcome.text("aspectd.status").strip())
    check(not wrong, "\n".join(wrong))


if __name__ == "__main__":
    run(faults_test)
