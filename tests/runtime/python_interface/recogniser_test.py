"""The Python interface beside what the programs say: recogniser_test.py SOURCE_DIR PROGRAMS

The frames are rendered ones; aspect-replay is given the same pixels as raw frames."""
import ast
import gc
import inspect
import json
import os
import pathlib
import re
import resource
import subprocess
import sys
import tempfile
import threading
import unittest

import numpy
from PIL import Image

import aspect
import aspect.options

SOURCE, PROGRAMS = (pathlib.Path(word).resolve() for word in sys.argv[1:3])
FOLDER = tempfile.TemporaryDirectory()
HERE = pathlib.Path(FOLDER.name)
CUBE = HERE / "cube.aspect"


def setUpModule():
    os.environ["ASPECTC"] = str(PROGRAMS / "aspectc")
    written = aspect.compile(SOURCE / "compiler/models/cube.b", CUBE, level=2, no_store=True)
    assert written == CUBE
    subprocess.run([PROGRAMS / "aspectc", "render", SOURCE / "compiler/models/cube.b", "--from",
                    "1,0.7,0.5", "-o", HERE / "frame.png"], check=True, capture_output=True)


def rgb_frame():
    return numpy.array(Image.open(HERE / "frame.png").convert("RGB"))


def replayed(pixels, fourcc, *options):
    height, width = pixels.shape[:2]
    file = HERE / f"clip.{width}x{height}.{fourcc}"
    file.write_bytes(numpy.ascontiguousarray(pixels).tobytes())
    out = subprocess.run([PROGRAMS / "aspect-replay", "--index", CUBE, *options, file], check=True,
                         capture_output=True, text=True).stdout
    return json.loads(out)["objects"]


