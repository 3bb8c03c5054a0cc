#!/usr/bin/python3
"""How well a cube of stickers is found in photographs, from one labelled frame of each clip: the
stickers' colours and places of the first frame become a model, which is compiled and looked for in
the clip's other frames.

usage: cube_clips.py CLIPS OUT [ASPECTC_OPTIONS...]
CLIPS is a folder with gt.json and img (../shared/cases/real/rubik_corners). Prints a line a frame
and a summary; leaves models, indexes and overlays in OUT. A match within 15 degrees is found, any
other one is false. Needs Debian's python3-numpy."""
import collections, json, os, subprocess, sys
import numpy as np

HERE = os.path.dirname(os.path.abspath(__file__))
BIN = os.path.join(HERE, "..", "..", "build", "release", "bin")
# Corners of the three faces seen, the inner corner first.
FACES = {"A": (0, 1, 2, 3), "B": (0, 3, 4, 5), "C": (0, 5, 6, 1)}
EDGE, INSET, RAISED = 0.4, 0.09, 0.004
FOUND_DEG = 15


def homography(points):
    """from the unit square to four points"""
    rows, right = [], []
    for (x, y), (u, v) in zip([(0, 0), (1, 0), (1, 1), (0, 1)], points):
        rows += [[x, y, 1, 0, 0, 0, -u * x, -u * y], [0, 0, 0, x, y, 1, -v * x, -v * y]]
        right += [u, v]
    return np.append(np.linalg.solve(np.array(rows, float), right), 1).reshape(3, 3)


def stickers(frame):
    """(face, column, row) -> colour, counted from the inner corner"""
    corners = np.array(frame["corners_ordered_px"])
    found = {}
    for s in frame["stickers"]:
        place = np.linalg.inv(homography(corners[list(FACES[s["face"]])])) @ np.append(s["center_px"], 1)
        column, row = np.floor(3 * place[:2] / place[2]).astype(int).clip(0, 2)
        found[s["face"], column, row] = np.array(s["median_rgb"], float)
    return found


def scene(frame):
    """a black cube with the stickers of three faces, in Bob's language"""
    lines = ["/* a cube as a labelled photograph shows it */",
             "studio { at 0 0 0 up 0 1 0.05 angle 50 resolution 512 512 ambient 1 1 1 }", f"transform {{ scale {EDGE} }}"]

    def polygon(corners, colour):
        lines.append("surface { diffuse %.4f %.4f %.4f }\npolygon { points 4" % tuple(colour))
        lines.extend("  vertex %.5f %.5f %.5f" % tuple(c) for c in corners)
        lines.append("}")

    for axis in range(3):
        for side in (-.5, .5):
            u, v = [a for a in range(3) if a != axis]
            corners = np.zeros((4, 3))
            corners[:, axis], corners[:, u], corners[:, v] = side, [-.5, .5, .5, -.5], [-.5, -.5, .5, .5]
            polygon(corners, (.03, .03, .03))
    points = np.array(frame["model_points_unit_edge"])
    for (face, column, row), rgb in stickers(frame).items():
        a, b, _, d = points[list(FACES[face])]
        across, down = b - a, d - a
        normal = np.cross(across, down)
        normal *= np.sign(normal @ (a + across / 2 + down / 2)) / np.linalg.norm(normal)
        square = ((INSET, INSET), (1 - INSET, INSET), (1 - INSET, 1 - INSET), (INSET, 1 - INSET))
        polygon([a + across * (column + i) / 3 + down * (row + j) / 3 + RAISED * normal for i, j in square], rgb / 255)
    return "\n".join(lines + ["transform_pop", ""])


def rotation(quaternion):
    w, x, y, z = quaternion
    return np.array([[1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
                     [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
                     [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)]])


def angle_deg(a, b):
    return float(np.degrees(np.arccos(np.clip((np.trace(a.T @ b) - 1) / 2, -1, 1))))


def main(clips, out, options):
    truth = json.load(open(os.path.join(clips, "gt.json")))
    os.makedirs(out, exist_ok=True)
    errors, frames, false = [], 0, 0
    names = collections.defaultdict(list)
    for name in sorted((n for n in truth if truth[n]["sequence"] != "still"), key=int):
        names[truth[name]["sequence"]].append(name)
    for clip, (first, *others) in sorted(names.items()):
        model, index = os.path.join(out, clip + ".b"), os.path.join(out, clip + ".aspect")
        with open(model, "w") as file:
            file.write(scene(truth[first]))
        subprocess.run([os.path.join(BIN, "aspectc"), model, "--no-store", "-o", index, *options], check=True)
        for name in others:
            frame = truth[name]
            width, height = frame["size_wh"]
            camera = os.path.join(out, "camera.toml")
            with open(camera, "w") as file:
                file.write("[camera]\nwidth = %d\nheight = %d\nfx = %f\nfy = %f\ncx = %f\ncy = %f\n" %
                           (width, height, frame["f_px_estimated"], frame["f_px_estimated"], (width - 1) / 2, (height - 1) / 2))
            line = subprocess.run([os.path.join(BIN, "aspect-replay"), "--index", index, "--config", camera, "--overlay",
                                   os.path.join(out, clip), os.path.join(clips, frame["file"])],
                                  check=True, capture_output=True, text=True).stdout
            seen = json.loads(line)
            matches = [o["hypotheses"][0] for o in seen["objects"] if o["verdict"] == "match"]
            right = np.array(frame["R_m2c"]).reshape(3, 3)
            turns = sorted(angle_deg(rotation(m["pose"]["quaternion"]), right) for m in matches)
            frames += 1
            if turns and turns[0] < FOUND_DEG:
                errors.append(turns.pop(0))
                print(f"{clip} {name}: {errors[-1]:.1f} degrees, {seen['elapsed_ms']:.0f} ms, {len(turns)} false")
            else:
                print(f"{clip} {name}: not found, {seen['elapsed_ms']:.0f} ms, {len(turns)} false")
            false += len(turns)
    print(f"found {len(errors)} of {frames}, median {np.median(errors) if errors else float('nan'):.1f} degrees, {false} false")


if __name__ == "__main__":
    if len(sys.argv) < 3:
        sys.exit(__doc__)
    main(sys.argv[1], sys.argv[2], sys.argv[3:])
