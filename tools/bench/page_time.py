#!/usr/bin/env python3
"""How long pages of aspect-report take to be of use: page_time.py PAGE.html...

Each is opened five times in a new headless Chromium that draws with SwiftShader. Prints the bytes
and the least and the median time from navigation to the first picture of object and sphere."""
import statistics
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parents[2] / "tests/browser"))
from browser import Browser  # noqa: E402

READY = "return Number(document.documentElement.dataset.readyMs) || 0"


def time_s(page_file):
    with Browser(1280, 900) as page:
        page.open(page_file.resolve().as_uri())
        return page.wait_for(READY, seconds=60) / 1000


for name in sys.argv[1:]:
    times = [time_s(Path(name)) for _ in range(5)]
    print(f"{name}: {Path(name).stat().st_size:,} bytes, least {min(times):.2f} s, "
          f"median {statistics.median(times):.2f} s")
