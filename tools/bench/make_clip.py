#!/usr/bin/python3
"""Renders a clip of moving objects with POV-Ray, with the exact pose of each in every frame: what
tracking is measured on.

usage: tools/bench/make_clip.py OBJECTS.py OUT [--frames 300] [--seed 1]
OBJECTS.py describes coloured objects: objects() gives lists of primitives by name, COLOURS their
colours, extent() an object's radius (see make_frames.py beside it for the conventions).
Three of them turn by one to three degrees a frame and move over coloured clutter: the first one
before the second one, which passes behind it; the third one leaves the picture twice and comes back
each time. Camera-like: blur, noise, JPEG. 640 x 480 pixels, 30 frames a second as it were.
Writes OUT/frames/NNN.jpg, OUT/camera.toml and OUT/truth.csv:
  file,object,r00..r22,tx,ty,tz,vx,vy,vz,x,y,w,h,visible
x_camera = R x_object + t; v: unit vector from the object to the camera, in its coordinates; x,y,w,h:
box of what is visible; visible: its share. Needs povray, python3-numpy and python3-opencv."""
import argparse
import csv
import importlib.util
import math
import os
import subprocess
import sys
import tempfile

import cv2
import numpy as np

WIDTH, HEIGHT = 640, 480
FIELD_OF_VIEW_DEG = 50.0
RADIUS = 0.36  # of each object in its scene
NAMES = ("blockcyl2", "pegblock", "l_shape")
FOCAL_PX = WIDTH / 2 / math.tan(math.radians(FIELD_OF_VIEW_DEG / 2))


def read_objects(path):
    if not os.path.isfile(path):
        sys.exit("make_clip.py: %s: not there; give the file that describes the objects" % path)
    spec = importlib.util.spec_from_file_location("objects", path)
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


def vector(values):
    return "<" + ",".join("%.7f" % value for value in values) + ">"


# Where each object's centre is at a frame: pixels, and the distance.
def places(time):
    wave = lambda period, phase=0.0: math.sin(2 * math.pi * (time / period + phase))
    # Out of the picture twice: from the right border on, and back.
    out = max(0.0, wave(150, -0.25)) ** 2
    return [(330 + 100 * wave(300), 260 + 50 * wave(130), 2.2 + 0.15 * wave(170)),
            (320 - 220 * wave(200, 0.25), 270 + 60 * wave(130), 3.8 + 0.15 * wave(110)),
            (500 + 260 * out, 370 + 30 * wave(100), 3.0 + 0.1 * wave(120))]


def turn(axis, angle_rad):
    x, y, z = np.asarray(axis) / np.linalg.norm(axis)
    cross = np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
    return np.eye(3) + math.sin(angle_rad) * cross + (1 - math.cos(angle_rad)) * cross @ cross


def rotations(rng, frames):
    """Tumbles smoothly: the axis drifts, the speed swells between one and three degrees a frame."""
    rotation = np.linalg.qr(rng.normal(size=(3, 3)))[0]
    rotation *= np.sign(np.linalg.det(rotation))
    phase = rng.uniform(0, 1, 4)
    for time in range(frames):
        yield rotation
        axis = [math.sin(2 * math.pi * (time / (210 + 40 * k) + phase[k])) for k in range(3)]
        degrees = 2 + math.sin(2 * math.pi * (time / 140 + phase[3]))
        rotation = turn(axis, math.radians(degrees)) @ rotation


def pov_shape(primitives, scale, colours):
    parts = []
    for primitive in primitives:
        paint = ("texture { pigment { color rgb %s } finish { ambient rgb .35 diffuse 0.7 } }" %
                 vector(colours[primitive[-1]]))
        if primitive[0] == "polygon":
            corners = list(primitive[1]) + [primitive[1][0]]
            parts.append("polygon { %d, %s %s }" %
                         (len(corners), ",".join(map(vector, corners)), paint))
        elif primitive[0] == "ring":
            parts.append("disc { %s, %s, %g, %g %s }" % (
                vector(primitive[1]), vector(primitive[2]), primitive[4], primitive[3], paint))
        elif primitive[0] == "cone":
            parts.append("cone { %s, %g, %s, %g open %s }" % (
                vector(primitive[1]), primitive[2], vector(primitive[3]), primitive[4], paint))
    return "union { %s scale %.7f" % ("\n".join(parts), scale)


