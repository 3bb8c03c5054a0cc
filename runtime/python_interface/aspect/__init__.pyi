import os
import pathlib
from collections.abc import Iterable, Iterator
from typing import Any, Literal

import numpy
import numpy.typing

_Numbers = numpy.typing.NDArray[numpy.float64]
_Path = str | os.PathLike[str]
_Index = _Path | bytes | bytearray | memoryview
_Box = tuple[int, int, int, int]
_Verdict = Literal["", "match", "ambiguous", "unknown"]

__version__: str

class Error(ValueError): ...

class Pose:
    """How an object stands: object to camera coordinates (x right, y down, z forward)."""
    @property
    def matrix(self) -> _Numbers: ...  # 4 x 4
    @property
    def quaternion(self) -> _Numbers: ...  # w x y z
    @property
    def translation(self) -> _Numbers: ...  # in the scene's units
    @property
    def reprojection_px(self) -> float: ...
    @property
    def covariance(self) -> _Numbers: ...  # 6 x 6, turns in radians before the place

class Hypothesis:
    @property
    def object(self) -> str: ...
    @property
    def class_id(self) -> int: ...
    @property
    def score(self) -> float: ...
    @property
    def matched(self) -> int: ...
    @property
    def unmatched(self) -> int: ...
    @property
    def view(self) -> _Numbers: ...  # unit vector from the object's centre to the camera
    @property
    def pose(self) -> Pose | None: ...
    @property
    def contours(self) -> list[tuple[int, str]]: ...  # place in Recognition.contours, name

class Object:
    """Something seen. object, pose and contours are those of the best hypothesis; None and empty
    where the verdict is unknown."""
    @property
    def object(self) -> str | None: ...
    @property
    def verdict(self) -> _Verdict: ...
    @property
    def probability(self) -> float: ...
    @property
    def box(self) -> _Box: ...  # x, y, width, height
    @property
    def regions(self) -> int: ...
    @property
    def track(self) -> int | None: ...
    @property
    def pose(self) -> _Numbers | None: ...  # 4 x 4
    @property
    def contours(self) -> list[tuple[int, str]]: ...
    @property
    def hypotheses(self) -> list[Hypothesis]: ...
    @property
    def rivals(self) -> list[Hypothesis]: ...

class Contour:
    @property
    def box(self) -> _Box: ...
    @property
    def centre_px(self) -> tuple[float, float]: ...
    @property
    def area_px(self) -> float: ...
    @property
    def mean_rgb(self) -> tuple[float, float, float]: ...
    @property
    def is_hole(self) -> bool: ...
    @property
    def points(self) -> numpy.typing.NDArray[numpy.int32]: ...  # N x 2, the border's pixels

class Recognition:
    """What was seen in a frame: a list of Objects, good for as long as you keep it."""
    @property
    def objects(self) -> list[Object]: ...
    @property
    def contours(self) -> list[Contour]: ...
    @property
    def dropped_regions(self) -> int: ...
    @property
    def elapsed_ms(self) -> float: ...
    @property
    def left_undone(self) -> dict[str, int]: ...
    def camera_matrix(self, object: Object) -> _Numbers: ...  # 3 x 3, that it was looked for with
    def distortion(self, object: Object) -> _Numbers: ...  # k1 k2 p1 p2 k3
    def __getitem__(self, place: int) -> Object: ...
    def __iter__(self) -> Iterator[Object]: ...
    def __len__(self) -> int: ...

class KnownObject:
    @property
    def object(self) -> str: ...
    @property
    def class_count(self) -> int: ...
    @property
    def diameter(self) -> float: ...
    @property
    def least(self) -> _Numbers: ...
    @property
    def most(self) -> _Numbers: ...
    @property
    def centre(self) -> _Numbers: ...

class Recogniser:
    def __init__(
        self,
        indexes: _Index | Iterable[_Index] = (),
        *,
        camera: dict[str, float] | numpy.typing.ArrayLike | None = None,
        distortion: numpy.typing.ArrayLike | None = None,
        size: tuple[int, int] | None = None,
        configuration: _Path | None = None,
        format: Literal["bgr", "rgb"] = "bgr",
        **options: Any,
    ) -> None: ...
    def recognise(
        self, frame: numpy.typing.NDArray[Any], format: str | None = None, missed: int = 0
    ) -> Recognition: ...
    @property
    def objects(self) -> list[KnownObject]: ...
    @property
    def warnings(self) -> list[str]: ...

def compile(
    scene: _Path, output: _Path | None = None, *, progress: bool = False, **options: Any
) -> pathlib.Path: ...
