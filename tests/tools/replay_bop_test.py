"""aspect-replay --bop read by a reader of its own, written from the benchmark's definition of its results,
and held against POV-Ray's poses: replay_bop_test.py ASPECT-REPLAY INDEX-FOLDER DATA-FOLDER."""
import csv
import json
import math
import shutil
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

REPLAY, INDEXES, DATA = sys.argv[1], Path(sys.argv[2]), Path(sys.argv[3])
OBJECTS = {"cube": 4, "l_shape": 15}
FRAMES = DATA / "cluttered"
BASE = [REPLAY, *(word for name in OBJECTS for word in ("--index", str(INDEXES / f"{name}.aspect"))),
        "--config", str(FRAMES / "camera.toml")]


def replay(*words):
    return subprocess.run([*BASE, *map(str, words)], capture_output=True, text=True)


class Estimate:
    """A row: whole numbers, a score, nine and three numbers with white space between, seconds."""

    def __init__(self, row):
        scene, image, thing, score, rotation, translation, time = row
        self.scene, self.image, self.object = int(scene), int(image), int(thing)
        self.score, self.time = float(score), float(time)
        nine = [float(part) for part in rotation.split()]
        self.rotation = [nine[0:3], nine[3:6], nine[6:9]]
        self.translation = [float(part) for part in translation.split()]
        assert len(nine) == 9 and len(self.translation) == 3


def estimates(text):
    rows = list(csv.reader(text.splitlines()))
    assert rows[0] == ["scene_id", "im_id", "obj_id", "score", "R", "t", "time"]
    return [Estimate(row) for row in rows[1:]]


def truth():
    """(image, object): rotation and translation of the object before the camera."""
    poses = {}
    with open(FRAMES / "truth.csv", newline="") as file:
        for row in csv.DictReader(file):
            key = int(Path(row["file"]).stem), row["object"]
            poses[key] = ([[float(row[f"r{i}{j}"]) for j in range(3)] for i in range(3)],
                          [float(row[part]) for part in ("tx", "ty", "tz")])
    return poses


def angle_deg(a, b):
    trace = sum(a[i][j] * b[i][j] for i in range(3) for j in range(3))
    return math.degrees(math.acos(max(-1, min(1, (trace - 1) / 2))))


class Rows(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        ids = ",".join(map(str, OBJECTS.values()))
        cls.done = replay("--bop", 48, ids, "--bop-unit-mm", 1000, FRAMES / "frames")
        cls.rows = estimates(cls.done.stdout)
        cls.lines = [json.loads(line) for line in replay(FRAMES / "frames").stdout.splitlines()]

    def test_are_the_poses_of_all_that_was_named(self):
        self.assertEqual((self.done.returncode, self.done.stderr), (0, ""))
        named = [(int(Path(line["frame"]).stem), OBJECTS[seen["hypotheses"][0]["object"]])
                 for line in self.lines for seen in line["objects"]
                 if seen.get("verdict") in ("match", "ambiguous") and "pose" in seen["hypotheses"][0]]
        self.assertGreater(len(named), 5)
        self.assertEqual([(row.image, row.object) for row in self.rows], named)
        self.assertEqual({row.scene for row in self.rows}, {48})

    def test_are_where_the_objects_are_in_millimetres(self):
        poses, names = truth(), {number: name for name, number in OBJECTS.items()}
        for row in self.rows:
            rotation, translation = poses[row.image, names[row.object]]
            self.assertLess(angle_deg(row.rotation, rotation), 3)
            self.assertLess(math.dist(row.translation, [1000 * part for part in translation]),
                            0.03 * 1000 * math.hypot(*translation))
            determinant = sum(row.rotation[0][i] * (
                row.rotation[1][(i + 1) % 3] * row.rotation[2][(i + 2) % 3] -
                row.rotation[1][(i + 2) % 3] * row.rotation[2][(i + 1) % 3]) for i in range(3))
            self.assertAlmostEqual(determinant, 1, places=9)

    def test_have_a_probability_and_the_seconds_that_their_image_took(self):
        times = {}
        for row in self.rows:
            self.assertTrue(0.5 <= row.score <= 1)
            self.assertEqual(times.setdefault(row.image, row.time), row.time)
            self.assertTrue(0 < row.time < 10)
        self.assertLess(len(times), len(self.rows))

    def test_need_a_number_in_a_name_and_each_only_once(self):
        with tempfile.TemporaryDirectory() as folder:
            for name in ("rgb_000012.jpg", "12.jpg", "first.jpg", "v2.final.jpg"):
                shutil.copy(FRAMES / "frames" / "001.jpg", Path(folder) / name)
            done = replay("--bop", 0, "1,2", folder)
        self.assertEqual(done.returncode, 1)
        self.assertEqual({row.image for row in estimates(done.stdout)}, {12})
        told = done.stderr.splitlines()
        self.assertEqual(len(told), 3)
        for line, words in zip(told, ("first.jpg: no number", "rgb_000012.jpg: im_id 12 has been written",
                                      "v2.final.jpg: no number")):
            self.assertIn(words, line)

    def test_wrong_ids_are_told_in_one_line(self):
        frame = FRAMES / "frames" / "001.jpg"
        for words, code in ((("--bop", 1, 2), 1), (("--bop", "1,2", "1,2"), 2), (("--bop", 1, "a"), 2),
                            (("--bop", -1, "1,2"), 2), (("--bop", 1, "1,"), 2), (("--bop", 1), 2),
                            (("--bop-unit-mm", 1), 2), (("--explain", "--bop", 1, "1,2"), 2),
                            (("--bop", 1, "1,2", "--bop-unit-mm", "nan"), 2)):
            done = replay(frame, *words)
            self.assertEqual((words, done.returncode, done.stdout), (words, code, ""))
            self.assertEqual(len(done.stderr.splitlines()), 1)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
