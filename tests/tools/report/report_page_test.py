"""aspect-report as its users start it: report_page_test.py ASPECTC ASPECT_REPORT CUBE.b

The page of a small model in a browser, its figures, and files that are no good."""
import os
import re
import subprocess
import sys
import tempfile
import unittest
import xml.dom.minidom
from pathlib import Path

from browser import Browser

ASPECTC, REPORT, CUBE = sys.argv[1:4]
ADDRESSES = re.compile(r"\bhttps?://(?!www\.w3\.org/2000/svg)")


def run(*words, folder):
    return subprocess.run([str(word) for word in words], cwd=folder, capture_output=True, text=True, timeout=100)


class AReport(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.temporary = tempfile.TemporaryDirectory()
        cls.folder = Path(cls.temporary.name)
        made = run(ASPECTC, CUBE, "-o", "cube.aspect", "--level", 2, "--min-level", 2, "--border-views", 0, "--max-index-kib", 12,
                   folder=cls.folder)
        assert made.returncode == 0, made.stderr
        made = run(REPORT, "cube.store", "-o", "report.html", "--figures", "figures", "--views", 20,
                   "--cure-level", 1, folder=cls.folder)
        assert made.returncode == 0, made.stderr
        assert made.stdout + made.stderr == "", made
        cls.html = (cls.folder / "report.html").read_text()
        cls.page = Browser(1280, 900).__enter__()
        cls.page.open((cls.folder / "report.html").as_uri())
        cls.page.wait_for("return document.documentElement.dataset.readyMs")

    @classmethod
    def tearDownClass(cls):
        cls.page.__exit__()
        cls.temporary.cleanup()

    def text(self, css):
        return self.page.run("return document.querySelector(arguments[0]).textContent", css)

    def count(self, css):
        return self.page.run("return document.querySelectorAll(arguments[0]).length", css)

    def test_has_all_its_parts(self):
        self.assertEqual(self.text("h1"), "cube")
        self.assertEqual(self.count("#halves > svg"), 6)
        self.assertEqual(self.page.run("return new Set([...document.querySelectorAll('#halves .aspect')]"
                                       ".map(path => path.dataset.aspect)).size"), self.page.run("return aspects.length"))
        self.assertEqual(self.count("#aspects button"), self.page.run("return aspects.length"))
        self.assertEqual(self.count(".tables table"), 2)
        self.assertIn("96.3 %", self.text(".tables"))  # the thesis's at level 7
        for heading in ("Coverage by level", "Accuracy to expect", "Confusions", "Blind spots", "Cures",
                        "Symmetries", "Index and its budget", "Compilation"):
            self.assertIn(heading, self.page.run(
                "return [...document.querySelectorAll('h2')].map(h => h.textContent).join('|')"))

    def test_shows_the_views_of_an_aspect_that_is_clicked_on_a_projection_and_in_the_list(self):
        self.page.click('#aspects [data-aspect="3"]')
        self.assertIn("Aspect 3 of", self.text("#aspect_title"))
        self.assertGreaterEqual(self.count("#views image"), 1)
        self.assertGreaterEqual(self.count("#views .contour"), 1)
        self.assertEqual(self.count("#graph .node"), self.count("#contours tr") - 1)
        self.assertEqual(self.count("#halves .picked[data-aspect='3']"), self.count("#halves [data-aspect='3']"))
        other = self.page.run("const p = document.querySelector('#halves .aspect:not([data-aspect=\"3\"])');"
                              "p.dispatchEvent(new MouseEvent('click', {bubbles: true})); return p.dataset.aspect")
        self.assertIn(f"Aspect {other} of", self.text("#aspect_title"))

    def test_turns_the_object_and_the_sphere_together_and_takes_clicks_on_the_sphere(self):
        before = self.text("#looking")
        self.page.drag("#object", 60, 25)
        self.page.wait_for(f"return document.getElementById('looking').textContent !== {before!r}")
        seen = self.page.run("return document.getElementById('looking').textContent")
        # The middle of the sphere is what is looked at.
        if "aspect " in seen and "no aspect" not in seen:
            self.page.click("#sphere")
            number = re.search(r"aspect (\d+)", seen).group(1)
            self.page.wait_for(f"return document.getElementById('aspect_title').textContent.startsWith('Aspect {number} ')")
        before = self.page.run("return turn.flat()")
        self.page.drag("#sphere", -40, 60)
        self.assertNotEqual(before, self.page.run("return turn.flat()"))

    def test_shows_every_tried_view_once(self):
        self.assertEqual(self.page.run("return [...document.querySelectorAll('.cell[data-views]')]"
                                       ".reduce((sum, cell) => sum + Number(cell.dataset.views), 0)"), 20)
        # Of a direction on the rim two halves show it; 20 random ones are on none.
        self.assertEqual(self.count("#halves .tried circle"), 3 * 20)

    def test_looks_from_where_a_spot_is_and_turns_back(self):
        self.page.run("lookFrom([0, 0, 1])")
        self.page.wait_for("return turn[2][2] > 0.9999")
        self.page.click("#home")
        self.page.wait_for("return turn === home")

    def test_says_nothing_on_the_console_and_asks_nobody_for_anything(self):
        self.assertEqual(self.page.console(), [])
        self.assertEqual(self.page.requests(), [(self.folder / "report.html").as_uri()])
        self.assertIsNone(ADDRESSES.search(self.html))

    def test_says_so_where_there_is_no_webgl(self):
        without = self.folder / "without.html"
        without.write_text(self.html.replace("<script>", "<script>HTMLCanvasElement.prototype.getContext = () => null;", 1))
        self.page.open(without.as_uri())
        self.assertFalse(self.page.run("return document.getElementById('no_webgl').hidden"))
        self.page.click('#aspects [data-aspect="2"]')
        self.assertIn("Aspect 2 of", self.text("#aspect_title"))
        self.assertEqual([line for line in self.page.console() if "SEVERE" in line], [])
        self.page.open((self.folder / "report.html").as_uri())

    def test_writes_figures_that_are_xml(self):
        names = {file.name for file in (self.folder / "figures").iterdir()}
        for name in ("object", "sphere", "sphere_patches", "sphere_tried_views", "coverage", "areas", "confusions",
                     "aspect_000"):
            self.assertIn(name + ".svg", names)
        for file in (self.folder / "figures").iterdir():
            root = xml.dom.minidom.parse(str(file)).documentElement
            self.assertEqual(root.tagName, "svg")
            self.assertEqual(root.getAttribute("xmlns"), "http://www.w3.org/2000/svg")

    def test_is_the_same_each_time(self):
        made = run(REPORT, "cube.store", "-o", "again.html", "--views", 20, "--cure-level", 1, "--jobs", 1,
                   folder=self.folder)
        self.assertEqual(made.returncode, 0, made.stderr)
        self.assertEqual((self.folder / "again.html").read_text(), self.html)

    def refused(self, *words, code=1):
        left = set(os.listdir(self.folder))
        ended = run(REPORT, *words, folder=self.folder)
        self.assertEqual(ended.returncode, code)
        self.assertEqual(ended.stdout, "")
        self.assertEqual(ended.stderr.count("\n"), 1, ended.stderr)
        self.assertTrue(ended.stderr.startswith("aspect-report: "), ended.stderr)
        self.assertEqual(set(os.listdir(self.folder)), left)
        return ended.stderr

    def test_refuses_what_is_no_good_in_one_line(self):
        store = (self.folder / "cube.store").read_bytes()
        damaged = bytearray(store)
        damaged[len(store) // 2:len(store) // 2 + 8192] = os.urandom(8192)
        (self.folder / "damaged.store").write_bytes(damaged)
        (self.folder / "cut.store").write_bytes(store[:len(store) // 3])
        # SQLite's user_version, which is the store's: bytes 60 to 63 of the file.
        (self.folder / "old.store").write_bytes(store[:60] + (1).to_bytes(4, "big") + store[64:])
        (self.folder / "text.store").write_text("not a store\n" * 1000)
        (self.folder / "notes.txt").write_text("hello\n")
        for name in ("damaged", "cut", "text"):
            self.assertIn(name + ".store", self.refused(name + ".store"))
        self.assertIn("another version", self.refused("old.store"))
        self.assertIn("no store", self.refused("notes.txt"))
        self.assertIn("is not there", self.refused("missing.store"))
        self.assertIn("nowhere", self.refused("cube.store", "-o", "nowhere/report.html"))
        self.assertIn("notes.txt", self.refused("cube.store", "-o", "x.html", "--figures", "notes.txt"))
        self.assertIn("--views", self.refused("cube.store", "--views", "none", code=2))


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