def pov_clutter(rng):
    parts = []
    for _ in range(26):
        z = rng.uniform(5.5, 7)
        place = (rng.uniform(-0.5, 0.5) * z, rng.uniform(-0.4, 0.4) * z, z)
        size = rng.uniform(0.2, 0.7)
        paint = "color rgb " + vector(rng.uniform(0.05, 0.95, 3))
        if rng.random() < 0.4:
            paint = "checker %s color rgb %s scale %.3f" % (
                paint, vector(rng.uniform(0, 1, 3)), size / 3)
        shape = rng.choice(["sphere { 0, 1", "box { -1, 1", "cylinder { -y, y, .5",
                            "cone { -y, .8, y, .1"])
        parts.append("%s scale %s rotate %s translate %s texture { pigment { %s } "
                     "finish { ambient .35 diffuse .6 } } }" % (
                         shape, vector(rng.uniform(0.4, 1, 3) * size),
                         vector(rng.uniform(0, 360, 3)), vector(place), paint))
    wall = "gradient <1,.6,0> color_map { [0 color rgb %s] [.5 color rgb %s] [1 color rgb %s] }" % (
        *(vector(rng.uniform(0.2, 0.8, 3)) for _ in range(2)), vector(rng.uniform(0.2, 0.8, 3)))
    parts.append("plane { z, 8 pigment { %s scale 9 } finish { ambient .5 diffuse .4 } }" % wall)
    return "\n".join(parts) + "\n"


def pov_scene(shapes, poses, clutter):
    text = ("#version 3.7;\nglobal_settings { assumed_gamma 1.0 ambient_light rgb 1 }\n"
            "camera { location 0 direction z up -y right <%.9f,0,0> angle %g }\n"
            "light_source { <.3,-.2,0> color rgb .65 }\nlight_source { <-2,-4,-1> color rgb .25 }\n"
            % (WIDTH / HEIGHT, FIELD_OF_VIEW_DEG)) + clutter
    for shape, (rotation, place) in zip(shapes, poses):
        matrix = [*rotation[:, 0], *rotation[:, 1], *rotation[:, 2], *place]
        text += shape + " matrix <" + ",".join("%.9f" % value for value in matrix) + "> }\n"
    return text


def rendered(text, folder):
    scene, picture = os.path.join(folder, "s.pov"), os.path.join(folder, "s.png")
    with open(scene, "w", encoding="utf-8") as file:
        file.write(text)
    run = subprocess.run(["povray", "+I" + scene, "+O" + picture, "+W%d" % WIDTH, "+H%d" % HEIGHT,
                          "+A0.2", "+R2", "-D", "-GA", "+WT1", "File_Gamma=1.0"],
                         capture_output=True, text=True, check=False)
    if run.returncode:
        sys.exit("make_clip.py: povray failed:\n" + run.stderr[-2000:])
    return cv2.imread(picture)


def circle(centre, normal, radius):
    normal = np.asarray(normal, float) / np.linalg.norm(normal)
    side = np.cross(normal, [1, 0, 0] if abs(normal[0]) < 0.7 else [0, 1, 0])
    side /= np.linalg.norm(side)
    angles = np.linspace(0, 2 * math.pi, 48, endpoint=False)[:, None]
    return np.asarray(centre) + radius * (np.cos(angles) * side +
                                          np.sin(angles) * np.cross(normal, side))