class Frames(unittest.TestCase):
    def test_python_is_told_what_aspect_replay_prints(self):
        frame = rgb_frame()
        seen = aspect.Recogniser(CUBE, format="rgb").recognise(frame)
        expected = replayed(frame, "RGB3")
        self.assertEqual(len(seen), len(expected))
        for one, printed in zip(seen, expected):
            self.assertEqual(one.verdict, printed["verdict"])
            self.assertAlmostEqual(one.probability, printed["probability"], 6)
            self.assertEqual(list(one.box), printed["box"])
            self.assertEqual(len(one.hypotheses), len(printed["hypotheses"]))
            for hypothesis, line in zip(one.hypotheses, printed["hypotheses"]):
                self.assertEqual(hypothesis.object, line["object"])
                self.assertEqual(hypothesis.class_id, line["class"])
                self.assertEqual(hypothesis.score, line["score"])
                self.assertEqual([list(pair) for pair in hypothesis.contours], line["contours"])
                self.assertEqual(hypothesis.pose is None, "pose" not in line)
                if hypothesis.pose is not None:
                    self.assertEqual(list(hypothesis.pose.quaternion), line["pose"]["quaternion"])
                    self.assertEqual(list(hypothesis.pose.translation), line["pose"]["translation"])
                    self.assertEqual(list(hypothesis.pose.covariance.ravel()),
                                     line["pose"]["covariance"])

    def test_a_pose_takes_the_object_to_where_it_is_seen(self):
        recogniser = aspect.Recogniser(CUBE, format="rgb")
        recognition = recogniser.recognise(rgb_frame())
        seen, known = recognition[0], recogniser.objects[0]
        self.assertEqual((seen.object, seen.verdict), ("cube", "match"))
        self.assertEqual(seen.pose.shape, (4, 4))
        numpy.testing.assert_allclose(seen.pose[:3, :3] @ seen.pose[:3, :3].T, numpy.eye(3), atol=1e-9)
        self.assertAlmostEqual(numpy.linalg.det(seen.pose[:3, :3]), 1, 9)
        numpy.testing.assert_array_equal(seen.pose, seen.hypotheses[0].pose.matrix)
        corners = numpy.array([[(known.least, known.most)[k >> axis & 1][axis] for axis in range(3)] + [1]
                               for k in range(8)])
        camera = recognition.camera_matrix(seen) @ (seen.pose @ corners.T)[:3]
        x, y = camera[:2] / camera[2]
        left, top, width, height = seen.box
        self.assertLess(abs(x.min() - left) + abs(y.min() - top), 4)
        self.assertLess(abs(x.max() - left - width) + abs(y.max() - top - height), 4)

    def test_every_way_an_array_lies_in_memory_is_the_same_frame(self):
        rgb = rgb_frame()
        recogniser = aspect.Recogniser([CUBE])
        pose = aspect.Recogniser(CUBE, format="rgb").recognise(rgb)[0].pose
        bgr = numpy.ascontiguousarray(rgb[..., ::-1])
        with_gap = numpy.full((rgb.shape[0], rgb.shape[1] + 9, 3), 200, numpy.uint8)
        with_gap[:, :-9] = bgr
        alpha = numpy.dstack([bgr, numpy.full(bgr.shape[:2], 7, numpy.uint8)])
        upside_down = numpy.ascontiguousarray(bgr[::-1])[::-1]
        for frame, format in ((bgr, None), (bgr, "bgr"), (rgb, "rgb"), (rgb[..., ::-1], None),
                              (with_gap[:, :-9], None), (alpha, None), (alpha[..., [2, 1, 0, 3]].copy(), "rgba"),
                              (upside_down, None)):
            with self.subTest(format=format, strides=frame.strides):
                numpy.testing.assert_array_equal(recogniser.recognise(frame, format)[0].pose, pose)

    def test_frames_of_other_formats_are_read_by_name(self):
        noise = numpy.random.default_rng(3)
        for format, shape, fourcc in (("yuyv", (48, 64, 2), "YUYV"), ("nv12", (72, 64), "NV12"),
                                      ("bayer_rggb", (48, 64), "RGGB")):
            pixels = noise.integers(0, 255, shape, dtype=numpy.uint8)
            recognition = aspect.Recogniser(CUBE).recognise(pixels, format)
            file = HERE / f"{format}.64x48.{fourcc}"
            file.write_bytes(pixels.tobytes())
            printed = json.loads(subprocess.run([PROGRAMS / "aspect-replay", "--index", CUBE, file],
                                                check=True, capture_output=True, text=True).stdout)
            self.assertEqual([list(one.box) for one in recognition],
                             [one["box"] for one in printed["objects"]])

    def test_no_frame_is_copied_and_none_that_would_have_to_be_is_taken(self):
        rgb = rgb_frame()
        recogniser = aspect.Recogniser(CUBE)
        for frame in (rgb[:, ::2], rgb[:, ::-1], numpy.asfortranarray(rgb), rgb.transpose(1, 0, 2)):
            with self.assertRaisesRegex(ValueError, "ascontiguousarray"):
                recogniser.recognise(frame)
        for frame, wrong in ((rgb.astype(numpy.float32), TypeError), (rgb.astype(numpy.int8), TypeError),
                             (rgb[..., :2], ValueError), (rgb[0], ValueError), (rgb[None], ValueError),
                             (rgb[..., 0].copy(), aspect.Error), (rgb[:0], aspect.Error), ("frame.png", TypeError)):
            with self.assertRaises(wrong):
                recogniser.recognise(frame)
        with self.assertRaisesRegex(ValueError, "it is one of bgr, rgb"):
            recogniser.recognise(rgb, "hsv")

    def test_results_outlive_the_next_frame_and_the_recogniser(self):
        rgb = rgb_frame()
        recogniser = aspect.Recogniser(CUBE, format="rgb")
        first = recogniser.recognise(rgb)
        before = repr(first), first[0].pose.copy(), first.contours[0].points.copy()
        recogniser.recognise(numpy.zeros_like(rgb))
        hypothesis = first[0].hypotheses[0]
        del recogniser
        gc.collect()
        self.assertEqual(repr(first), before[0])
        numpy.testing.assert_array_equal(first[0].pose, before[1])
        numpy.testing.assert_array_equal(first.contours[0].points, before[2])
        del first
        gc.collect()
        self.assertEqual(hypothesis.object, "cube")

    def test_contours_are_the_borders_of_regions(self):
        recognition = aspect.Recogniser(CUBE, format="rgb").recognise(rgb_frame())
        self.assertGreaterEqual(len(recognition.contours), 3)
        for contour in recognition.contours:
            x, y, width, height = contour.box
            points = contour.points
            self.assertEqual(tuple(points.min(0)), (x, y))
            self.assertEqual(tuple(points.max(0)), (x + width - 1, y + height - 1))
            self.assertLessEqual(numpy.abs(numpy.diff(points, axis=0)).max(), 1)
        for place, name in recognition[0].contours:
            self.assertRegex(name, "^[A-Z]+$")
            self.assertFalse(recognition.contours[place].is_hole)


