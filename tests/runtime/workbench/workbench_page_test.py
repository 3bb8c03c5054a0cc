"""The page in a browser, before aspect-replay --serve: what it shows, and what it changes where.

usage: workbench_page_test.py ASPECT_REPLAY PAGE_TEST_DATA CLIP_DAEMON TEST...
"""
import json
import re
import signal
import socket
import subprocess
import sys
import tempfile
import time
import unittest
import urllib.error
import urllib.request
from pathlib import Path

from browser import Browser

CONFIGURATION = """# Mine.
[segmentation]
chroma_step = 8  # measured
"""
KEYS = {"intensity_min", "chroma_step", "noise_steps", "intensity_step", "area_min_px",
        "thickness_min_px", "smooth", "one_blob", "range_step_length", "range_steps_min",
        "range_steps_max", "range_depth_step", "range_normal_step_deg"}
# How many colours the segmentation has, and how much of it is black.
# Read from a copy: the browser would complain of the page's own canvas being read often.
PIXELS = """const pixels = id => {
  const canvas = document.getElementById(id), copy = new OffscreenCanvas(canvas.width, canvas.height);
  const pen = copy.getContext("2d", {willReadFrequently: true});
  pen.drawImage(canvas, 0, 0);
  return new Uint32Array(pen.getImageData(0, 0, copy.width, copy.height).data.buffer);
};
"""
REGIONS = PIXELS + """const data = pixels("regions");
return [new Set(data).size, data.filter(pixel => pixel === 0xff000000).length];"""


class Served:
    """A program with its page."""

    def __init__(self, folder):
        program, data, _ = ARGUMENTS
        self.folder = Path(folder)
        subprocess.run([data, folder], check=True)
        self.file = self.folder / "aspectd.toml"
        self.file.write_text(CONFIGURATION)
        self.recorded = self.folder / "recorded"
        self.program = subprocess.Popen(
            [program, "--index", self.folder / "flag.aspect", "--config", self.file, "--record", self.recorded,
             "--serve", "--port", "0", "--pace", "10", self.folder / "frames"], stderr=subprocess.PIPE, text=True)
        told = self.program.stderr.readline()
        self.url, self.token = re.search(r"(http://\S+/)#token=(\w+)", told).groups()

    def post(self, action, body, token=None, **headers):
        request = urllib.request.Request(
            self.url + "act/" + action, json.dumps(body).encode(), method="POST",
            headers={"Content-Type": "application/json",
                     **({"Aspect-Token": token} if token else {}), **headers})
        try:
            with urllib.request.urlopen(request, timeout=10) as answer:
                return answer.status, json.load(answer)
        except urllib.error.HTTPError as error:
            return error.code, error.read().decode()

    def state(self):
        with urllib.request.urlopen(self.url + "state", timeout=10) as answer:
            return json.load(answer)

    def end(self):
        self.program.terminate()
        complaints = self.program.stderr.read()
        self.program.stderr.close()
        return self.program.wait(), complaints


