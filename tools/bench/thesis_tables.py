"""The thesis's tables 4.1 to 4.12 again: see thesis_tables.sh, which builds first."""
import csv
import os
import sys

from compile_run import (OUT, ROOT, block_head, compile_scene, markdown_table, put_on_top,
                         results_text)

THESIS = os.environ.get("ASPECT_SHARED", "../shared") + "/thesis"
ALL = ["CUBE:7", "DUMBBELL:6", "L_SHAPE:6", "BLOCKCYL1:6", "BLOCKCYL2:6", "BLOCKCYL3:6",
       "PEGBLOCK:6", "HOLEBLOCK:6", "TRUCK:6", "TRUCK:7", "LARGE_MESH:5"]
# The thesis clusters the truck by a higher threshold and discards none of its clusters.
OPTIONS = {"TRUCK": ["--cluster-threshold", "300000", "--small-cluster-fraction", "0"]}
SUBDIVISION_THRESHOLD = 10000
STAGES = ["render", "features", "match", "cluster", "symmetry", "types", "emit"]


def thesis_rows(name):
    path = f"{THESIS}/{name}"
    if not os.path.exists(path):
        return []
    with open(path, newline="") as file:
        return list(csv.DictReader(file))


class ThesisTables:
    """Every row is None where the thesis has none."""

    def __init__(self):
        self.statistics = thesis_rows("model_statistics.csv")
        self.times = thesis_rows("model_generation_time.csv")
        self.is_there = bool(self.statistics and self.times)

    def model(self, name, level):
        """By the threshold of our default; with the higher one for clusters where there is one."""
        rows = [row for row in self.statistics
                if row["object"] == name and int(row["level"]) == level
                and int(row["subdivision_threshold"]) == SUBDIVISION_THRESHOLD]
        return max(rows, key=lambda row: int(row["clustering_threshold"]), default=None)

    def seconds(self, name, level):
        """Of this level alone where it was built on the one before, and of all levels together."""
        total = 0
        for row in sorted((row for row in self.times if row["object"] == name),
                          key=lambda row: int(row["level"])):
            own = int(row["seconds"])
            total = own + (total if row["incremental_from_previous_level"] == "yes" else 0)
            if int(row["level"]) == level:
                return own, total
        return None


def runs_of(name, level):
    """Without division along borders, as the thesis; by default; and that with a store."""
    print(f"{name} {level}", file=sys.stderr)
    options = OPTIONS.get(name, [])
    store = f"{OUT}/{name}.{level}.store"
    if os.path.exists(store):
        os.remove(store)
    plain = compile_scene(name, level, "--border-views", "0", *options)
    divided = compile_scene(name, level, *options)
    stored = compile_scene(name, level, *options, store=store)
    stored["store_mib"] = os.path.getsize(store) / 2**20
    os.remove(store)
    return plain, divided, stored


def thesis_row(name, level, ours, tables):
    model, seconds = tables.model(name, level), tables.seconds(name, level)
    area, clusters, views, calls = ("", "", "", "") if model is None else (
        f"{float(model['area_fraction']):.3f}", model["clusters"], model["views"],
        model["match_calls"])
    time = factor = ""
    if seconds is not None:
        own, total = seconds
        time = f"{total:,}" if own == total else f"{total:,} ({own:,} for the last level)"
        factor = f"{total / ours['wall_s']:,.0f}"
    return [name, level, area, f"{ours['area_fraction']:.3f}", clusters, ours["clusters"],
            views, ours["views"], calls, ours["match_calls"], ours["matches_gave_up"], time,
            f"{ours['wall_s']:.1f}", f"{ours['cpu_s']:.1f}", factor, f"{ours['peak_mib']:.0f}"]


THESIS_HEAD = ["object", "level", "area: thesis", "ours", "clusters: thesis", "ours",
               "views: thesis", "ours", "match calls: thesis", "ours", "gave up", "s: thesis",
               "ours", "CPU s", "times faster", "MiB at most"]


def divided_row(name, level, run, stored):
    return [name, level, f"{run['area_fraction']:.3f}", f"{run['area_assigned']:.3f}",
            run["clusters"], run["clusters_in_index"], run["views"], run["border_views"],
            run["matches_gave_up"], f"{run['wall_s']:.1f}", f"{run['cpu_s']:.1f}",
            f"{run['peak_mib']:.0f}", f"{run['index_bytes'] / 1024:.1f}",
            f"{stored['cpu_s'] - run['cpu_s']:+.1f}", f"{stored['wall_s']:.1f}",
            f"{stored['peak_mib']:.0f}", f"{stored['store_mib']:.0f}"]


DIVIDED_HEAD = ["object", "level", "uniform area", "assigned area", "clusters", "in the index",
                "views", "border views", "gave up", "s", "CPU s", "MiB at most", "index KiB",
                "store: CPU s", "s with it", "MiB at most", "file MiB"]


STAGES_HEAD = ["object", "level", "views rendered", *STAGES]


def stage_row(name, level, run):
    return [name, level, run["views_rendered"],
            *(f"{run['seconds'][stage]:.2f}" for stage in STAGES)]


def block_of(head, by_thesis, divided, stages):
    return (f"{head}\nAs the thesis does it, without patches divided along borders"
            f" (`--border-views 0`):\n\n{markdown_table(THESIS_HEAD, by_thesis)}"
            "\nBy default, with them; and what a store adds:\n\n"
            f"{markdown_table(DIVIDED_HEAD, divided)}"
            "\nSeconds of these by stage; of render, features and match summed over threads:\n\n"
            f"{markdown_table(STAGES_HEAD, stages)}")


def main(wanted):
    os.chdir(ROOT)
    tables, text = ThesisTables(), results_text()
    head = block_head("The thesis's tables", " ".join(["tools/bench/thesis_tables.sh", *wanted]))
    if not tables.is_there:
        head += "\nThe thesis's columns are empty: ../shared/thesis is not here.\n"
    by_thesis, divided, stages = [], [], []
    for item in wanted or ALL:
        name, level = item.split(":")
        plain, whole, stored = runs_of(name, int(level))
        by_thesis.append(thesis_row(name, int(level), plain, tables))
        divided.append(divided_row(name, int(level), whole, stored))
        stages.append(stage_row(name, int(level), whole))
        # After every object, so that a run that is stopped leaves what it has.
        block = block_of(head, by_thesis, divided, stages)
        put_on_top(block, text)
    print(block)


main(sys.argv[1:])
