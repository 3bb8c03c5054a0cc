#!/usr/bin/env python3
"""What Python adds to a frame: python_overhead.py INDEX... -- PICTURE...

Median over 200 calls of each picture: the time of recognise() with each object's verdict and pose read,
less the time that the recogniser itself took. Run with PYTHONPATH=build/release/python."""
import statistics
import sys
import time

import numpy
from PIL import Image

import aspect


def main():
    split = sys.argv.index("--")
    recogniser = aspect.Recogniser(sys.argv[1:split], format="rgb")
    for picture in sys.argv[split + 1:]:
        frame = numpy.array(Image.open(picture).convert("RGB"))
        over_us, inside_ms = [], []
        for _ in range(200):
            start = time.perf_counter()
            recognition = recogniser.recognise(frame)
            read = [(seen.verdict, seen.pose) for seen in recognition]
            over_us.append(1e6 * (time.perf_counter() - start) - 1e3 * recognition.elapsed_ms)
            inside_ms.append(recognition.elapsed_ms)
        print(f"{picture}: {len(read)} objects, {statistics.median(inside_ms):.2f} ms, "
              f"Python {statistics.median(over_us):.1f} us more")


if __name__ == "__main__":
    main()
