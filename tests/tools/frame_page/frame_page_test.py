"""The page of aspect-replay --html in a real browser: frame_page_test.py ASPECTC
ASPECT-REPLAY INDEX-FOLDER SCENES.
Frames are rendered from known directions, so that errors and drawn models have something to be held
against."""
import base64
import json
import math
import shutil
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

from browser import Browser

ASPECTC, REPLAY, INDEXES, SCENES = sys.argv[1:5]
VIEWS = {"cube": (0.5, -0.6, 0.62), "l_shape": (0.45, 0.5, 0.74)}
HOSTILE = "5<!--<script>'\"&amp;.png"  # ends no element and begins none
RIGHT, ESCAPE = "\ue014", "\ue00c"

# The share of a square of 64 x 64 in which two pictures show the same, each scaled to what is in it:
# nothing, or a colour by the order of its channels and which of them are strong.
LIKENESS = """
const [drawn, traced] = arguments;
const kindOf = (r, g, b, a) => {
  const most = Math.max(r, g, b);
  return a < 128 || most < 30 ? "none" : [r, g, b].map(part => part > most / 2 ? 1 : 0).join("");
};
const kindsOf = source => {
  const { width, height } = source, canvas = new OffscreenCanvas(width, height);
  const pen = canvas.getContext("2d");
  pen.drawImage(source, 0, 0);
  const pixels = pen.getImageData(0, 0, width, height).data;
  const at = (x, y) => kindOf(...pixels.slice(4 * (y * width + x), 4 * (y * width + x) + 4));
  let left = width, top = height, right = 0, bottom = 0;
  for (let y = 0; y < height; ++y) for (let x = 0; x < width; ++x) if (at(x, y) !== "none") {
    left = Math.min(left, x); right = Math.max(right, x);
    top = Math.min(top, y); bottom = Math.max(bottom, y);
  }
  return [...Array(4096).keys()].map(k => at(
    Math.round(left + (k % 64 + 0.5) / 64 * (right - left)),
    Math.round(top + (Math.floor(k / 64) + 0.5) / 64 * (bottom - top))));
};
return (async () => {
  const canvas = document.createElement("canvas");
  if (!drawModel(canvas, drawn, { view: JSON.parse(traced.view), roll: traced.roll })) return 0;
  const image = new Image();
  image.src = traced.uri;
  await image.decode();
  const turned = new OffscreenCanvas(image.width, image.height), pen = turned.getContext("2d");
  pen.translate(image.width / 2, image.height / 2);
  pen.rotate(traced.roll);
  pen.drawImage(image, -image.width / 2, -image.height / 2);
  const a = kindsOf(canvas), b = kindsOf(turned);
  return a.filter((kind, k) => kind === b[k]).length / a.length;
})();
"""


def run(*words, exit_code=0):
    done = subprocess.run([str(word) for word in words], capture_output=True, text=True)
    assert done.returncode == exit_code, done.stderr
    return done.stdout


def unit(view):
    return [part / math.hypot(*view) for part in view]


def make_frames(folder):
    """Twelve: both objects, one that cannot be read, an empty one, and copies."""
    frames = folder / "frames"
    frames.mkdir()
    for name, view in VIEWS.items():
        run(ASPECTC, "render", f"{SCENES}/{name}.b", "--from=" + ",".join(map(str, view)), "-o",
            folder / f"{name}.png")
    for k, name in enumerate(["cube", "l_shape"] * 2):
        shutil.copy(folder / f"{name}.png", frames / f"{k}_{name}.png")
    (frames / "4_broken.png").write_text("no picture")
    shutil.copy(folder / "cube.png", frames / HOSTILE)
    (frames / "6_dark.ppm").write_bytes(b"P6 64 48 255\n" + bytes(64 * 48 * 3))
    for k in range(5):
        shutil.copy(folder / "l_shape.png", frames / f"7_copy_{k}.png")
    return frames


