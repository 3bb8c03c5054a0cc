"""Writes a PNG of 8-bit RGB as a binary PPM, which C programs read without a library.

usage: ppm_of_png.py PICTURE.png PICTURE.ppm
"""
import struct
import sys
import zlib


def chunks(data):
    place = 8
    while place < len(data):
        length, kind = struct.unpack(">I4s", data[place:place + 8])
        yield kind, data[place + 8:place + 8 + length]
        place += 12 + length


def unfiltered(filtered, width, height):
    """Undoes the five filters of the PNG specification, chapter 9."""
    row_bytes = 3 * width
    above = bytearray(row_bytes)
    rows = []
    for y in range(height):
        begin = y * (row_bytes + 1)
        kind = filtered[begin]
        row = bytearray(filtered[begin + 1:begin + 1 + row_bytes])
        for i in range(row_bytes if kind else 0):
            left = row[i - 3] if i >= 3 else 0
            up = above[i]
            corner = above[i - 3] if i >= 3 else 0
            if kind == 4:
                nearest = sorted((abs(left + up - corner - value), order, value)
                                 for order, value in enumerate((left, up, corner)))
                guess = nearest[0][2]
            else:
                guess = (0, left, up, (left + up) // 2)[kind]
            row[i] = (row[i] + guess) & 255
        rows.append(bytes(row))
        above = row
    return b"".join(rows)


def main():
    source, target = sys.argv[1:]
    with open(source, "rb") as file:
        parts = list(chunks(file.read()))
    width, height, bits, colour, _, _, interlaced = struct.unpack(">IIBBBBB", parts[0][1])
    if (bits, colour, interlaced) != (8, 2, 0):
        sys.exit(f"{source}: not 8-bit RGB in one pass")
    pixels = zlib.decompress(b"".join(data for kind, data in parts if kind == b"IDAT"))
    with open(target, "wb") as file:
        file.write(b"P6\n%d %d\n255\n" % (width, height) + unfiltered(pixels, width, height))


main()
