"""Aspect names the object, the aspect seen and its pose in a colour frame.

    import aspect, cv2

    recogniser = aspect.Recogniser(["part.aspect"])
    for seen in recogniser.recognise(cv2.imread("frame.png")):
        if seen.verdict == "match":
            print(seen.object, seen.probability, seen.pose)

Frames are numpy arrays, read in place. H x W x 3 is taken as blue, green, red, which is what OpenCV
gives; format="rgb" says otherwise. Class indexes are made by aspect.compile() or by aspectc.
"""
import errno
import os

from ._native import (Contour, Error, Hypothesis, KnownObject, Object, Pose, Recognition, version)
from . import _native
from .compiler import compile
from .options import configuration_text

__all__ = ["Contour", "Error", "Hypothesis", "KnownObject", "Object", "Pose", "Recogniser",
           "Recognition", "compile"]
__version__ = version()


def _existing(path):
    path = os.fspath(path)
    if not os.path.exists(path):
        raise FileNotFoundError(errno.ENOENT, "no such file", path)
    return path


def _source(index, place):
    if isinstance(index, (bytes, bytearray, memoryview)):
        return f"index {place}", bytes(index)
    return _existing(index), None


class Recogniser:
    """Recognises the objects of some class indexes in frames.

    indexes: a path or several, or the bytes of index files. Options are the keys of a configuration's
    tables [recognition] and [segmentation], as top=3, track=True, time_limit_ms=20,
    min_confidence=0.9, region_of_interest=(x, y, width, height); `aspectd --help` explains them.
    camera: a dict with width, height, fx, fy, cx, cy and k1 to k3, or OpenCV's camera matrix with
    distortion= and size=(width, height). configuration: a TOML file of all that; options win.
    format: what H x W x 3 arrays are, "bgr" or "rgb".

    May be used by several threads: one frame is recognised at a time, and Python goes on meanwhile.
    """

    def __init__(self, indexes=(), *, camera=None, distortion=None, size=None, configuration=None,
                 format="bgr", **options):
        if isinstance(indexes, (str, os.PathLike, bytes, bytearray, memoryview)):
            indexes = [indexes]
        if format not in ("bgr", "rgb"):
            raise ValueError(f"format {format} is none of H x W x 3 arrays; it is bgr or rgb")
        sources = [_source(index, place) for place, index in enumerate(indexes)]
        text = configuration_text(options, camera, distortion, size)
        file = None if configuration is None else _existing(configuration)
        self._native = _native.Recogniser(sources, file, text, format)

    def recognise(self, frame, format=None, missed=0):
        """What is seen in a frame: a Recognition, which is a list of Objects.

        frame: H x W x 3 or H x W x 4 of uint8, H x W of uint8 (grey) or uint16 (depths, surface
        numbers), of the indexes' sensor; other formats by name: yuyv, uyvy (H x W x 2), nv12, nv21
        (3 H / 2 x W), bayer_rggb and so on. Rows may be any distance apart, also upside down;
        pixels of a row must lie one behind the other.
        missed: frames of the camera since the last one given, for tracking.
        """
        return self._native.recognise(frame, format or "", missed)

    @property
    def objects(self):
        """What is known: a KnownObject for each index."""
        return self._native.objects

    @property
    def warnings(self):
        """Lines about what was opened and may not be meant so."""
        return self._native.warnings

    def __repr__(self):
        return f"<aspect.Recogniser of {', '.join(known.object for known in self.objects)}>"


def _object_text(seen):
    name = seen.object or "something"
    return f"<aspect.Object {name}, {seen.verdict or 'not judged'} {seen.probability:.3f} in {seen.box}>"


Object.__repr__ = _object_text
Recognition.__repr__ = lambda seen: f"<aspect.Recognition {list(seen)}, {seen.elapsed_ms:.2f} ms>"
Hypothesis.__repr__ = lambda one: f"<aspect.Hypothesis {one.object} class {one.class_id}, {one.score:.4f}>"
Pose.__repr__ = lambda pose: f"<aspect.Pose at {pose.translation}, {pose.reprojection_px:.2f} px>"
Contour.__repr__ = lambda one: f"<aspect.Contour of {one.area_px:.0f} px in {one.box}>"
KnownObject.__repr__ = lambda known: f"<aspect.KnownObject {known.object}, {known.diameter:.4g} across>"
