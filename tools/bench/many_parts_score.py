#!/usr/bin/python3
"""Scores frames of many parts. An answer is right where it names the part, alike where it names
another that looks the same from there: drawn by POV-Ray at the pose that was found, in flat
colours, it differs from the true one in at most --alike of its pixels. An ambiguous answer is alike
where all its rivals are, and counts as half where one of them is, or is right.
usage: many_parts_score.py FOLDER RESULTS.ndjson [--alike 0.03] [--wrong FILE]
FOLDER holds objects.py, with the parts in it, and the frames' truth.csv and camera.toml."""
import argparse
import csv
import importlib.util
import json
import os
import statistics
import subprocess
import tempfile
import tomllib

import cv2
import numpy as np

RADIUS = 0.36  # of every object in the frames


def load_definitions(folder):
    spec = importlib.util.spec_from_file_location("objects", os.path.join(folder, "objects.py"))
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


def vector(p):
    return "<%.7f,%.7f,%.7f>" % tuple(p)


def primitive(p, colours):
    paint = "texture { pigment { color rgb %s } finish { ambient 1 diffuse 0 } }" % vector(colours[p[-1]])
    if p[0] == "polygon":
        corners = [*p[1], p[1][0]]
        return "polygon { %d, %s %s }" % (len(corners), ",".join(map(vector, corners)), paint)
    if p[0] == "ring":
        return "disc { %s, %s, %g, %g %s }" % (vector(p[1]), vector(p[2]), p[4], p[3], paint)
    return "cone { %s, %g, %s, %g open %s }" % (vector(p[1]), p[2], vector(p[3]), p[4], paint)


def drawn(definitions, part, rotation, translation, camera):
    scale = RADIUS / definitions.extent(part)
    angle = 2 * np.degrees(np.arctan(camera["width"] / 2 / camera["fx"]))
    matrix = ",".join("%.9f" % x for x in [*rotation.T.ravel(), *translation])
    text = ("#version 3.7;\nglobal_settings { assumed_gamma 1.0 ambient_light rgb 1 }\n"
            "background { color rgb 0 }\ncamera { perspective location <0,0,0> direction <0,0,1> "
            "up <0,-1,0> right <%.9f,0,0> angle %.9f }\nunion { %s scale %.7f matrix <%s> }\n" %
            (camera["width"] / camera["height"], angle,
             "\n".join(primitive(p, definitions.COLOURS) for p in part), scale, matrix))
    with tempfile.TemporaryDirectory() as folder:
        with open(folder + "/s.pov", "w") as file:
            file.write(text)
        subprocess.run(["povray", f"+I{folder}/s.pov", f"+O{folder}/s.png", f"+W{camera['width']}",
                        f"+H{camera['height']}", "-A", "-D", "-GA", "+WT1", "File_Gamma=1.0"],
                       check=True, capture_output=True)
        return cv2.imread(folder + "/s.png").astype(int)


def matrix_of(q):
    w, x, y, z = q
    return np.array([[1 - 2*(y*y + z*z), 2*(x*y - z*w), 2*(x*z + y*w)],
                     [2*(x*y + z*w), 1 - 2*(x*x + z*z), 2*(y*z - x*w)],
                     [2*(x*z - y*w), 2*(y*z + x*w), 1 - 2*(x*x + y*y)]])


def share_that_differs(definitions, parts, camera, truth, hypothesis):
    """Of the true part's pixels; blur and the pose's own error take a rim of a pixel and a half."""
    rotation = np.array([float(truth["r%d%d" % (i, j)]) for i in range(3)
                         for j in range(3)]).reshape(3, 3)
    place = np.array([float(truth[k]) for k in ("tx", "ty", "tz")])
    pose = hypothesis["pose"]
    right = drawn(definitions, parts[truth["object"]], rotation, place, camera)
    named = drawn(definitions, parts[hypothesis["object"]], matrix_of(pose["quaternion"]),
                  np.array(pose["translation"]), camera)
    differs = (np.abs(right - named).max(2) > 24).astype(np.uint8)
    return cv2.erode(differs, np.ones((3, 3), np.uint8)).sum() / max(1, (right.max(2) > 0).sum())


def main():
    options = argparse.ArgumentParser(description=__doc__,
                                      formatter_class=argparse.RawDescriptionHelpFormatter)
    options.add_argument("folder")
    options.add_argument("results")
    options.add_argument("--alike", type=float, default=0.03)
    options.add_argument("--wrong", default="/dev/null")
    options = options.parse_args()
    definitions = load_definitions(options.folder)
    parts = definitions.objects()
    with open(os.path.join(options.folder, "camera.toml"), "rb") as file:
        camera = tomllib.load(file)["camera"]
    with open(os.path.join(options.folder, "truth.csv")) as file:
        truth = list(csv.DictReader(file))
    with open(options.results) as file:
        lines = {"frames/" + os.path.basename(line["frame"]): line
                 for line in map(json.loads, file)}
    counts = dict.fromkeys(["right", "alike", "half", "wrong", "unknown"], 0)
    with open(options.wrong, "w") as wrong:
        for row in truth:
            found = [o for o in lines[row["file"]]["objects"] if o.get("hypotheses")]
            best = max(found, key=lambda o: o["box"][2] * o["box"][3], default=None)
            kind = verdict_on(definitions, parts, camera, row, best, options.alike)
            counts[kind] += 1
            if kind in ("wrong", "unknown", "half"):
                names = [h["object"] for h in best["hypotheses"]] if best else []
                place = names.index(row["object"]) if row["object"] in names else -1
                print(row["file"], row["object"], kind, best and best.get("verdict"), place,
                      names[:4], file=wrong)
    total = len(truth)
    took = sorted(line["elapsed_ms"] for line in lines.values())
    match = sorted(line["stages_ms"]["match"] for line in lines.values())
    pose = sorted(line["stages_ms"]["pose"] for line in lines.values())
    credit = (counts["right"] + counts["alike"] + counts["half"] / 2) / total
    print(json.dumps({"frames": total, **counts, "credit": round(credit, 4),
                      "median_ms": round(statistics.median(took), 3),
                      "p99_ms": round(took[int(0.99 * (total - 1))], 3),
                      "match_ms": round(statistics.median(match), 3),
                      "pose_ms": round(statistics.median(pose), 3)}))


def verdict_on(definitions, parts, camera, row, best, alike):
    if best is None or best.get("verdict") == "unknown":
        return "unknown"
    same = lambda h: h["object"] == row["object"] or (
        "pose" in h and share_that_differs(definitions, parts, camera, row, h) <= alike)
    first, *others = best["hypotheses"]
    if best["verdict"] == "match":
        return ("right" if first["object"] == row["object"] else
                "alike" if same(first) else "wrong")
    rivals = [first, *(others[k - 1] for k in best.get("rivals", []))]
    like = [same(h) for h in rivals]
    return "alike" if all(like) else "half" if any(like) else "wrong"


main()