class Running(unittest.TestCase):
    def test_others_run_while_a_frame_is_recognised(self):
        # With the lock held no step of the other thread falls between the two of this one.
        recogniser = aspect.Recogniser(CUBE, format="rgb")
        frame = numpy.tile(rgb_frame(), (2, 2, 1))
        steps, ended = [0], threading.Event()

        def count():
            while not ended.is_set():
                steps[0] += 1
        interval = sys.getswitchinterval()
        sys.setswitchinterval(0.6)
        thread = threading.Thread(target=count)
        try:
            thread.start()
            before = steps[0]
            recogniser.recognise(frame)
            after = steps[0]
        finally:
            ended.set()
            sys.setswitchinterval(interval)
            thread.join()
        self.assertGreater(after, before)

    def test_one_recogniser_serves_several_threads(self):
        frame = rgb_frame()
        recogniser = aspect.Recogniser(CUBE, format="rgb")
        expected, wrong = recogniser.recognise(frame)[0].pose, []

        def many():
            for _ in range(20):
                if not numpy.array_equal(recogniser.recognise(frame)[0].pose, expected):
                    wrong.append(1)
        threads = [threading.Thread(target=many) for _ in range(4)]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        self.assertFalse(wrong)

    def test_nothing_is_lost_from_frame_to_frame(self):
        frame = rgb_frame()
        recogniser = aspect.Recogniser(CUBE, format="rgb")
        for round in range(400):
            recognition = recogniser.recognise(frame)
            [one.pose for one in recognition], recognition.contours, repr(recognition)
            if round == 100:
                before = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
        self.assertLess(resource.getrusage(resource.RUSAGE_SELF).ru_maxrss - before, 2048)  # KiB

    def test_a_track_is_a_number_that_stays(self):
        recogniser = aspect.Recogniser(CUBE, format="rgb", track=True)
        numbers = {recogniser.recognise(rgb_frame())[0].track for _ in range(5)}
        self.assertEqual(len(numbers), 1)
        self.assertIsInstance(numbers.pop(), int)


