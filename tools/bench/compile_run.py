"""One run of aspectc and what it cost, and blocks of figures at the top of RESULTS.md."""
import datetime
import json
import os
import subprocess
import time

ROOT = os.path.normpath(os.path.join(os.path.dirname(os.path.abspath(__file__)), "../.."))
OUT = "build/bench"
RESULTS = "tools/bench/RESULTS.md"


def scene_of(name):
    """The scene's file; the large mesh is made where it is missing."""
    if name != "LARGE_MESH":
        return f"compiler/models/{name.lower()}.b"
    path = f"{OUT}/large_mesh.ply"
    if not os.path.exists(path):
        subprocess.run(["tools/bench/large_mesh.py", path], check=True)
    return path


def compile_scene(name, level, *options, store=None):
    """The statistics of aspectc, with wall_s, cpu_s (all threads, user + system) and peak_mib."""
    stats = f"{OUT}/{name}.{level}.json"
    kept = ["--store", store] if store else ["--no-store"]
    command = ["build/release/bin/aspectc", scene_of(name), "--level", str(level), *kept,
               "-o", f"{OUT}/{name}.{level}.aspect", "--stats", stats, "--progress", "never",
               *options]
    start = time.monotonic()
    child = subprocess.Popen(command, stdout=subprocess.DEVNULL)
    _, status, usage = os.wait4(child.pid, 0)
    wall_s = time.monotonic() - start
    child.returncode = os.waitstatus_to_exitcode(status)
    if child.returncode != 0:
        raise SystemExit(f"failed: {' '.join(command)}")
    with open(stats) as file:
        run = json.load(file)
    run.update(wall_s=wall_s, cpu_s=usage.ru_utime + usage.ru_stime,
               peak_mib=usage.ru_maxrss / 1024)
    return run


def markdown_table(head, rows):
    """`head` holds the columns' names; numbers stand to the right."""
    lines = [head, ["---"] + ["---:"] * (len(head) - 1), *rows]
    return "\n".join("| " + " | ".join(str(cell) for cell in line) + " |" for line in lines) + "\n"


def block_head(title, command):
    commit = subprocess.run(["git", "describe", "--always", "--dirty"], capture_output=True,
                            text=True).stdout.strip()
    # Another program that computes at the same time shows here.
    load = os.getloadavg()[0]
    return (f"## {title}, {datetime.date.today()}\n`{command}`, {os.cpu_count()} cores, "
            f"load {load:.1f} at the start, commit {commit or 'unknown'}\n")


def results_text():
    with open(RESULTS) as file:
        return file.read()


def put_on_top(block, text):
    """Newest first: RESULTS.md becomes `text` with the block before its first one."""
    at = text.index("\n## ") + 1
    with open(RESULTS, "w") as file:
        file.write(text[:at] + block.rstrip("\n") + "\n\n" + text[at:])