def outline(primitives, scale, rotation, place):
    """All pixels of an object, whatever stands before it; a margin shows what is cut off."""
    margin = 400
    mask = np.zeros((HEIGHT + 2 * margin, WIDTH + 2 * margin), np.uint8)
    for primitive in primitives:
        if primitive[0] == "polygon":
            points, hull = np.asarray(primitive[1], float), False
        elif primitive[0] == "ring":
            points, hull = circle(primitive[1], primitive[2], primitive[4]), False
        else:
            along = np.asarray(primitive[3], float) - np.asarray(primitive[1], float)
            points, hull = np.vstack([circle(primitive[1], along, primitive[2]),
                                      circle(primitive[3], along, primitive[4])]), True
        seen = (scale * points) @ rotation.T + place
        pixels = FOCAL_PX * seen[:, :2] / seen[:, 2:] + [
            (WIDTH - 1) / 2 + margin, (HEIGHT - 1) / 2 + margin]
        corners = np.rint(16 * pixels).astype(np.int32)
        if hull:
            corners = cv2.convexHull(corners)
        cv2.fillPoly(mask, [corners], 1, shift=4)
    return mask[margin:-margin, margin:-margin] > 0, int(mask.sum())


def truth_rows(name, objects, scales, poses):
    """The nearest object hides the others: the paths keep them apart in depth."""
    hidden = np.zeros((HEIGHT, WIDTH), bool)
    rows = []
    for k in sorted(range(len(NAMES)), key=lambda k: poses[k][1][2]):
        rotation, place = poses[k]
        mask, pixels = outline(objects[NAMES[k]], scales[k], rotation, place)
        seen, hidden = mask & ~hidden, hidden | mask
        ys, xs = np.nonzero(seen)
        if len(xs) == 0:
            continue
        view = -rotation.T @ place
        view /= np.linalg.norm(view)
        box = [xs.min(), ys.min(), np.ptp(xs) + 1, np.ptp(ys) + 1]
        rows.append([name, NAMES[k], *("%.9f" % v for v in (*rotation.ravel(), *place, *view)),
                     *map(int, box), "%.4f" % (len(xs) / pixels)])
    return rows


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("objects")
    parser.add_argument("out")
    parser.add_argument("--frames", type=int, default=300)
    parser.add_argument("--seed", type=int, default=1)
    options = parser.parse_args()
    module = read_objects(options.objects)
    objects = module.objects()
    scales = [RADIUS / module.extent(objects[name]) for name in NAMES]
    rng = np.random.default_rng(options.seed)
    clutter = pov_clutter(rng)
    shapes = [pov_shape(objects[name], scale, module.COLOURS)
              for name, scale in zip(NAMES, scales)]
    paths = [list(rotations(rng, options.frames)) for _ in NAMES]
    os.makedirs(os.path.join(options.out, "frames"), exist_ok=True)
    with open(os.path.join(options.out, "camera.toml"), "w", encoding="utf-8") as file:
        file.write("[camera]\nwidth = %d\nheight = %d\nfx = %.6f\nfy = %.6f\ncx = %.1f\ncy = %.1f\n"
                   % (WIDTH, HEIGHT, FOCAL_PX, FOCAL_PX, (WIDTH - 1) / 2, (HEIGHT - 1) / 2))
    rows = []
    with tempfile.TemporaryDirectory() as folder:
        for time in range(options.frames):
            centres = [np.array([(u - WIDTH / 2) * z / FOCAL_PX, (v - HEIGHT / 2) * z / FOCAL_PX, z])
                       for u, v, z in places(time)]
            poses = [(path[time], centre) for path, centre in zip(paths, centres)]
            picture = rendered(pov_scene(shapes, poses, clutter), folder).astype(np.float32)
            picture = cv2.GaussianBlur(np.clip(picture + 4, 0, 255), (3, 3), 0.7)
            picture = np.clip(picture + rng.normal(0, 3, picture.shape), 0, 255).astype(np.uint8)
            name = "frames/%03d.jpg" % time
            cv2.imwrite(os.path.join(options.out, name), picture, [cv2.IMWRITE_JPEG_QUALITY, 92])
            rows += truth_rows(name, objects, scales, poses)
    with open(os.path.join(options.out, "truth.csv"), "w", encoding="utf-8") as file:
        out = csv.writer(file, lineterminator="\n")
        out.writerow(("file object r00 r01 r02 r10 r11 r12 r20 r21 r22 tx ty tz vx vy vz "
                      "x y w h visible").split())
        out.writerows(rows)


main()
