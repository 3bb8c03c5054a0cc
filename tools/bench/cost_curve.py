"""How the compiler's cost grows with the number of views: see cost_curve.sh, which builds first."""
import math
import os
import sys

from compile_run import (OUT, ROOT, block_head, compile_scene, markdown_table, put_on_top,
                         results_text)

HIGHEST = {"CUBE": 8, "BLOCKCYL2": 8, "TRUCK": 7}
LOWEST = 3
COLOURS = ["#c03028", "#2868b8", "#308048"]
BARS = "▁▂▃▄▅▆▇█"


def slope(points):
    """Of the straight line through the logarithms: the exponent of the cost."""
    x = [math.log(views) for views, _ in points]
    y = [math.log(cost) for _, cost in points]
    middle_x, middle_y = sum(x) / len(x), sum(y) / len(y)
    return (sum((a - middle_x) * (b - middle_y) for a, b in zip(x, y))
            / sum((a - middle_x) ** 2 for a in x))


def bars(values):
    return "".join(BARS[min(int(len(BARS) * value / max(values)), len(BARS) - 1)]
                   for value in values)


def svg(curves):
    """Views against processor seconds, both logarithmic, with the line of cost ~ views dotted."""
    left, top, side = 70, 20, 420
    decades_x, decades_y = (2, 6), (-1, 4)

    def place(views, cost):
        x = (math.log10(views) - decades_x[0]) / (decades_x[1] - decades_x[0])
        y = (math.log10(cost) - decades_y[0]) / (decades_y[1] - decades_y[0])
        return f"{left + side * x:.1f},{top + side * (1 - y):.1f}"

    parts = [f'<svg xmlns="http://www.w3.org/2000/svg" width="{left + side + 130}" '
             f'height="{top + side + 50}" font-family="sans-serif" font-size="13">'
             f'<rect width="100%" height="100%" fill="#fff"/>']
    low, high = 10.0 ** decades_y[0], 10.0 ** decades_y[1]
    for decade in range(decades_x[0], decades_x[1] + 1):
        x, y = place(10.0 ** decade, low).split(",")
        parts.append(f'<polyline points="{x},{y} {place(10.0 ** decade, high)}" stroke="#ddd"/>'
                     f'<text x="{x}" y="{float(y) + 18}" text-anchor="middle">{10 ** decade:,}'
                     '</text>')
    for decade in range(decades_y[0], decades_y[1] + 1):
        x, y = place(10.0 ** decades_x[0], 10.0 ** decade).split(",")
        parts.append(f'<polyline points="{x},{y} {place(10.0 ** decades_x[1], 10.0 ** decade)}" '
                     f'stroke="#ddd"/><text x="{float(x) - 6}" y="{y}" text-anchor="end">'
                     f'{10.0 ** decade:g}</text>')
    for (name, points), colour in zip(curves.items(), COLOURS):
        (first_views, first_cost), (last_views, last_cost) = points[0], points[-1]
        even = first_cost * last_views / first_views
        parts.append(f'<polyline points="{place(first_views, first_cost)} '
                     f'{place(last_views, even)}" stroke="{colour}" stroke-dasharray="2 4"/>'
                     f'<polyline points="{" ".join(place(*point) for point in points)}" '
                     f'fill="none" stroke="{colour}" stroke-width="2"/>')
        x, y = place(last_views, last_cost).split(",")
        parts.append(f'<text x="{float(x) + 6}" y="{y}" fill="{colour}">{name}</text>')
    parts.append(f'<text x="{left + side / 2}" y="{top + side + 42}" text-anchor="middle">views '
                 f'rendered</text><text x="{left}" y="14">processor seconds</text></svg>')
    return "\n".join(parts) + "\n"


def main(wanted):
    os.chdir(ROOT)
    highest = dict(item.split(":") for item in wanted) if wanted else HIGHEST
    if any(int(level) <= LOWEST for level in highest.values()):
        raise SystemExit(f"cost_curve: a curve begins at level {LOWEST}; name a higher one")
    rows, curves = [], {}
    block = block_head("Cost and number of views", " ".join(["tools/bench/cost_curve.sh", *wanted]))
    block += "\nWithout patches divided along borders (`--border-views 0`).\n"
    for name, last in highest.items():
        points, per_view_ms = [], []
        for level in range(LOWEST, int(last) + 1):
            print(f"{name} {level}", file=sys.stderr)
            run = compile_scene(name, level, "--border-views", "0")
            points.append((run["views_rendered"], run["cpu_s"]))
            per_view_ms.append(1000 * run["cpu_s"] / run["views_rendered"])
            rows.append([name, level, run["views_rendered"],
                         f"{run['wall_s']:.1f}", f"{run['cpu_s']:.1f}", f"{per_view_ms[-1]:.2f}",
                         f"{run['peak_mib']:.0f}"])
        curves[name] = points
        block += (f"\n- {name}: CPU time grows with the number of views to the power of "
                  f"{slope(points):.2f}, {slope(points[-2:]):.2f} over the last level; "
                  f"ms a view by level: {bars(per_view_ms)}")
    block += "\n\n" + markdown_table(
        ["object", "level", "views", "s", "CPU s", "CPU ms a view",
         "MiB at most"], rows)
    with open(f"{OUT}/cost_curve.svg", "w") as file:
        file.write(svg(curves))
    block += f"\nThe command draws the curve into `{OUT}/cost_curve.svg`.\n"
    print(block)
    put_on_top(block, results_text())


main(sys.argv[1:])
