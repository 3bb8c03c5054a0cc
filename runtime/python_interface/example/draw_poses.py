#!/usr/bin/env python3
"""Draws what Aspect recognises over a camera's frames, a video, or pictures.

    draw_poses.py part.aspect                      the first camera, in a window; q ends it
    draw_poses.py part.aspect --frames pictures/   a folder, a picture or a video
    draw_poses.py part.aspect --frames clip.mp4 --output drawn/
"""
import argparse
import pathlib

import cv2
import numpy

import aspect

GREEN, WHITE = (80, 220, 80), (255, 255, 255)
AXES = ((60, 60, 230), (60, 200, 60), (230, 120, 60))  # x, y, z; blue, green, red


def frames(source):
    """(name, picture) of a camera's number, a video, a picture or a folder."""
    path = pathlib.Path(source)
    if path.is_dir():
        for file in sorted(path.iterdir()):
            picture = cv2.imread(str(file))
            if picture is not None:
                yield file.stem, picture
        return
    picture = cv2.imread(source) if path.is_file() else None
    if picture is not None:
        yield path.stem, picture
        return
    video = cv2.VideoCapture(int(source) if source.isdigit() else source)
    number = 0
    while True:
        good, picture = video.read()
        if not good:
            return
        yield f"{number:06}", picture
        number += 1


def corners_of(known):
    """The eight corners of an object's box, and the pairs of them that are edges."""
    ends = numpy.array([known.least, known.most])
    corners = numpy.array([[ends[i][0], ends[j][1], ends[k][2]]
                           for i in (0, 1) for j in (0, 1) for k in (0, 1)])
    edges = [(a, b) for a in range(8) for b in range(a) if bin(a ^ b).count("1") == 1]
    return corners, edges


def draw(picture, seen, recognition, known):
    pose = seen.pose
    to_pixels = (cv2.Rodrigues(pose[:3, :3])[0], pose[:3, 3], recognition.camera_matrix(seen),
                 recognition.distortion(seen))

    def pixels(points):
        projected, _ = cv2.projectPoints(numpy.asarray(points, float), *to_pixels)
        return [tuple(int(round(x)) for x in point) for point in projected.reshape(-1, 2)]

    corners, edges = corners_of(known)
    at = pixels(corners)
    for a, b in edges:
        cv2.line(picture, at[a], at[b], GREEN, 1, cv2.LINE_AA)
    centre = known.centre
    reach = known.diameter / 3
    middle, *ends = pixels([centre, *(centre + reach * axis for axis in numpy.eye(3))])
    for end, colour in zip(ends, AXES):
        cv2.line(picture, middle, end, colour, 2, cv2.LINE_AA)
    x, y, _, _ = seen.box
    label = f"{seen.object} {seen.probability:.2f}" + (f" #{seen.track}" if seen.track else "")
    cv2.putText(picture, label, (x, max(12, y - 4)), cv2.FONT_HERSHEY_SIMPLEX, 0.5, WHITE, 1,
                cv2.LINE_AA)


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("indexes", nargs="+", help="class indexes, NAME.aspect")
    parser.add_argument("--frames", default="0", help="camera number, video, picture or folder [0]")
    parser.add_argument("--configuration", help="TOML with [camera], [segmentation], [recognition]")
    parser.add_argument("--output", type=pathlib.Path, help="folder for pictures, in place of a window")
    parser.add_argument("--track", action="store_true", help="follow objects from frame to frame")
    options = parser.parse_args()

    recogniser = aspect.Recogniser(options.indexes, configuration=options.configuration,
                                   track=options.track)
    known = {one.object: one for one in recogniser.objects}
    if options.output:
        options.output.mkdir(parents=True, exist_ok=True)
    for name, picture in frames(options.frames):
        recognition = recogniser.recognise(picture)
        matches = [seen for seen in recognition if seen.verdict == "match" and seen.pose is not None]
        for seen in matches:
            draw(picture, seen, recognition, known[seen.object])
        print(name, f"{recognition.elapsed_ms:.1f} ms", *(seen.object for seen in matches))
        if options.output:
            cv2.imwrite(str(options.output / f"{name}.png"), picture)
        else:
            cv2.imshow("aspect", picture)
            if cv2.waitKey(1) == ord("q"):
                break


if __name__ == "__main__":
    main()
