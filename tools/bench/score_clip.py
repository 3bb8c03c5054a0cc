#!/usr/bin/python3
"""How well aspect-replay --track follows a clip of make_clip.py.

usage: tools/bench/score_clip.py TRUTH.csv RESULTS.ndjson
pose     error of the turn in degrees: median, 90th percentile; of frames that were only followed, of
         those searched, and by object
jitter   change of that error from a frame to the next, degrees
lag      how far poses are behind the turning, frames
ms       elapsed_ms: median, 99th percentile
numbers  those that each object had, in their order
unseen   frames in which an object at least 0.65 visible is not seen where it is, and for how many
         in a row before it is found again
false    matches where no such object is
Needs python3-numpy."""
import csv
import json
import os
import sys

import numpy as np

LEAST_VISIBLE, MOST_SHIFT = 0.65, 0.15


def read_truth(path):
    frames = {}
    with open(path, encoding="utf-8") as file:
        for row in csv.DictReader(file):
            frames.setdefault(os.path.basename(row["file"]), {})[row["object"]] = row
    return frames


def rotation_of_row(row):
    return np.array([float(row["r%d%d" % (i, k)]) for i in range(3) for k in range(3)]).reshape(3, 3)


def rotation_of_quaternion(quaternion):
    w, x, y, z = np.asarray(quaternion) / np.linalg.norm(quaternion)
    return np.array([[1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)],
                     [2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)],
                     [2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)]])


def turn_vector(rotation):
    """Axis times angle, in degrees."""
    axis = np.array([rotation[2, 1] - rotation[1, 2], rotation[0, 2] - rotation[2, 0],
                     rotation[1, 0] - rotation[0, 1]])
    angle = np.degrees(np.arccos(np.clip((np.trace(rotation) - 1) / 2, -1, 1)))
    length = np.linalg.norm(axis)
    return axis / length * angle if length > 0 else np.array([angle, 0, 0])


def is_there(hypothesis, row):
    place = np.array([float(row["t" + axis]) for axis in "xyz"])
    return (np.linalg.norm(np.asarray(hypothesis["pose"]["translation"]) - place) <
            MOST_SHIFT * np.linalg.norm(place))


class Score:
    def __init__(self):
        self.errors, self.by_object, self.milliseconds = {}, {}, {}
        self.jitter, self.lag, self.false = [], [], 0
        self.numbers, self.unseen, self.gaps, self.waiting = {}, {}, {}, {}
        self.last = {}

    def add_pose(self, frame, kind, name, hypothesis, row):
        truth = rotation_of_row(row)
        error = turn_vector(rotation_of_quaternion(hypothesis["pose"]["quaternion"]) @ truth.T)
        size = float(np.linalg.norm(error))
        self.errors.setdefault(kind, []).append(size)
        self.by_object.setdefault(name, []).append(size)
        last_frame, last_error, last_truth = self.last.get(name, (None, None, None))
        if last_frame == frame - 1 and max(size, np.linalg.norm(last_error)) < 20:
            turned = turn_vector(truth @ last_truth.T)
            self.jitter.append(float(np.linalg.norm(error - last_error)))
            self.lag.append(-float(error @ turned) / float(turned @ turned))
        self.last[name] = (frame, error, truth)

    def add_frame(self, frame, line, rows):
        kind = "searched" if line["stages_ms"]["segment"] > 0 else "followed"
        self.milliseconds.setdefault(kind, []).append(line["elapsed_ms"])
        seen = set()
        for thing in line["objects"]:
            if thing.get("verdict") != "match":
                continue
            hypothesis = thing["hypotheses"][0]
            name = hypothesis["object"]
            if name in seen or name not in rows or not is_there(hypothesis, rows[name]):
                self.false += 1
                continue
            seen.add(name)
            self.add_pose(frame, kind, name, hypothesis, rows[name])
            numbers = self.numbers.setdefault(name, [])
            if numbers[-1:] != [thing.get("track")]:
                numbers.append(thing.get("track"))
        for name, row in rows.items():
            waited = self.waiting.get(name, 0)
            if name in seen:
                if waited:
                    self.gaps.setdefault(name, []).append(waited)
                self.waiting[name] = 0
            elif float(row["visible"]) >= LEAST_VISIBLE:
                self.waiting[name] = waited + 1
                self.unseen[name] = self.unseen.get(name, 0) + 1


def percentiles(values, *shares):
    return " ".join("%.2f" % np.percentile(values, share) for share in shares)


def main():
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    truth, score = read_truth(sys.argv[1]), Score()
    with open(sys.argv[2], encoding="utf-8") as file:
        for frame, text in enumerate(file):
            line = json.loads(text)
            score.add_frame(frame, line, truth.get(os.path.basename(line["frame"]), {}))
    for kind, errors in score.errors.items():
        print("%s frames %d, pose %s, ms %s" % (
            kind, len(score.milliseconds[kind]), percentiles(errors, 50, 90),
            percentiles(score.milliseconds[kind], 50, 99)))
    print("pose by object: " + ", ".join("%s %s" % (name, percentiles(errors, 50, 90))
                                         for name, errors in sorted(score.by_object.items())))
    print("jitter %s, lag %.3f" % (percentiles(score.jitter, 50, 90), np.mean(score.lag)))
    print("numbers %s, unseen %s, found again after %s, false %d" % (
        score.numbers, score.unseen, score.gaps, score.false))


main()
