"""Renders a scene with both emitters at equal sample counts, and measures time and noise.

Both emitters converge to the same image, so that the error of a render is its noise: how renders with
different seeds differ. That needs no reference, and there is an answer after two renders of each.

The demo of the repository shares this; it has other scenes and references.
"""

import gc
import time
from collections.abc import Callable, Sequence
from dataclasses import dataclass

import mitsuba as mi
import numpy as np

from spherecap_command.errors import UserError
from spherecap_command.measure import error_scale
from spherecap_command.scene import BUILT_IN, OURS, explained

# A result has so many renders at least, two of them each time that its scene is loaded.
RENDERS = 4
RENDERS_IN_TURN = 2

# A reference is the mean of so many independent renders with each emitter: their spread tells its noise.
PASSES = 8
FIRST_REFERENCE_SEED = 5000

Load = Callable[[str], "mi.Scene"]
Advance = Callable[[int], None]


@dataclass(frozen=True)
class Reference:
    """An image, the variance of its pixels, the pixels to be trusted, and where it comes from, in words."""

    image: np.ndarray
    variance: np.ndarray
    trusted: np.ndarray
    origin: str

    @property
    def noise(self) -> float:
        """Its own relative mean squared error."""
        return relative(self.variance, self)


def relative(variance: np.ndarray, truth: Reference) -> float:
    """Return the mean of the pixels' variances, relative to the reference."""
    return float(np.mean((variance / error_scale(truth.image) ** 2)[truth.trusted]))


class Result:
    """One technique at one sample count: its first image, mean and variance of all, the shortest time."""

    def __init__(self, technique: str, spp: int):
        """Begin without any render."""
        self.technique, self.spp = technique, spp
        self.renders, self.seconds = 0, np.inf
        self._deviations = 0.0

    def add(self, image: np.ndarray, seconds: float = np.inf) -> None:
        """Take one more render into account (Welford's way, as all images may be too many to keep)."""
        if self.renders == 0:
            self.image, self.mean = image, np.zeros_like(image)
        self.renders += 1
        step = image - self.mean
        self.mean = self.mean + step / self.renders
        self._deviations = self._deviations + step * (image - self.mean)
        self.seconds = min(self.seconds, seconds)

    @property
    def variance(self) -> np.ndarray:
        """The variance of one render, for each pixel."""
        return self._deviations / (self.renders - 1)

    def rmse(self, truth: Reference) -> float:
        """Return the relative RMSE of one render."""
        return relative(self.variance, truth) ** 0.5


def render(scene: "mi.Scene", spp: int, seed: int, integrator: "mi.Integrator | None" = None) -> np.ndarray:
    """Render with `spp` samples per pixel: an array (height, width, 3), or 1 for a film without colours.

    Other seeds give independent images. Alpha and further channels are left out.
    """
    with explained("Mitsuba cannot render the scene"):
        image = np.array(mi.render(scene, integrator=integrator, spp=spp, seed=seed), dtype=np.float64)
    return image[..., : 3 if image.shape[-1] >= 3 else 1]


def samples_taken(scene: "mi.Scene", spp: int) -> int:
    """Return what the scene's sampler makes of a sample count: stratified ones round up."""
    sampler = scene.sensors()[0].sampler().clone()
    sampler.set_sample_count(spp)
    return sampler.sample_count()