class ThePage(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        folder = Path(cls.folder.name)
        frames = make_frames(folder)
        indexes = [word for name in VIEWS for word in ("--index", f"{INDEXES}/{name}.aspect")]
        lines = run(REPLAY, *indexes, frames, exit_code=1).splitlines()
        cls.lines = {Path(line["frame"]).name: line for line in map(json.loads, lines)}
        cls.write_truth(folder / "truth.csv")
        run(REPLAY, *indexes, "--html", folder / "page", "--truth", folder / "truth.csv", frames,
            exit_code=1)
        cls.uris = {name: "data:image/png;base64," + base64.b64encode(
            (folder / f"{name}.png").read_bytes()).decode() for name in VIEWS}
        cls.file = folder / "page" / "index.html"
        cls.browser = Browser(500, 400)
        cls.page = cls.browser.__enter__()

    @classmethod
    def tearDownClass(cls):
        cls.browser.__exit__()
        cls.folder.cleanup()

    @classmethod
    def write_truth(cls, file):
        """From where each object is seen is known; 2_cube is said to be seen from its other side."""
        rows = ["file,object,vx,vy,vz,x,y,w,h,visible", "frames/6_dark.ppm,,,,,,,,,"]
        for name, line in cls.lines.items():
            if not line["objects"]:
                continue
            kind = "l_shape" if "l_shape" in name or "copy" in name else "cube"
            view = unit(VIEWS[kind] if name != "2_cube.png" else [-part for part in VIEWS[kind]])
            box = line["objects"][0]["box"]
            rows.append(",".join(map(str, [f"frames/{name}", kind, *view, *box, 1])))
        file.write_text("\n".join(rows) + "\n")

    def setUp(self):
        self.page.open("about:blank")
        self.page.open(self.file.as_uri())

    def tearDown(self):
        self.assertEqual(self.page.console(), [])
        self.assertEqual([url for url in self.page.requests()
                          if url not in (self.file.as_uri(), "about:blank")], [])

    def names(self):
        return self.page.run("return [...document.querySelectorAll('.card')]"
                             ".map(card => card.title.split('/').pop())")

    def chip(self, kind, value):
        self.page.run("document.querySelector(`#by-${arguments[0]} button[value=\"${arguments[1]}\"]`)"
                      ".click()", kind, value)

    def test_shows_every_frame_and_decodes_pictures_when_they_are_near(self):
        self.assertEqual(len(self.names()), 12)
        self.assertIn(HOSTILE, self.names())
        self.assertEqual(self.page.run("return document.getElementById('count').textContent"),
                         "12 frames · 1 unreadable")
        self.page.wait_for("const first = document.querySelector('.card img');"
                           "return first.complete && first.naturalWidth === 512")
        loaded = "return [...document.querySelectorAll('.card img')].filter(i => i.src).length"
        self.assertLess(self.page.run(loaded), 11)
        self.page.run("document.querySelector('.card:last-child').scrollIntoView()")
        self.page.wait_for("return document.querySelector('.card:last-child img').src")
        self.assertEqual(self.page.run("return document.querySelectorAll('.card .edges path').length"),
                         2 * 10)

    def test_filters_by_object_verdict_error_and_name_and_sorts(self):
        self.chip("object", "cube")
        self.assertEqual(self.names(), ["0_cube.png", "2_cube.png", HOSTILE])
        self.chip("error", "over 20°")
        self.assertEqual(self.names(), ["2_cube.png"])
        self.chip("error", "over 20°")
        self.chip("object", "cube")
        self.chip("verdict", "unreadable")
        self.assertEqual(self.names(), ["4_broken.png"])
        self.chip("verdict", "nothing")
        self.assertEqual(self.names(), ["4_broken.png", "6_dark.ppm"])
        self.chip("verdict", "nothing")
        self.chip("verdict", "unreadable")
        self.page.type("#search", "L_SHAPE")
        self.assertEqual(self.names(), ["1_l_shape.png", "3_l_shape.png"])
        self.page.type("#search", "zzz")
        self.assertEqual(self.names(), [])
        self.page.click("#all")
        self.page.run("const sort = document.getElementById('sort');"
                      "sort.value = 'largest error first'; sort.onchange();")
        self.assertEqual(self.names()[0], "2_cube.png")
        self.assertEqual(len(self.names()), 12)

    def test_tells_errors_against_the_truth(self):
        texts = self.page.run("return [...document.querySelectorAll('.card')].map(card =>"
                              "card.querySelector('.name').lastChild.textContent)")
        self.assertEqual(texts[4], "")
        self.assertLess(float(texts[1].rstrip("°")), 5)
        self.assertAlmostEqual(float(texts[2].rstrip("°")), 180, delta=5)

    def test_a_click_opens_why_and_keys_go_on(self):
        self.page.click(".card")
        self.page.wait_for("return document.getElementById('list').hidden")
        self.assertEqual(self.page.run("return document.getElementById('name').lastChild.textContent"),
                         "0_cube.png")
        line = self.lines["0_cube.png"]["objects"][0]
        cards = self.page.run("return [...document.querySelectorAll('.view.guess')]"
                              ".map(card => card.textContent)")
        self.assertEqual(len(cards), len(line["hypotheses"]))
        for card, hypothesis in zip(cards, line["hypotheses"]):
            self.assertIn(f'{hypothesis["object"]}class {hypothesis["class"]}score', card)
        # The frame's contours with their letters in the first class.
        labels = self.page.run("return [...document.querySelectorAll('#top text')]"
                               ".map(label => label.textContent)")
        self.assertEqual(sorted(labels), sorted(
            f"{number} {letter}" for number, letter in line["hypotheses"][0]["contours"]))
        words = self.page.run("return document.getElementById('explained').innerText.toLowerCase()")
        for word in ("matched, cube class", "missing", "contradicts", "why not another", "the true view"):
            self.assertIn(word, words)
        others = self.page.run("return [...document.querySelectorAll('.other b')].map(b => b.textContent)")
        self.assertEqual(others, ["l_shape"])
        self.page.press(RIGHT)
        self.page.wait_for("return document.getElementById('name').lastChild.textContent === '1_l_shape.png'")
        self.page.press(ESCAPE)
        self.page.wait_for("return !document.getElementById('list').hidden")
        self.assertEqual(self.page.run("return document.activeElement.title.split('/').pop()"),
                         "1_l_shape.png")
        self.page.press(RIGHT)
        self.assertEqual(self.page.run("return document.activeElement.title.split('/').pop()"),
                         "2_cube.png")

    def test_opens_what_cannot_be_read_and_what_shows_nothing(self):
        for name, word in (("4_broken.png", "not a picture"), ("6_dark.ppm", "nothing"),
                           (HOSTILE, "cube")):
            self.page.run("location.hash = arguments[0]", self.names().index(name))
            self.page.wait_for("return document.getElementById('name').lastChild?.textContent === "
                               + json.dumps(name))
            self.assertIn(word, self.page.run("return document.getElementById('explained').innerText"))

    def test_draws_models_as_a_ray_tracer_does(self):
        for name, view in VIEWS.items():
            other = "l_shape" if name == "cube" else "cube"
            traced = {"uri": self.uris[name], "view": json.dumps(view), "roll": 0}
            # The rest is edges, which are drawn dark.
            self.assertGreater(self.page.run(LIKENESS, name, traced), 0.9)
            self.assertLess(self.page.run(LIKENESS, other, traced), 0.6)
            self.assertGreater(self.page.run(LIKENESS, name, {**traced, "roll": math.pi / 2}), 0.9)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