class ThePage(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        cls.served = Served(cls.folder.name)
        cls.page = Browser(1000, 700).__enter__()
        cls.open()

    @classmethod
    def open(cls):
        cls.page.open(cls.served.url + "#token=" + cls.served.token)
        cls.page.wait_for("return document.getElementById('regions').dataset.settings && "
                          "document.querySelectorAll('.value').length >= 13")

    @classmethod
    def tearDownClass(cls):
        cls.page.__exit__()
        cls.served.end()
        cls.folder.cleanup()

    def setUp(self):
        self.assertEqual(self.served.post("forget", {}, self.served.token)[0], 200)

    def tearDown(self):
        self.assertEqual(self.page.console(), [])
        self.assertEqual([url for url in self.page.requests()
                          if not url.startswith(self.served.url)], [])

    def value(self, key):
        return next(each["value"] for each in self.served.state()["values"] if each["key"] == key)

    def type_value(self, key, text):
        self.page.run("""const input = document.getElementById(arguments[0]);
            input.value = arguments[1]; input.dispatchEvent(new Event("change"));""", key, text)

    def notice(self, words):
        return self.page.wait_for(
            "const n = document.getElementById('notice'); return !n.hidden && "
            f"n.textContent.includes({json.dumps(words)}) && n.textContent")

    def test_everything_is_there(self):
        self.assertEqual(self.page.run("return location.hash"), "")
        names = self.page.run(
            "return [...document.querySelectorAll('[data-key]')].map(each => each.dataset.key)")
        self.assertEqual(set(names), KEYS)
        words = self.page.run("return [...document.querySelectorAll('.value .words')]"
                              ".map(each => each.textContent)")
        self.assertEqual(words, [each["words"] for each in self.served.state()["values"]])
        for canvas in ("picture", "regions", "result", "plot"):
            colours = self.page.run(PIXELS + "return new Set(pixels(arguments[0])).size", canvas)
            self.assertGreater(colours, 2, canvas)
        self.assertTrue(self.page.run("return document.getElementById('models').children.length"))
        self.page.wait_for("return document.querySelector('#objects b')")

    def test_a_slider_changes_the_regions_at_once_and_keeps_nothing(self):
        self.page.click("#pause")
        self.page.wait_for("return document.getElementById('pause').textContent === 'Play'")
        colours, black = self.page.run(REGIONS)
        self.assertGreater(colours, 2)
        self.page.run("""const slider = document.getElementById("intensity_min_slider");
            slider.value = 765; slider.dispatchEvent(new Event("input"));""")
        self.page.wait_for(REGIONS.replace("return [", "const [n, black] = [") +
                           f"return black > {black}")
        self.assertEqual(self.value("intensity_min"), 765)
        self.assertEqual(self.served.file.read_text(), CONFIGURATION)
        self.page.click("#forget")
        self.page.wait_for(REGIONS.replace("return [", "const [n, black] = [") +
                           f"return n === {colours} && black === {black}")
        self.page.click("#pause")
        self.page.wait_for("return document.getElementById('pause').textContent === 'Pause'")

    def test_a_region_of_interest_is_drawn_moved_and_taken_away(self):
        self.page.drag("#region", 120, 80, start=(-80, -60))
        self.page.wait_for("return document.getElementById('inside').getAttribute('visibility') "
                           "=== 'visible'")
        first = self.wait_for_region(lambda region: region and region[2] > 20)
        width = self.page.run("return document.getElementById('region').clientWidth")
        scale = self.page.run("return document.getElementById('regions').width") / width
        self.assertAlmostEqual(first[2], 120 * scale, delta=3)
        self.assertAlmostEqual(first[3], 80 * scale, delta=3)
        self.page.drag("#inside", 30, 10)
        moved = self.wait_for_region(lambda region: region[0] != first[0])
        self.assertEqual(moved[2:], first[2:])
        self.assertAlmostEqual(moved[0] - first[0], 30 * scale, delta=3)
        self.page.drag("#handles [data-edges=se]", 20, 20)
        self.wait_for_region(lambda region: region[:2] == moved[:2] and region[2] > moved[2])
        self.page.click("#whole")
        self.wait_for_region(lambda region: region is None)

    def wait_for_region(self, is_right):
        for _ in range(100):
            region = self.served.state()["region"]
            if is_right(region):
                return region
            self.page.run("return new Promise(done => setTimeout(done, 20))")
        self.fail(f"the region is {region}")

    def test_what_is_invalid_is_refused_and_what_is_right_is_written(self):
        # Typed while the field has the focus, as somebody would.
        self.type_value("chroma_step", 999)
        fault = "[segmentation] chroma_step is 999; it must be a whole number from 1 to 255"
        self.page.wait_for("return [...document.querySelectorAll('.fault')].some(each => "
                           f"!each.hidden && each.textContent === {json.dumps(fault)})")
        self.page.click("#save")
        self.notice(fault)
        self.assertEqual(self.served.file.read_text(), CONFIGURATION)
        self.type_value("chroma_step", 12)
        self.page.wait_for("return ![...document.querySelectorAll('.fault')].some(each => "
                           "!each.hidden)")
        self.page.click("#save")
        self.notice("is written; what it was is kept as aspectd.toml.1")
        self.assertEqual(self.served.file.read_text(), CONFIGURATION.replace("= 8", "= 12"))
        kept = self.served.folder / "aspectd.toml.1"
        self.assertEqual(kept.read_text(), CONFIGURATION)
        # As it was, for the other tests.
        self.type_value("chroma_step", 8)
        self.page.wait_for("return !document.getElementById('forget').disabled")
        self.page.click("#save")
        self.page.wait_for("return document.getElementById('forget').disabled")
        self.assertEqual(self.served.file.read_text(), CONFIGURATION)

    def test_ten_frames_are_recorded_where_the_option_says(self):
        self.page.click("#record")
        self.notice("10 frames are in")
        files = sorted(path.name for path in self.served.recorded.iterdir())
        self.assertEqual(len(files), 10)
        self.assertTrue(files[0].startswith("frame_000001."))

    def test_nobody_else_changes_anything(self):
        change = {"chroma_step": 33}
        own = {"Origin": self.served.url.rstrip("/")}
        token = self.served.token
        self.assertEqual(self.served.post("settings", change, **own)[0], 403)
        self.assertEqual(self.served.post("settings", change, "0" * 32, **own)[0], 403)
        self.assertEqual(self.served.post("save", {}, **own)[0], 403)
        self.assertEqual(self.served.post("save", {}, "0" * 32, **own)[0], 403)
        self.assertEqual(self.served.post("settings", change, token,
                                          Origin="http://evil.example")[0], 403)
        self.assertEqual(self.served.post("settings", change, token, Host="evil.example")[0], 403)
        self.assertEqual(self.served.post("settings", change, token,
                                          **{"Content-Type": "text/plain"})[0], 415)
        self.assertEqual(self.served.post("settings", {"a": "b" * 70000}, token)[0], 413)
        with self.assertRaises(urllib.error.HTTPError):
            urllib.request.urlopen(self.served.url + "act/save", timeout=10)
        self.assertEqual(self.value("chroma_step"), 8)
        self.assertEqual(self.served.file.read_text(), CONFIGURATION)

    def test_without_the_token_the_page_shows_all_and_changes_nothing(self):
        self.page.run("sessionStorage.clear()")
        self.page.open(self.served.url)
        self.page.wait_for("return document.getElementById('regions').dataset.settings && "
                           "document.querySelectorAll('.value').length >= 13")
        self.notice("open the address that the program printed")
        enabled = self.page.run("return [...document.querySelectorAll('button, input, select')]"
                                ".filter(each => !each.disabled).length")
        self.assertEqual(enabled, 0)
        self.page.drag("#region", 100, 80)
        self.assertIsNone(self.served.state()["region"])
        self.open()

    def test_a_narrow_page_has_nothing_beside_it(self):
        for width in (380, 900, 1600, 1000):
            self.page._devtools("Emulation.setDeviceMetricsOverride",
                                {"width": width, "height": 800, "deviceScaleFactor": 1,
                                 "mobile": False})
            self.assertLessEqual(
                self.page.run("return document.documentElement.scrollWidth"), width)


class TheDaemonsPage(unittest.TestCase):
    """aspectd with a clip for a camera; without a browser."""

    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        folder = Path(cls.folder.name)
        subprocess.run([ARGUMENTS[1], folder], check=True)
        # As YUYV: a light square on black.
        frame = b"".join(yuyv_row(12 < y < 36) for y in range(48))
        (folder / "clip.64x48.YUYV").write_bytes(2 * frame)
        cls.file = folder / "aspectd.toml"
        cls.text = ('indexes = ["flag.aspect"]\n[camera]\nrate = 100\n[camera.controls]\n'
                    f'gain = 20  # mine\n[output.http]\nport = {free_port()}\n')
        cls.file.write_text(cls.text)
        cls.program = subprocess.Popen([ARGUMENTS[2], cls.file, folder / "clip.64x48.YUYV"],
                                       stderr=subprocess.PIPE, text=True)
        cls.url, cls.token = re.search(r"(http://\S+/)#token=(\w+)",
                                       cls.wait_for_words("page: ")).groups()
        cls.wait_for_words("streaming")

    @classmethod
    def tearDownClass(cls):
        cls.program.terminate()
        cls.program.stderr.read()
        cls.program.stderr.close()
        cls.program.wait()
        cls.folder.cleanup()

    @classmethod
    def wait_for_words(cls, words):
        for line in cls.program.stderr:
            if words in line:
                return line
        raise AssertionError("aspectd ended")

    post, state = Served.post, Served.state

    def last_line(self):
        with urllib.request.urlopen(self.url + "line", timeout=10) as answer:
            return json.load(answer)["line"]

    def until(self, is_right):
        for _ in range(200):
            if is_right():
                return
            time.sleep(0.02)
        self.fail("it does not come true")

    def sees(self, count):
        return len(self.last_line().get("objects", [0] * 9)) == count

    def read_again(self):
        self.program.send_signal(signal.SIGHUP)
        self.wait_for_words("reloaded")

    def test_what_the_page_changes_reaches_the_loop_until_the_file_is_read_again(self):
        self.until(lambda: self.sees(1))
        self.assertEqual(self.post("settings", {"intensity_min": 765}, self.token)[0], 200)
        self.until(lambda: self.sees(0))
        self.read_again()
        self.until(lambda: self.sees(1))
        self.assertFalse(self.state()["changed"])

    def test_controls_are_set_and_written_automatics_first(self):
        controls = {each["name"]: each for each in self.state()["controls"]}
        self.assertEqual(controls["gain"]["value"], 20)
        self.assertTrue(controls["white_balance_temperature"]["inactive"])
        for name, value in (("white_balance_temperature", 5000), ("gain", 31),
                            ("white_balance_automatic", 0)):
            self.assertEqual(self.post("control", {"name": name, "value": value}, self.token)[1]
                             .get("value"), value)
        self.assertEqual(self.post("save", {}, self.token)[1].get("kept"), f"{self.file}.1")
        self.assertEqual(self.file.read_text(), self.text.replace(
            "gain = 20  # mine\n", "white_balance_automatic = 0\ngain = 31  # mine\n"
            "white_balance_temperature = 5000\n"))
        self.read_again()
        sequence = self.last_line().get("sequence", 0)
        self.until(lambda: self.last_line().get("sequence", 0) > sequence + 20)


class TheProgram(unittest.TestCase):
    def run_replay(self, *arguments):
        return subprocess.run([ARGUMENTS[0], *map(str, arguments)], text=True, capture_output=True,
                              timeout=20)

    def test_wrong_usage_and_frames_that_are_none_end_with_one_line(self):
        with tempfile.TemporaryDirectory() as folder:
            subprocess.run([ARGUMENTS[1], folder], check=True)
            index, frames = folder + "/flag.aspect", folder + "/frames"
            for wrong in (["--serve"], ["--serve", frames, "--overlay", folder],
                          ["--serve", frames, "--explain"], [frames, "--port", "0"],
                          [frames, "--record", folder], ["--serve", frames, "--port", "70000"]):
                self.assertEqual(self.run_replay("--index", index, *wrong).returncode, 2, wrong)
            for wrong in ([folder + "/none"], [frames, "--address", "nowhere.example"], [index]):
                ended = self.run_replay("--index", index, "--serve", "--port", "0", *wrong)
                self.assertEqual(ended.returncode, 1)
                complaints = [line for line in ended.stderr.splitlines() if "page: " not in line]
                self.assertEqual(len(complaints), 1, complaints)


def yuyv_row(has_square):
    """64 pixels, all grey."""
    return bytes(byte for x in range(64)
                 for byte in (200 if has_square and 16 < x < 48 else 16, 128))


def free_port():
    with socket.socket() as probe:
        probe.bind(("127.0.0.1", 0))
        return probe.getsockname()[1]


if __name__ == "__main__":
    ARGUMENTS = sys.argv[1:4]
    unittest.main(argv=[sys.argv[0], *sys.argv[4:]])
