"""The project's targets, beside what was measured."""

import re
from dataclasses import dataclass

import numpy as np
from renderlab.scenes import REPOSITORY

from report.data import rows_by
from report.page import Section, origin, table
from report.renders import plugin_files
from report.speed import MANY, ONE

DROPPED = (
    "Earlier targets were dropped. 190 and 95 instructions for `projected`, 110 and 75 for `solid_angle`: "
    "the prototypes that they came from had no answer to cancelled digits and overflow. Times over those of "
    "our own `solid_angle`, those of packets, too: it takes half the time since, which must not count "
    "against `projected`. The published method has taken its place, and packets are measured in instructions."
)


@dataclass(frozen=True)
class Target:
    """What should be at most `limit`; the name is Markdown."""

    name: str
    limit: float
    measured: float
    digits: int = 2

    @property
    def is_met(self) -> bool:
        """Tell whether it is."""
        return self.measured <= self.limit


def plugin_kibibytes() -> float:
    """Return the size of the linked plugin."""
    return sum(file.stat().st_size for file in plugin_files()) / 1024


def counts() -> dict[str, int]:
    """Return what the kernels' size is, by name: the same on every machine."""
    lines = (REPOSITORY / "tests" / "data" / "counts.txt").read_text().splitlines()
    return {name: int(count) for name, _, count in (line.rpartition(": ") for line in lines)}


def time_over_area(results: list[dict]) -> float:
    """Return the median over scenes of the time of `projected` over that of `area`, at the most samples."""
    ratios = []
    for result in results:
        seconds = {name: np.median(found["seconds"][-1]) for name, found in result["methods"].items()}
        ratios.append(seconds["projected"] / seconds["area"])
    return float(np.median(ratios))


def targets(bench: dict, instructions: dict, alone: float, scenes: float, plugin: float) -> list[Target]:
    """Return all targets. Those of packets are left out where the CPU has none.

    alone: time of emitter sampling in `llvm_ad_rgb` over that of `area`. scenes: time of renders in
    `scalar_rgb` over that with `area`, the median of scenes. plugin: its KiB.
    """
    times = rows_by(bench["rows"], "set", "lane", "method", "task")
    found = rows_by(instructions["rows"], "set", "lane", "method", "task")
    size = counts()

    def over(other: str, task: str) -> float:
        ours, theirs = (times["mix", "f32", method, task]["nanoseconds"] for method in ("projected", other))
        return ours / theirs

    def count(method: str, task: str, lane: str = "f32") -> float:
        return found["mix", lane, method, task]["instructions"]

    one, many = "one call", "per sample over 16"
    listed = [
        Target(f"`projected`, instructions, {one}", 300, count("projected", ONE), 0),
        Target(f"`projected`, instructions, {many}", 125, count("projected", MANY), 0),
        Target(f"`solid_angle`, instructions, {one}", 170, count("solid_angle", ONE), 0),
        Target(f"`solid_angle`, instructions, {many}", 95, count("solid_angle", MANY), 0),
    ]
    for other, limits in (("published", (0.95, 0.85)), ("published, cube root", (1.2, 1.0))):
        for (name, task), limit in zip(((one, ONE), (many, MANY)), limits, strict=True):
            listed.append(Target(f"`projected`, time over `{other}`, {name}", limit, over(other, task)))
    for lane, limit in (("AVX2", 127), ("AVX-512", 54)):
        if ("mix", lane, "projected", ONE) in found:
            name = f"`projected`, instructions, {lane} packets"
            listed.append(Target(name, limit, count("projected", ONE, lane), 0))
    executed, pdf = "sample, executed on the mix", "pdf of a place on the sphere"
    return [
        *listed,
        Target(f"`projected`, recorded operations, {executed}", 360, size[f"projected, {executed}"], 0),
        Target(f"`projected`, recorded operations, {pdf}", 200, size[f"projected, {pdf}"], 0),
        Target("emitter sampling alone in `llvm_ad_rgb`, time over `area`", 2.2, alone),
        Target("renders in `scalar_rgb`, time over `area`, median of the scenes", 1.05, scenes),
        Target("a prepared f32 sampler, bytes", 256, size["sampler, bytes"], 0),
        Target("the linked plugin, KiB", 1536, plugin, 0),
    ]


def rows(found: list[Target]) -> list[list[str]]:
    """Return the targets in words: name, limit, what was measured, verdict."""
    return [
        [one.name, f"{one.limit:g}", f"{one.measured:.{one.digits}f}", "met" if one.is_met else "missed"]
        for one in found
    ]


def html(text: str) -> str:
    """Return Markdown's code as HTML's."""
    return re.sub("`(.*?)`", r"<code>\1</code>", text)


def section(bench: dict, instructions: dict, recorded: dict, results: list[dict]) -> Section:
    """Return the table."""
    found = targets(bench, instructions, recorded["ratio"], time_over_area(results), plugin_kibibytes())
    lines = [
        [html(name), *numbers, word if word == "met" else f'<span class="missed">{word}</span>']
        for name, *numbers, word in rows(found)
    ]
    text = (
        f"<p>{sum(one.is_met for one in found)} of {len(found)} are met. Instructions and times are on the "
        "mix of a scene, in f32. One sample is drawn in one call with its preparation, as in a renderer that "
        f"inlines the library; for more, the preparation is stored.</p><p>{html(DROPPED)}</p>"
    )
    origins = "".join(origin(about) for about in (bench, instructions, recorded, results[0]["about"]))
    return Section("targets", "Targets", text + table(["", "at most", "measured", ""], lines) + origins)
