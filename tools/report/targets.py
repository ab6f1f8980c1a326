"""The project's targets, beside what was measured."""

from dataclasses import dataclass

from report.data import rows_by
from report.page import Section, origin, table
from report.renders import plugin_files
from report.speed import MANY, ONE


@dataclass(frozen=True)
class Target:
    """What should be at most `limit`.

    kind: a "ceiling" is of the scalar `solid_angle`, the baseline of a "ratio", which counts only while that
        holds.
    """

    name: str
    limit: float
    measured: float
    digits: int = 2
    kind: str = ""

    @property
    def is_met(self) -> bool:
        """Tell whether it is."""
        return self.measured <= self.limit


def plugin_kibibytes() -> float:
    """Return the size of the linked plugin."""
    return sum(file.stat().st_size for file in plugin_files()) / 1024


def targets(bench: dict, instructions: dict, maps: dict, recorded: dict) -> list[Target]:
    """Return all targets. Those of packets are left out where the CPU has none."""
    times = rows_by(bench["rows"], "set", "lane", "method", "task")
    counts = rows_by(instructions["rows"], "set", "lane", "method", "task")

    def ratio(lane: str, task: str) -> float:
        return times["mix", lane, "projected", task]["ratio"]

    def count(method: str, task: str) -> float:
        return counts["mix", "f32", method, task]["instructions"]

    one, many = "prepare + sample + pdf", "per sample over 16"
    plain, ours = "<code>solid_angle</code>, scalar", "<code>projected</code>, scalar"
    found = [
        Target(f"{plain}: {one}, instructions", 110, count("solid_angle", ONE), 0, "ceiling"),
        Target(f"{plain}: {many}, instructions", 75, count("solid_angle", MANY), 0, "ceiling"),
        Target(f"{ours}: {one}, instructions", 190, count("projected", ONE), 0),
        Target(f"{ours}: {many}, instructions", 95, count("projected", MANY), 0),
        Target(f"{ours}: {one}, time", 2.0, ratio("f32", ONE), kind="ratio"),
        Target(f"{ours}: {many}, time", 1.2, ratio("f32", MANY), kind="ratio"),
    ]
    for lane, limit in (("AVX-512", 0.3), ("AVX2", 0.4)):
        if ("mix", lane, "projected", ONE) in times:
            name = f"<code>projected</code>, {lane} packets: {one}, time"
            found.append(Target(name, limit, ratio(lane, ONE), kind="ratio"))
    name = f"recorded ({recorded['variant']}): emitter sampling alone, time over that of <code>area</code>"
    return [
        *found,
        Target(name, 1.8, recorded["ratio"]),
        Target("a prepared f32 cap, bytes", 256, maps["sampler_bytes"], 0),
        Target("the linked plugin, KiB", 1024, plugin_kibibytes(), 0),
    ]


def verdict(target: Target, baseline_holds: bool) -> str:
    """Say whether a target is met."""
    if not target.is_met:
        return '<span class="missed">missed</span>'
    if target.kind == "ratio" and not baseline_holds:
        return '<span class="missed">does not count</span>'
    return "met"


def section(bench: dict, instructions: dict, maps: dict, recorded: dict) -> Section:
    """Return the table."""
    found = targets(bench, instructions, maps, recorded)
    holds = all(target.is_met for target in found if target.kind == "ceiling")
    verdicts = [verdict(target, holds) for target in found]
    rows = [
        [target.name, f"{target.limit:g}", f"{target.measured:.{target.digits}f}", word]
        for target, word in zip(found, verdicts, strict=True)
    ]
    times = rows_by(bench["rows"], "set", "lane", "method", "task")
    text = (
        f"<p>{verdicts.count('met')} of {len(found)} are met. Times are ratios to our own scalar "
        "<code>solid_angle</code> in f32 in the same run (medians of the ratios within rounds), on the "
        "mix of a "
        "scene, and count only while <code>solid_angle</code> meets its own ceilings: it "
        f"{'does' if holds else 'does not'}. By the same measure the published method takes "
        f"{times['mix', 'f32', 'published', ONE]['ratio']:.2f} and "
        f"{times['mix', 'f32', 'published', MANY]['ratio']:.2f}. One sample is drawn in one call with its "
        "preparation, as in a renderer that inlines the library; for more, the preparation is stored.</p>"
    )
    origins = "".join(origin(about) for about in (bench, instructions, maps, recorded))
    return Section("targets", "Targets", text + table(["", "at most", "measured", ""], rows) + origins)
