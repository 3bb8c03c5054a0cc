#!/usr/bin/python3
"""The objects of make_clip.py as ViSP's models, OUT/NAME.cao, for visp_clip.cpp.
usage: tools/bench/visp_models.py OBJECTS.py OUT"""
import importlib.util
import os
import sys

import numpy as np

NAMES, RADIUS = ("blockcyl2", "pegblock", "l_shape"), 0.36


def side_of(normal):
    normal = np.asarray(normal, float) / np.linalg.norm(normal)
    side = np.cross(normal, [1, 0, 0] if abs(normal[0]) < 0.7 else [0, 1, 0])
    side /= np.linalg.norm(side)
    return side, np.cross(normal, side)


def model_of(primitives, scale):
    points, faces, cylinders, circles = [], [], [], []

    def place_of(point):
        points.append("%.6f %.6f %.6f" % tuple(scale * np.asarray(point, float)))
        return len(points) - 1

    for primitive in primitives:
        if primitive[0] == "polygon":
            faces.append([place_of(corner) for corner in primitive[1]])
        elif primitive[0] == "cone":
            cylinders.append("%d %d %.6f" % (place_of(primitive[1]), place_of(primitive[3]),
                                             scale * primitive[2]))
        elif primitive[0] == "ring":
            centre = np.asarray(primitive[1], float)
            first, second = side_of(primitive[2])
            circles.append("%.6f %d %d %d" % (
                scale * primitive[4], place_of(centre), place_of(centre + primitive[4] * first),
                place_of(centre + primitive[4] * second)))
    lines = ["V1", str(len(points)), *points, "0", "0", str(len(faces))]
    lines += ["%d %s" % (len(face), " ".join(map(str, face))) for face in faces]
    return "\n".join([*lines, str(len(cylinders)), *cylinders, str(len(circles)), *circles]) + "\n"


def main():
    if len(sys.argv) != 3 or not os.path.isfile(sys.argv[1]):
        sys.exit(__doc__)
    spec = importlib.util.spec_from_file_location("objects", sys.argv[1])
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    objects = module.objects()
    for name in NAMES:
        scale = RADIUS / module.extent(objects[name])
        with open(os.path.join(sys.argv[2], name + ".cao"), "w", encoding="utf-8") as file:
            file.write(model_of(objects[name], scale))


main()
