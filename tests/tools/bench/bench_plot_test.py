"""aspect-bench --plot, from results that are known: what is drawn is as large as what was measured.
usage: bench_plot_test.py ASPECT_BENCH READ_SVG"""
import json
import os
import subprocess
import sys
import tempfile

BENCH, READ_SVG = sys.argv[1:]
STAGES = {"1_render_us": 100.0, "2_convert_us": 50.0, "4_segment_us": 250.0}


def run(name, time, unit="us", **more):
    return {"name": name, "run_name": name, "run_type": "iteration", "cpu_time": time,
            "real_time": 2 * time, "time_unit": unit, **more}


RUNS = [run("observe/cube", 420, **STAGES), run("match/cube", 100), run("store/cube", 20.0),
        run("compile_to_level/cube/level:1/process_time", 1.0, "s"),
        run("compile_to_level/cube/level:2/process_time", 10.0, "s"),
        run("frame_to_graph", 1.5, "ms"), run("frame_to_graph", 2.5, "ms"),
        run("frame_to_graph", 2.0, "ms"),
        {**run("frame_to_graph", 9.0, "ms"), "run_type": "aggregate", "aggregate_name": "stddev"},
        {**run("broken", 0), "error_occurred": True}]


def plot(folder, text, out="plot.svg"):
    with open(os.path.join(folder, "results.json"), "wb") as file:
        file.write(text if isinstance(text, bytes) else text.encode())
    return subprocess.run([BENCH, "--plot", out, "--from", "results.json"], cwd=folder,
                          capture_output=True, text=True)


def drawn(folder):
    return json.loads(subprocess.run([sys.executable, READ_SVG, "plot.svg"], cwd=folder, check=True,
                                     capture_output=True).stdout)


def check_plot(folder):
    done = plot(folder, json.dumps({"benchmarks": RUNS}))
    assert (done.returncode, done.stdout, done.stderr) == (0, "", ""), done
    svg = drawn(folder)
    assert not svg["outside"], svg["outside"]
    # Render, convert, segment, match, store: as wide as their times, beside each other.
    bars = [bar["box"] for bar in svg["bars"] if bar["box"][3] == 22]
    assert len(bars) == 5, bars
    px_a_us = (bars[4][0] - bars[0][0]) / 500
    for bar, before in zip(bars, (0, 100, 150, 400, 500)):
        assert abs(bar[0] - bars[0][0] - px_a_us * before) < 0.2, bars
    # Two levels, a decade apart: the line climbs by half of the panel of two decades.
    (curve,) = svg["curves"]
    (x1, y1), (x2, y2) = curve["points"]
    assert x2 > x1 and abs((y1 - y2) - 150) < 0.2, curve
    for word in ("520 µs", "2 ms", "processor time, s", "frame_to_graph", "cube", "segment"):
        assert word in svg["texts"], (word, svg["texts"])
    assert "broken" not in svg["texts"]


def check_hostile(folder):
    deep = "[" * 100_000
    for text in ("", "{", deep, "[]", "null", '{"benchmarks": 3}', '{"benchmarks": []}',
                 b"\xff\xfe\x00", '{"benchmarks": [{"name": 3, "cpu_time": 1}]}',
                 '{"benchmarks": [{"name": "a", "cpu_time": "b"}]}',
                 '{"benchmarks": [{"name": "a", "cpu_time": 1e999}]}',
                 '{"benchmarks": [{"name": "compile_to_level/a/level:99999999999", "cpu_time": 0}]}'):
        done = plot(folder, text, "none.svg")
        assert done.returncode == 1 and done.stdout == "", (text[:40], done)
        assert done.stderr.startswith("aspect-bench: ") and done.stderr.count("\n") == 1, done
        assert not os.path.exists(os.path.join(folder, "none.svg"))
    strange = [run("a<b>&\x01/" + "ä" * 300, 1), run("compile_to_level/x/level:0", 1e-9),
               run("observe/x", 1, **{"1_a_us": -5.0, "2_b_us": 1e300})]
    assert plot(folder, json.dumps({"benchmarks": strange})).returncode == 0
    drawn(folder)
    done = plot(folder, json.dumps({"benchmarks": RUNS}), "none/plot.svg")
    assert done.returncode == 1 and "none/plot.svg: cannot be written" in done.stderr, done
    done = subprocess.run([BENCH, "--from", "results.json"], cwd=folder, capture_output=True)
    assert done.returncode == 2, done


def check_measured(folder):
    done = subprocess.run([BENCH, "--benchmark_filter=read_every_byte", "--benchmark_min_time=0.01",
                           "--plot", "plot.svg"], cwd=folder, capture_output=True, text=True)
    assert done.returncode == 0 and "read_every_byte" in done.stdout, done
    assert "read_every_byte" in drawn(folder)["texts"]


for check in (check_plot, check_hostile, check_measured):
    with tempfile.TemporaryDirectory() as folder:
        check(folder)
print("3 checks passed")
