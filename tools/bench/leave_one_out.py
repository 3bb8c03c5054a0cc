#!/usr/bin/env python3
"""How far verdicts can be trusted: each index is left out in turn, and frames of its object must be
unknown, those of the others matches.

usage: leave_one_out.py --replay PROGRAM --index NAME.aspect [--index ...] SET_FOLDER...
A set folder holds camera.toml, truth.csv (columns file and object, one object a frame) and the frames.
An index is named as its object. Prints verdicts of known and unknown objects, the share of matches that
are right, and the expected calibration error over ten bins (right: the first hypothesis names the
object)."""
import argparse
import collections
import csv
import json
import pathlib
import subprocess


def answers(program, indexes, folder, frames):
    command = [program, "--config", str(folder / "camera.toml")]
    for index in indexes:
        command += ["--index", str(index)]
    lines = subprocess.run(command + [str(folder / f) for f in frames], check=True,
                           capture_output=True, text=True).stdout.splitlines()
    for frame, line in zip(frames, lines):
        objects = json.loads(line)["objects"]
        yield frame, objects[0] if objects else {}


def calibration_error(samples):
    bins = collections.defaultdict(list)
    for probability, right in samples:
        bins[min(9, int(10 * probability))].append((probability, right))
    error = 0
    for members in bins.values():
        mean = sum(p for p, _ in members) / len(members)
        share = sum(right for _, right in members) / len(members)
        error += len(members) / len(samples) * abs(mean - share)
    return error


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--replay", required=True)
    parser.add_argument("--index", action="append", required=True, type=pathlib.Path)
    parser.add_argument("folders", nargs="+", type=pathlib.Path)
    arguments = parser.parse_args()
    verdicts = {"known": collections.Counter(), "unknown": collections.Counter()}
    samples, matches, right_matches = [], 0, 0
    for folder in arguments.folders:
        with open(folder / "truth.csv", encoding="utf-8") as table:
            truth = {row["file"]: row["object"] for row in csv.DictReader(table)}
        for left_out in arguments.index:
            others = [index for index in arguments.index if index != left_out]
            for frame, seen in answers(arguments.replay, others, folder, list(truth)):
                known = "unknown" if truth[frame] == left_out.stem else "known"
                verdict = seen.get("verdict", "none")
                verdicts[known][verdict] += 1
                hypotheses = seen.get("hypotheses") or [{}]
                right = hypotheses[0].get("object") == truth[frame]
                samples.append((seen.get("probability", 0), right))
                matches += verdict == "match"
                right_matches += verdict == "match" and right
    for known, counts in verdicts.items():
        total = sum(counts.values())
        words = ", ".join(f"{name} {count} ({100 * count / total:.1f} %)"
                          for name, count in sorted(counts.items()))
        print(f"{known} objects, {total} frames: {words}")
    print(f"matches that are right: {100 * right_matches / max(1, matches):.1f} % of {matches}")
    print(f"expected calibration error: {calibration_error(samples):.3f}")


main()