def rendered_reference(load: Load, spp: int, advance: Advance) -> Reference:
    """Render `spp` samples per pixel with each emitter; `advance` is told the samples done by each pass.

    The built-in emitter alone would be much noisier than what is to be measured: where the horizon cuts a
    sphere its rare bright samples never average out.
    """
    share = -(-spp // PASSES)
    results = []
    for number, technique in enumerate((BUILT_IN, OURS)):
        first_seed = FIRST_REFERENCE_SEED + PASSES * number
        scene = load(technique)
        result = Result(technique, share)
        for seed in range(first_seed, first_seed + PASSES):
            result.add(render(scene, share, seed))
            advance(share)
        results.append(result)
        del scene
        gc.collect()
    return mean_of_all(results)


def mean_of_all(results: Sequence[Result]) -> Reference:
    """Return the mean of all renders there are, with the larger weight for the less noisy technique."""
    means, variances = [], []
    for technique in (BUILT_IN, OURS):
        its = [one for one in results if one.technique == technique]
        weights = np.array([one.spp * one.renders for one in its], dtype=float)
        weights /= weights.sum()
        means.append(sum(w * one.mean for w, one in zip(weights, its, strict=True)))
        variances.append(sum(w**2 * one.variance / one.renders for w, one in zip(weights, its, strict=True)))
        if not np.all(np.isfinite(means[-1])):
            raise UserError(f"with '{technique}' the scene has pixels that are infinite or not a number")
    lit = [bool(np.any(mean)) for mean in means]
    if not any(lit):
        raise UserError("the scene renders black: does its light reach what the camera sees?")
    if not all(lit):
        black, other = (BUILT_IN, OURS) if lit[1] else (OURS, BUILT_IN)
        why = ": its lights are seen too small for it, less than 0.02 degrees" if black == BUILT_IN else ""
        raise UserError(f"with '{black}' the scene renders black, with '{other}' it does not{why}")
    noise = [variance.mean() for variance in variances]
    ours = noise[0] / sum(noise) if sum(noise) > 0 else 0.5
    spp = sum(one.spp * one.renders for one in results) // 2
    return Reference(
        (1 - ours) * means[0] + ours * means[1],
        (1 - ours) ** 2 * variances[0] + ours**2 * variances[1],
        np.ones(means[0].shape[:2], dtype=bool),
        f"{BUILT_IN} and {OURS}, {spp} spp each",
    )


class Comparison:
    """Renders of the scene that `load` gives for an emitter; `advance` is told the samples of each."""

    def __init__(self, load: Load, advance: Advance):
        """Begin without any render."""
        self._load, self._advance = load, advance
        self._seed = 0
        self._turn_seconds = 0.0
        self.results: list[Result] = []

    def take_turn(self, spp: int) -> None:
        """Render with both emitters, a few times.

        In turns, so that whatever else the machine does slows both alike. One scene at a time, because JIT
        variants compile all that may be called: every emitter that there is. They compile in the first
        render, which is why the shortest time counts: nothing is rendered just to be warm.
        """
        began = time.perf_counter()
        pair = [one for one in self.results if one.spp == spp]
        if not pair:
            pair = [Result(technique, spp) for technique in (BUILT_IN, OURS)]
        for result in pair:
            scene = self._load(result.technique)
            for seed in range(self._seed + 1, self._seed + RENDERS_IN_TURN + 1):
                start = time.perf_counter()
                image = render(scene, spp, seed)
                result.add(image, time.perf_counter() - start)
                self._advance(spp)
            del scene
            gc.collect()
        self._seed += RENDERS_IN_TURN
        if pair[0] not in self.results:  # now that both are there
            self.results += pair
        self._turn_seconds = time.perf_counter() - began

    def measure(self, spp: int, deadline: float = np.inf) -> None:
        """Take the turns that a result needs, as far as there is time; one, if there is no result yet.

        deadline: as `time.perf_counter` tells it.
        """
        for _ in range(RENDERS // RENDERS_IN_TURN):
            if not self.results or self._expected_end(spp) < deadline:
                self.take_turn(spp)

    def repeat(self, deadline: float) -> None:
        """Take more turns at the last sample count while there is time."""
        last = self.results[-1].spp
        while self._expected_end(last) < deadline:
            self.take_turn(last)

    def _expected_end(self, spp: int) -> float:
        return time.perf_counter() + self._turn_seconds * max(spp / self.results[-1].spp, 1)


def compare(load: Load, counts: Sequence[int], advance: Advance) -> list[Result]:
    """Measure both emitters at all of some sample counts."""
    comparison = Comparison(load, advance)
    for spp in counts:
        comparison.measure(spp)
    return comparison.results


def samples_to_render(counts: Sequence[int], reference: int) -> int:
    """Return how many samples per pixel a comparison and its reference report in all."""
    return 2 * RENDERS * sum(counts) + 2 * PASSES * -(-reference // PASSES)


HEADINGS = ("spp", "technique", "s/render", "rel. RMSE", "ratio", "equal-time ratio")
FOOTNOTE = (
    f"ratio: RMSE of {BUILT_IN} over that of {OURS} at equal samples; "
    "equal-time ratio: of RMSE^2 times seconds, so how much longer the other takes to be as good"
)


def rows(results: Sequence[Result], truth: Reference) -> list[tuple[str, ...]]:
    """Return the comparison in words, a row per result; ours has its ratios to the built-in emitter."""
    lines = []
    for area, ours in pairs(results):
        errors = [one.rmse(truth) for one in (area, ours)]
        ratio = errors[0] / errors[1] if errors[1] > 0 else np.inf
        ratios = (f"{ratio:.2f}x", f"{equal_time(area, ours, truth):.2f}x")
        for one, error, last in zip((area, ours), errors, (("", ""), ratios), strict=True):
            lines.append((str(one.spp), one.technique, f"{one.seconds:.3f}", f"{error:.4f}", *last))
    return lines


def pairs(results: Sequence[Result]) -> list[tuple[Result, Result]]:
    """Return the built-in emitter and ours at each sample count."""
    return list(zip(results[::2], results[1::2], strict=True))


def equal_time(area: Result, ours: Result, truth: Reference) -> float:
    """Return how much longer the built-in emitter takes to be as good as ours."""
    error = ours.rmse(truth)
    return (area.rmse(truth) / error) ** 2 * area.seconds / ours.seconds if error > 0 else np.inf


def table(results: Sequence[Result], truth: Reference) -> str:
    """Return the comparison as text."""
    return f"{text_table([HEADINGS, *rows(results, truth)])}\n{FOOTNOTE}"


def text_table(lines: Sequence[Sequence[str]]) -> str:
    """Return a table as text, its columns flush right."""
    widths = [max(map(len, column)) for column in zip(*lines, strict=True)]
    aligned = ["  ".join(cell.rjust(w) for cell, w in zip(line, widths, strict=True)) for line in lines]
    return "\n".join(aligned)