class Opening(unittest.TestCase):
    def test_indexes_are_paths_or_bytes(self):
        for indexes in (CUBE, str(CUBE), [CUBE], CUBE.read_bytes(), [memoryview(CUBE.read_bytes())]):
            recogniser = aspect.Recogniser(indexes)
            self.assertEqual([known.object for known in recogniser.objects], ["cube"])
        self.assertEqual(recogniser.warnings, [])
        self.assertIn("cube", repr(recogniser))

    def test_options_are_those_of_a_configuration(self):
        frame = rgb_frame()
        self.assertEqual(len(aspect.Recogniser(CUBE, format="rgb", top=1).recognise(frame)[0].hypotheses), 1)
        elsewhere = aspect.Recogniser(CUBE, region_of_interest=(0, 0, 40, 40)).recognise(frame)
        self.assertEqual(len(elsewhere), 0)
        file = HERE / "camera.toml"
        file.write_text("[recognition]\ntop = 1\nmin_confidence = 1.0\n")
        self.assertEqual(len(aspect.Recogniser(CUBE, configuration=file, top=2, format="rgb")
                             .recognise(frame)[0].hypotheses), 2)

    def test_no_key_of_the_tables_is_missing(self):
        def text_of(source):
            return (SOURCE / "runtime/service" / source).read_text()

        keys = set(re.findall(r'SegmentationValue\{"(\w+)"', text_of("segmentation_values.cpp")))
        keys |= set(re.findall(r'kKey = "(\w+)"', text_of("segmentation_table.cpp")))
        self.assertEqual(keys, set(aspect.options.SEGMENTATION))
        text = text_of("configuration.cpp")
        text = text[text.index("read_recognition("):]
        text = text[:text.index("return reader.finish()")]
        self.assertEqual(set(re.findall(r'reader\.read\("(\w+)"', text)), set(aspect.options.RECOGNITION))

    def test_a_camera_is_a_dict_or_what_opencv_gives(self):
        frame = rgb_frame()
        height, width = frame.shape[:2]
        matrix = numpy.array([[600.0, 0, 250], [0, 610, 260], [0, 0, 1]])
        lens = numpy.array([[0.01, -0.02, 0.001, 0.002, 0.003]])
        by_matrix = aspect.Recogniser(CUBE, camera=matrix, distortion=lens, size=(width, height), format="rgb")
        by_dict = aspect.Recogniser(CUBE, format="rgb", camera=dict(
            width=width, height=height, fx=600.0, fy=610, cx=250, cy=260.0, k1=0.01, k2=-0.02, p1=0.001,
            p2=0.002, k3=0.003))
        for recogniser in (by_matrix, by_dict):
            recognition = recogniser.recognise(frame)
            numpy.testing.assert_array_equal(recognition.camera_matrix(recognition[0]), matrix)
            numpy.testing.assert_array_equal(recognition.distortion(recognition[0]), lens[0])
        for wrong in (dict(camera=matrix), dict(distortion=lens), dict(camera=matrix[:2], size=(9, 9)),
                      dict(camera=matrix, size=(9, 9), distortion=[1, 2])):
            with self.assertRaises((TypeError, ValueError)):
                aspect.Recogniser(CUBE, **wrong)

    def test_what_is_wrong_is_said(self):
        with self.assertRaises(FileNotFoundError):
            aspect.Recogniser(HERE / "none.aspect")
        with self.assertRaisesRegex(TypeError, "trakc; is track meant"):
            aspect.Recogniser(CUBE, trakc=True)
        with self.assertRaisesRegex(aspect.Error, "top is 0"):
            aspect.Recogniser(CUBE, top=0)
        with self.assertRaisesRegex(aspect.Error, "index 0"):
            aspect.Recogniser(b"not an index")
        with self.assertRaisesRegex(aspect.Error, "no class index"):
            aspect.Recogniser()
        with self.assertRaises(IndexError):
            aspect.Recogniser(CUBE).recognise(rgb_frame())[99]


class Compiling(unittest.TestCase):
    def test_a_failure_is_aspectcs_own_line(self):
        broken = HERE / "broken.b"
        broken.write_text("polygon {")
        with self.assertRaisesRegex(aspect.Error, "broken.b:1"):
            aspect.compile(broken, HERE / "broken.aspect", no_store=True)
        with self.assertRaises(FileNotFoundError):
            aspect.compile(HERE / "none.b")
        with self.assertRaisesRegex(aspect.Error, "level"):
            aspect.compile(SOURCE / "compiler/models/cube.b", HERE / "x.aspect", level=99)


class Stubs(unittest.TestCase):
    def test_the_stubs_have_what_the_module_has(self):
        stub = ast.parse((pathlib.Path(aspect.__file__).parent / "__init__.pyi").read_text())
        classes = {node.name: {item.name for item in node.body if isinstance(item, ast.FunctionDef)}
                   for node in stub.body if isinstance(node, ast.ClassDef)}
        functions = {node.name for node in stub.body if isinstance(node, ast.FunctionDef)}
        self.assertEqual(set(classes) | functions, set(aspect.__all__))
        for name, members in classes.items():
            real = {member for member in vars(getattr(aspect, name)) if not member.startswith("_")}
            self.assertEqual({member for member in members if not member.startswith("_")}, real, name)
        for function in functions | {"Recogniser"}:
            self.assertTrue(inspect.getdoc(getattr(aspect, function)))


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1], verbosity=2)
