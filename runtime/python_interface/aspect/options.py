"""Keywords as the text of a configuration, which the library reads and checks."""
import difflib
import json
import numbers

# As in the tables of a configuration, see `aspectd --help`.
RECOGNITION = frozenset((
    "anywhere", "matching", "min_confidence", "ranking", "score_min", "search_every",
    "shortlist_slack", "time_limit_ms", "top", "track"))
SEGMENTATION = frozenset((
    "area_min_px", "chroma_step", "intensity_min", "intensity_step", "noise_steps", "one_blob",
    "range_depth_step", "range_normal_step_deg", "range_step_length", "range_steps_max",
    "range_steps_min", "region_of_interest", "smooth", "thickness_min_px"))


def literal(value):
    """A value as TOML has it."""
    if isinstance(value, bool) or type(value).__name__ in ("bool_", "bool"):
        return "true" if value else "false"
    if isinstance(value, numbers.Integral):
        return str(int(value))
    if isinstance(value, numbers.Real):
        return repr(float(value))
    if isinstance(value, str):
        return json.dumps(value, ensure_ascii=False)
    return "[" + ", ".join(literal(each) for each in value) + "]"


def camera_values(camera, distortion, size):
    """The keys of [camera] from a dict of them, or from what OpenCV's calibration gives."""
    if isinstance(camera, dict):
        if distortion is not None or size is not None:
            raise TypeError("a camera given as a dict has its size and distortion in it")
        return camera
    if size is None:
        raise TypeError("a camera matrix needs size=(width, height) of the pictures that it was "
                        "calibrated with")
    rows = [[float(number) for number in row] for row in camera]
    if [len(row) for row in rows] != [3, 3, 3]:
        raise ValueError("a camera is a dict with width, height, fx, fy, cx, cy or a matrix of 3 x 3")
    values = dict(width=int(size[0]), height=int(size[1]), fx=rows[0][0], fy=rows[1][1],
                  cx=rows[0][2], cy=rows[1][2])
    if distortion is not None:
        numbers_of_lens = [float(number) for row in distortion
                           for number in (row if hasattr(row, "__len__") else (row,))]
        if len(numbers_of_lens) not in (4, 5):
            raise ValueError("distortion is k1, k2, p1, p2 and maybe k3; no other lens is known")
        values.update(zip(("k1", "k2", "p1", "p2", "k3"), numbers_of_lens))
    return values


def configuration_text(options, camera=None, distortion=None, size=None):
    """TOML of keyword options; TypeError names the nearest one of an unknown one."""
    lines = []
    for key, value in options.items():
        if key not in RECOGNITION | SEGMENTATION:
            near = difflib.get_close_matches(key, RECOGNITION | SEGMENTATION, 1)
            raise TypeError(f"no option is called {key}" + (f"; is {near[0]} meant?" if near else
                            "; aspectd --help lists those of [recognition] and [segmentation]"))
        table = "recognition" if key in RECOGNITION else "segmentation"
        lines.append(f"{table}.{key} = {literal(value)}\n")
    if camera is not None:
        for key, value in camera_values(camera, distortion, size).items():
            lines.append(f"camera.{key} = {literal(value)}\n")
    elif distortion is not None or size is not None:
        raise TypeError("distortion and size belong to a camera; give camera= as well")
    return "".join(lines)
