#!/usr/bin/env python3
"""What the page costs aspectd, and how soon a slider's effect is seen: page_cost.py CLIP_DAEMON
FOLDER CLIP INDEX... [--rate 15] [--seconds 20]

aspectd on one core with a clip for a camera (tests/runtime/workbench/clip_daemon.cpp) and Chromium
on another, first without a page that looks, then with one, then with one whose slider moves five
times a second and beside it a reader that takes nothing of what it asks for. Prints frames that
were late or lost, and from the slider's event to the regions drawn: median and largest. As root
both are put before all else that runs."""
import argparse
import contextlib
import json
import os
import pathlib
import re
import socket
import subprocess
import sys
import time
import urllib.request

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "tests/browser"))
import browser  # noqa: E402

# Without a graphics card: the tests' browser draws as if it had one, which takes seconds.
browser.ARGUMENTS[:] = [each for each in browser.ARGUMENTS if "swiftshader" not in each]
browser.ARGUMENTS.append("--disable-gpu")

MOVE = """return new Promise(done => {
  const slider = document.getElementById("chroma_step_slider");
  const regions = document.getElementById("regions"), before = Number(regions.dataset.settings);
  slider.value = arguments[0];
  const started = performance.now();
  slider.dispatchEvent(new Event("input"));
  const look = () => Number(regions.dataset.settings) > before
    ? done(performance.now() - started) : requestAnimationFrame(look);
  look();
});"""


def put_in_front(process, core):
    """All its threads and children on one core: those that write for aspectd take every core, and
    Chromium gives some of its processes priorities of its own."""
    mine, parents = {process.pid}, {}
    for status in pathlib.Path("/proc").glob("[0-9]*/stat"):
        with contextlib.suppress(OSError):
            fields = status.read_text().rpartition(")")[2].split()
            parents[int(status.parent.name)] = int(fields[1])
    while added := {child for child, parent in parents.items() if parent in mine} - mine:
        mine |= added
    for number in mine:
        for thread in pathlib.Path(f"/proc/{number}/task").glob("*"):
            with contextlib.suppress(OSError):
                os.sched_setaffinity(int(thread.name), {core})
                if os.geteuid() == 0:
                    os.setpriority(os.PRIO_PROCESS, int(thread.name), -20)


def frames(lines):
    seen = [json.loads(line) for line in lines.read_text().splitlines()]
    return [line for line in seen if "capture" in line]


def told(name, lines, start):
    now = frames(lines)[start:]
    late = sum(frame["capture"]["late"] for frame in now)
    lost = sum(frame["capture"]["lost"] for frame in now)
    elapsed = sorted(frame["elapsed_ms"] for frame in now)
    print(f"{name}: {len(now)} frames, {late} late, {lost} lost; recognised in "
          f"{elapsed[len(elapsed) // 2]:.1f} ms median, {elapsed[-1]:.1f} ms at most", flush=True)


def stuck_reader(url):
    host, port = re.search(r"http://([^:/]+):(\d+)/", url).groups()
    reader = socket.create_connection((host, int(port)))
    reader.setsockopt(socket.SOL_SOCKET, socket.SO_RCVBUF, 1024)
    reader.sendall(f"GET /view HTTP/1.1\r\nHost: {host}:{port}\r\n\r\n".encode())
    return reader


def settings_of(view):
    length = int.from_bytes(view[:4], "little")
    return json.loads(view[4:4 + length])["settings"]


def time_without_browser(url):
    """From a changed value sent to the view that has it received, in ms."""
    site, token = url.split("#token=")
    took = []
    for k in range(40):
        body = json.dumps({"chroma_step": 3 + 5 * k % 40}).encode()
        started = time.monotonic()
        request = urllib.request.Request(site + "act/settings", body, headers={
            "Content-Type": "application/json", "Aspect-Token": token})
        with urllib.request.urlopen(request) as answer:
            wanted = json.load(answer)["settings"]
        while True:
            with urllib.request.urlopen(site + "view") as answer:
                if settings_of(answer.read()) >= wanted:
                    break
        took.append(1000 * (time.monotonic() - started))
        time.sleep(0.1)
    took.sort()
    return took


def measure(url, lines, seconds):
    start = len(frames(lines))
    time.sleep(seconds)
    told("no page", lines, start)
    took = time_without_browser(url)
    print(f"without a browser a changed value is seen within {took[len(took) // 2]:.0f} ms median, "
          f"{took[-1]:.0f} ms at most")
    with browser.Browser(1400, 900) as page:
        page.open(url)
        page.wait_for("return document.getElementById('regions').dataset.settings && "
                      "document.getElementById('chroma_step_slider')", seconds=20)
        put_in_front(page._driver, 1)
        time.sleep(1)
        start = len(frames(lines))
        time.sleep(seconds)
        told("a page", lines, start)
        start, took = len(frames(lines)), []
        end = time.monotonic() + seconds
        readers = []
        while time.monotonic() < end:
            if len(took) % 10 == 0:
                readers = [stuck_reader(url)]
            took.append(page.run(MOVE, 3 + 5 * len(took) % 40))
            time.sleep(0.2)
        told("a slider that moves and a reader that is stuck", lines, start)
        took.sort()
        print(f"a slider's effect is seen within {took[len(took) // 2]:.0f} ms median, "
              f"{took[len(took) * 9 // 10]:.0f} ms of nine in ten, {took[-1]:.0f} ms at most "
              f"({len(took)} moves)")
        print("console:", page.console(), "elsewhere:",
              [seen for seen in page.requests() if not seen.startswith(url.split("#")[0])])


def main():
    arguments = argparse.ArgumentParser(description=__doc__.split("\n\n")[0])
    arguments.add_argument("program", type=pathlib.Path)
    arguments.add_argument("folder", type=pathlib.Path)
    arguments.add_argument("clip", type=pathlib.Path)
    arguments.add_argument("indexes", nargs="+", type=pathlib.Path)
    arguments.add_argument("--rate", type=float, default=15)
    arguments.add_argument("--seconds", type=float, default=20)
    given = arguments.parse_args()
    given.folder.mkdir(parents=True, exist_ok=True)
    configuration, lines = given.folder / "aspectd.toml", given.folder / "lines"
    indexes = ", ".join(json.dumps(str(index.resolve())) for index in given.indexes)
    configuration.write_text(f"indexes = [{indexes}]\n[camera]\nrate = {given.rate}\n"
                             "[recognition]\ntime_limit_ms = 30\n[output]\nstdout = true\n[output.http]\nport = 8097\n"
                             + ("[process]\nrealtime_priority = 20\ncpus = [0]\n"
                                if os.geteuid() == 0 else ""))
    with open(lines, "w") as out:
        program = subprocess.Popen([given.program, configuration, given.clip], stdout=out,
                                   stderr=subprocess.PIPE, text=True)
    try:
        found, line = None, "the program says nothing"
        for line in program.stderr:
            if found := re.search(r"http\S+", line):
                break
        if not found:
            sys.exit(line.strip())
        time.sleep(2)
        put_in_front(program, 0)
        measure(found.group(0), lines, given.seconds)
    finally:
        program.terminate()
        program.stderr.read()
        program.wait()


if __name__ == "__main__":
    main()
