#!/usr/bin/env python3
"""Writes a mesh of 100,000 triangles in 20 colours: a bumpy ball, parted into 20 fields.
usage: tools/bench/large_mesh.py OUT.ply"""
import math
import struct
import sys

COLUMNS, RINGS, FIELDS = 250, 200, 20  # 2 * COLUMNS * RINGS triangles


def ball_point(latitude, longitude):
    radius = 1 + 0.06 * math.sin(5 * longitude) * math.sin(3 * latitude) ** 2
    ring = radius * math.sin(latitude)
    return ring * math.cos(longitude), ring * math.sin(longitude), radius * math.cos(latitude)


def vertices():
    yield ball_point(0, 0)
    for ring in range(1, RINGS + 1):
        for column in range(COLUMNS):
            yield ball_point(math.pi * ring / (RINGS + 1), 2 * math.pi * column / COLUMNS)
    yield ball_point(math.pi, 0)


def triangles():
    def vertex(ring, column):
        return 1 + ring * COLUMNS + column % COLUMNS
    for column in range(COLUMNS):
        yield 0, vertex(0, column), vertex(0, column + 1)
    for ring in range(RINGS - 1):
        for column in range(COLUMNS):
            a, b = vertex(ring, column), vertex(ring, column + 1)
            c, d = vertex(ring + 1, column), vertex(ring + 1, column + 1)
            yield a, c, d
            yield a, d, b
    for column in range(COLUMNS):
        yield vertex(RINGS - 1, column), 1 + RINGS * COLUMNS, vertex(RINGS - 1, column + 1)


def field_centres():
    """Evenly spread over the sphere by the golden angle."""
    for k in range(FIELDS):
        z, angle = (2 * k + 1) / FIELDS - 1, 2.399963229728653 * k
        radius = math.sqrt(1 - z * z)
        yield radius * math.cos(angle), radius * math.sin(angle), z


def colours():
    """Colour shares in steps of an eighth: far enough apart for the segmentation."""
    shares = [(r, g, 8 - r - g) for r in range(1, 7) for g in range(1, 8 - r)][:FIELDS]
    return [tuple(round(240 * part / max(share)) for part in share) for share in shares]


def main(path):
    points, centres, palette = list(vertices()), list(field_centres()), colours()
    faces = bytearray()
    count = 0
    for corners in triangles():
        middle = [sum(points[k][axis] for k in corners) for axis in range(3)]
        field = max(range(FIELDS), key=lambda k: sum(a * b for a, b in zip(middle, centres[k])))
        # Neighbouring fields get colours that are not neighbours of the palette.
        faces += struct.pack("<B3i3B", 3, *corners, *palette[7 * field % FIELDS])
        count += 1
    header = ("ply\nformat binary_little_endian 1.0\n"
              f"element vertex {len(points)}\n"
              "property float x\nproperty float y\nproperty float z\n"
              f"element face {count}\nproperty list uchar int vertex_indices\n"
              "property uchar red\nproperty uchar green\nproperty uchar blue\nend_header\n")
    with open(path, "wb") as file:
        file.write(header.encode())
        for point in points:
            file.write(struct.pack("<3f", *point))
        file.write(faces)


main(sys.argv[1])
