"""What the tests know of aspectd: its configuration's keys, its lines, its log. Nowhere else."""

import json
import re

# What differs between two runs on the same pictures.
VOLATILE_KEYS = ("frame", "sequence", "elapsed_ms", "stages_ms", "capture")
STREAMING = "streaming"
FRAME_TEXT = '"objects":'  # in a frame's line and in no other


def configuration(indexes, width, height, fourcc, device="/dev/video0", extra="", file=None):
    """The text of an aspectd.toml; paths are the guest's."""
    output = '[output]\nstdout = %s\n' % ("false" if file else "true")
    if file:
        output += '[output.file]\npath = "%s"\nmax_mib = 4\nkeep = 9\n' % file
    return ('indexes = [%s]\n[camera]\ndevice = "%s"\nwidth = %d\nheight = %d\nformat = "%s"\n%s\n%s'
            % (", ".join('"%s"' % index for index in indexes), device, width, height, fourcc, extra,
               output)).encode()


def rotated(names, file):
    """Those of a file of lines, the oldest first."""
    return sorted((name for name in names if re.fullmatch(re.escape(file) + r"(\.\d+)?", name)),
                  key=lambda name: -int(name[len(file) + 1:] or 0))


def result_of(line):
    """What a frame's line says about the picture, as text that can be compared."""
    value = json.loads(line)
    for key in VOLATILE_KEYS:
        value.pop(key, None)
    return json.dumps(value, sort_keys=True)


def collapsed(values):
    """Without those that are equal to the one before."""
    return [value for i, value in enumerate(values) if i == 0 or value != values[i - 1]]


class Event:
    """One stamped line: time in seconds, who wrote it, what."""

    def __init__(self, text):
        match = re.match(r"([0-9.]+) ([a-z]+): (.*)", text)
        if not match:
            raise ValueError("not a stamped line: " + text)
        self.time_s = float(match.group(1))
        self.source = match.group(2)
        self.text = match.group(3)

    @property
    def value(self):
        return json.loads(self.text)

    def is_frame(self):
        return self.source == "line" and "objects" in self.value

    def state(self):
        """The state that this line tells, or None."""
        return self.value.get("state") if self.source == "line" else None

    def sample(self):
        """Of the sample lines: {"name": ..., "descriptors": 7, ...}."""
        name, *pairs = self.text.split()
        return {"name": name, **{key: int(value or 0) for key, value in
                                 (pair.split("=") for pair in pairs)}}


def events(*texts):
    found = [Event(line) for text in texts for line in text.splitlines()]
    return sorted(found, key=lambda event: event.time_s)


def mark(found, text):
    """When the feeder got to it."""
    for event in found:
        if event.source == "feeder" and event.text == "mark " + text:
            return event.time_s
    raise ValueError("the feeder did not get to %s" % text)


def parts(found, marks):
    """The events from each mark, itself included, to the next."""
    times = [mark(found, text) for text in marks] + [float("inf")]
    return {text: [event for event in found if begin <= event.time_s < end]
            for text, begin, end in zip(marks, times, times[1:])}


def frames(found):
    return [event for event in found if event.is_frame()]


def ready(found):
    """Seconds from the program's start to its being ready; None where it never was."""
    start = next((event.time_s for event in found if event.source == "exec"), None)
    for event in found:
        if event.source == "log" and event.text.endswith("aspectd: ready"):
            return event.time_s - start
    return None
