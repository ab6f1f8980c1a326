"""Speed against error: what a sample costs, over how wrong and how noisy it is."""

import matplotlib.pyplot as plt

from report.data import rows_by
from report.page import COLOURS, Section, figure

SETS = ("case 1", "case 2", "case 3", "mix")
ONE, MANY = "prepare + 1 sample", "prepare + 16 samples"
# (lane, task), as in the JSON: mark and name.
WAYS = {
    ("f32", ONE): ("o", "scalar, 1 sample per preparation"),
    ("f32", MANY): ("s", "scalar, 16 samples per preparation"),
    ("AVX2", ONE): ("^", "AVX2 packets, 1 sample"),
    ("AVX-512", ONE): ("D", "AVX-512 packets, 1 sample"),
}
# Labels in nanoseconds, and factors that leave room beside the points.
TICKS = (1, 2, 5, 10, 20, 50, 100, 200, 500, 1000)
MARGINS = (0.8, 1.25)
METHODS = ("solid_angle", "published", "published, cube root", "projected_bounded", "projected")
# The library's cube root is right to 3e-7: the method's errors are its formulas'.
SAME_ERRORS = {"published, cube root": "published"}


def points(bench: dict, errors: list[dict], column: str, name: str) -> list[tuple]:
    """Return (method, way, nanoseconds, error) for all of a set of caps that was both timed and measured."""
    times = rows_by(bench["rows"], "set", "lane", "method", "task")
    found = rows_by(errors, "set", "method")
    return [
        (
            method,
            way,
            times[name, way[0], method, way[1]]["nanoseconds"],
            found[name, SAME_ERRORS.get(method, method)][column],
        )
        for method in METHODS
        for way in WAYS
        if (name, way[0], method, way[1]) in times
    ]


def front(marks: list[tuple]) -> list[tuple]:
    """Return the points that no other beats in both time and error, by time."""
    best, kept = float("inf"), []
    for mark in sorted(marks, key=lambda mark: mark[2:]):
        if mark[3] < best:
            best = mark[3]
            kept.append(mark)
    return kept


def draw(bench: dict, errors: list[dict], column: str, label: str) -> plt.Figure:
    """Draw a panel for each set of caps."""
    drawing, axes = plt.subplots(1, len(SETS), figsize=(13, 4.4), sharey=True, layout="constrained")
    for place, name in zip(axes, SETS, strict=True):
        marks = points(bench, errors, column, name)
        for method, way, time, error in marks:
            place.loglog(time, error, WAYS[way][0], color=COLOURS[method], markersize=7, alpha=0.85)
        # Of scalars; nothing is to the lower left of this line.
        line = front([mark for mark in marks if mark[1][0] == "f32"])
        place.step([m[2] for m in line], [m[3] for m in line], "k:", where="post", linewidth=1)
        place.set_title(name if name != "mix" else "mix of a scene (53 : 24 : 23)", fontsize=10)
        place.set_xlabel("nanoseconds per sample")
        place.set_xticks(TICKS, [str(x) for x in TICKS])
        place.minorticks_off()
        times = [mark[2] for mark in marks]
        place.set_xlim(MARGINS[0] * min(times), MARGINS[1] * max(times))
        place.grid(visible=True, which="major", alpha=0.3)
    axes[0].set_ylabel(label)
    for method in METHODS:
        drawing.axes[0].plot([], [], "o", color=COLOURS[method], label=method)
    for mark, name in WAYS.values():
        drawing.axes[0].plot([], [], mark, color="gray", label=name)
    drawing.legend(loc="outside lower center", ncols=4, fontsize=9, frameon=False)
    return drawing


def on_front(bench: dict, errors: list[dict], column: str) -> str:
    """Say which methods are on the front of scalars, set by set."""
    parts = []
    for name in SETS:
        marks = [mark for mark in points(bench, errors, column, name) if mark[1] == ("f32", ONE)]
        parts.append(f"{name}: {', '.join(mark[0] for mark in front(marks))}")
    return "On the front of scalars with one sample per preparation, fastest first: " + "; ".join(parts)


def section(bench: dict, maps: dict) -> Section:
    """Return both figures."""
    mix = rows_by(maps["inverse"], "set", "method")
    times = rows_by(bench["rows"], "set", "lane", "method", "task")
    inverse = (
        "Time of a sample against the error of the inverse: what the exact inverse (f64) of a method's "
        "own map makes "
        "of the unit direction that it returned in f32, against the random numbers; root mean square. "
        f"On the mix: {mix['mix', 'projected']['rms']:.1e} for <code>projected</code>, "
        f"{mix['mix', 'published']['rms']:.1e} for the published method, whose inverse of a segment's "
        "area is an "
        f"approximation. Dotted: the front of scalars. {on_front(bench, maps['inverse'], 'rms')}."
    )
    noise = rows_by(maps["deviation"], "set", "method")
    ratio = times["mix", "f32", "projected", ONE]["ratio"]
    deviation = (
        "Time of a sample against noise: the standard deviation of cosine over density, which is one "
        "sample of a "
        "diffuse surface's irradiance without occlusion, relative to the mean over the caps. On the mix: "
        f"{noise['mix', 'solid_angle']['deviation']:.2g} for <code>solid_angle</code>, "
        f"{noise['mix', 'projected_bounded']['deviation']:.2g} for <code>projected_bounded</code>, "
        f"{noise['mix', 'projected']['deviation']:.2g} (rounding) for <code>projected</code> at "
        f"{ratio:.2f} times the "
        f"time of <code>solid_angle</code>. {on_front(bench, maps['deviation'], 'deviation')}."
    )
    both = bench | {"command": "make report: make bench, cargo bench --bench maps"}
    return Section(
        "speed",
        "Speed against error",
        figure(draw(bench, maps["inverse"], "rms", "error of the inverse"), "pareto-inverse", inverse, both)
        + figure(
            draw(bench, maps["deviation"], "deviation", "relative standard deviation"),
            "pareto-deviation",
            deviation,
            both,
        ),
    )
