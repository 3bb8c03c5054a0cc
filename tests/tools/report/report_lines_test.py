"""aspect-report of lines that aspect-replay wrote: report_lines_test.py ASPECT-REPLAY ASPECT-REPORT
INDEX-FOLDER RENDERED-FOLDER."""
import shutil
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

from browser import Browser

REPLAY, REPORT, INDEXES, RENDERED = sys.argv[1], sys.argv[2], Path(sys.argv[3]), Path(sys.argv[4])
WORDS = [word for name in ("cube", "l_shape") for word in ("--index", str(INDEXES / f"{name}.aspect"))]


def run(*words, folder):
    return subprocess.run([str(word) for word in words], cwd=folder, capture_output=True, text=True)


class APageOfLines(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.temporary = tempfile.TemporaryDirectory()
        cls.folder = Path(cls.temporary.name)
        (cls.folder / "frames").mkdir()
        for name in ("000.png", "001.png", "002.png"):
            shutil.copy(RENDERED / "frames" / name, cls.folder / "frames" / name)
        made = run(REPLAY, *WORDS, "--explain", "frames", folder=cls.folder)
        assert made.returncode == 0, made.stderr
        cls.lines = made.stdout
        (cls.folder / "seen.ndjson").write_text(cls.lines)
        (cls.folder / "frames" / "001.png").unlink()
        cls.made = run(REPORT, "seen.ndjson", *WORDS, "--truth", RENDERED / "truth.csv", folder=cls.folder)
        cls.file = cls.folder / "seen.html"

    @classmethod
    def tearDownClass(cls):
        cls.temporary.cleanup()

    def test_has_every_frame_and_says_whose_picture_is_gone(self):
        self.assertEqual(self.made.returncode, 0, self.made.stderr)
        self.assertIn("1 of 3 frames are without their picture", self.made.stderr)
        with Browser(1000, 800) as page:
            page.open(self.file.as_uri())
            self.assertEqual(page.run("return document.querySelectorAll('.card').length"), 3)
            self.assertEqual(page.run("return document.querySelectorAll('.card .edges path').length"), 4)
            gone = page.run("return [...document.querySelectorAll('.card')].map("
                            "card => card.querySelector('.gone')?.textContent)")
            self.assertEqual(gone, [None, "the picture is no longer there", None])
            page.run("document.querySelector('#by-object button[value=cube]').click()")
            page.click(".card")
            page.wait_for("return document.getElementById('list').hidden")
            words = page.run("return document.getElementById('explained').innerText.toLowerCase()")
            for part in ("matched, cube class", "missing", "contradicts", "the true view", "recognised in"):
                self.assertIn(part, words)
            self.assertNotIn("contours as segmented", words)
            self.assertEqual(page.console(), [])
            self.assertEqual(page.requests(), [self.file.as_uri()])

    def refused(self, name, *words):
        done = run(REPORT, name, "-o", "refused.html", *words, folder=self.folder)
        self.assertEqual((done.returncode, done.stdout), (1, ""))
        self.assertEqual(len(done.stderr.splitlines()), 1)
        self.assertFalse((self.folder / "refused.html").exists())
        return done.stderr

    def test_of_what_is_none_is_refused_in_one_line(self):
        first = self.lines.splitlines()[0]
        (self.folder / "cut.ndjson").write_text(first + "\n" + first[:300])
        (self.folder / "odd.jsonl").write_bytes(b'\xff\xfe{"frame": "\x1b[31m"\n')
        (self.folder / "empty.ndjson").write_text("")
        self.assertIn("cut.ndjson:2: not a line of aspect-replay", self.refused("cut.ndjson"))
        self.assertIn("odd.jsonl:1: not a line of aspect-replay", self.refused("odd.jsonl"))
        self.assertIn("empty.ndjson: holds no lines", self.refused("empty.ndjson"))
        self.assertIn("none.aspect: ", self.refused("seen.ndjson", "--index", "none.aspect"))
        self.assertIn("none.csv: no such file", self.refused("seen.ndjson", "--truth", "none.csv"))


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
