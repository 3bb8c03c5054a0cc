"""The tests' browser sees what a page does: otherwise tests of pages could not fail."""
import os
import sys
import tempfile
import unittest
from pathlib import Path

from browser import Browser

PAGE = """<!doctype html><title>A page</title><link rel=icon href="data:,">
<style>body { margin: 0 } #box { width: 200px; height: 100px; background: rgb(255, 0, 0) }
@media (prefers-color-scheme: dark) { #box { background: rgb(0, 0, 255) } }</style>
<div id=box></div><input id=words><button id=button>count</button>
<script>
let clicks = 0, keys = "", path = [];
button.onclick = () => ++clicks;
onkeydown = event => keys += event.key;
const note = event => path.push([event.clientX, event.clientY]);
box.onpointerdown = event => { note(event); addEventListener("pointerup", note); };
</script>"""


class TheBrowser(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        cls.page_file = Path(cls.folder.name) / "page.html"
        cls.page_file.write_text(PAGE)
        cls.page = Browser(400, 300).__enter__()
        cls.page.open(cls.page_file.as_uri())

    @classmethod
    def tearDownClass(cls):
        cls.page.__exit__()
        cls.folder.cleanup()

    def test_clicks_types_presses_and_drags_as_a_person_does(self):
        self.page.click("#button")
        self.page.press("x")
        self.page.type("#words", "hello")
        self.page.drag("#box", 30, 20, start=(-10, 0))
        self.assertEqual(self.page.run("return clicks"), 1)
        self.assertEqual(self.page.run("return keys"), "xhello")
        self.assertEqual(self.page.run("return words.value"), "hello")
        self.assertEqual(self.page.run("return path"), [[90, 50], [120, 70]])

    def test_has_the_size_that_was_asked_for_and_takes_its_picture(self):
        self.assertEqual(self.page.run("return [innerWidth, innerHeight]"), [400, 300])
        picture = os.path.join(self.folder.name, "page.png")
        self.page.screenshot(picture)
        with open(picture, "rb") as file:
            header = file.read(24)
        self.assertEqual(header[:8], b"\x89PNG\r\n\x1a\n")
        self.assertEqual((int.from_bytes(header[16:20], "big"),
                          int.from_bytes(header[20:24], "big")), (400, 300))

    def test_waits_no_longer_than_it_is_told(self):
        self.assertEqual(self.page.wait_for("return 7"), 7)
        with self.assertRaises(AssertionError):
            self.page.wait_for("return false", seconds=0.1)

    def test_draws_with_webgl_and_in_the_scheme_that_is_asked_for(self):
        self.assertTrue(self.page.run(
            "return !!document.createElement('canvas').getContext('webgl')"))
        self.assertEqual(self.page.run("return getComputedStyle(box).backgroundColor"),
                         "rgb(255, 0, 0)")

    def test_tells_what_a_page_logs_and_asks_the_network_for(self):
        with Browser(dark=True) as page:
            page.open(self.page_file.as_uri())
            self.assertEqual(page.console(), [])
            self.assertEqual(page.requests(), [self.page_file.as_uri()])
            self.assertEqual(page.run("return getComputedStyle(box).backgroundColor"),
                             "rgb(0, 0, 255)")
            page.run("console.log('something'); setTimeout(() => nothing(), 0);"
                     "new Image().src = 'http://127.0.0.1:9/picture.png'")
            page.wait_for("return performance.getEntriesByType('resource').length")
            self.assertIn("something", "".join(page.console()))
            self.assertIn("nothing is not defined", "".join(page.console()))
            self.assertIn("http://127.0.0.1:9/picture.png", page.requests())


if __name__ == "__main__":
    sys.exit(unittest.main())
