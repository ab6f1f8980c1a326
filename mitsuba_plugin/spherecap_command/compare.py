"""Renders a scene with both emitters at equal sample counts, and measures time and error.

The demo of the repository shares this; it has other scenes and references.
"""

import gc
import time
from collections.abc import Callable, Sequence
from dataclasses import dataclass, field

import mitsuba as mi
import numpy as np

from spherecap_command.errors import UserError
from spherecap_command.measure import error_scale, relative_mse
from spherecap_command.scene import BUILT_IN, OURS

# Time is measured over this many renders with different seeds, and the error over all of them.
RENDERS = 4

# A reference is the mean of so many independent renders with each emitter: their spread tells its noise.
PASSES = 8
FIRST_REFERENCE_SEED = 5000


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
        return float(np.mean((self.variance / error_scale(self.image) ** 2)[self.trusted]))


@dataclass(frozen=True)
class Result:
    """One technique at one sample count: its first image, seconds per render, RMSE relative to the truth."""

    technique: str
    spp: int
    image: np.ndarray
    seconds: float
    rmse: float


@dataclass
class _Run:
    """The images so far, and the seconds they took."""

    images: list[np.ndarray] = field(default_factory=list)
    seconds: float = 0.0


def render(scene: "mi.Scene", spp: int, seed: int) -> np.ndarray:
    """Render with `spp` samples per pixel: an array (height, width, 3), or 1 for a film without colours.

    Other seeds give independent images. Alpha and further channels are left out.
    """
    image = np.array(mi.render(scene, spp=spp, seed=seed), dtype=np.float64)
    return image[..., : 3 if image.shape[-1] >= 3 else 1]


def samples_taken(scene: "mi.Scene", spp: int) -> int:
    """Return what the scene's sampler makes of a sample count: stratified ones round up."""
    sampler = scene.sensors()[0].sampler().clone()
    sampler.set_sample_count(spp)
    return sampler.sample_count()


def rendered_reference(
    load: Callable[[str], "mi.Scene"], spp: int, advance: Callable[[int], None]
) -> Reference:
    """Render `spp` samples per pixel with each emitter; `advance` is told the samples done by each pass.

    The better of the two has the larger weight. The built-in emitter alone would be much noisier than what is
    to be measured: where the horizon cuts a sphere its rare bright samples never average out.
    """
    share = -(-spp // PASSES)
    means, variances = [], []
    for number, technique in enumerate((BUILT_IN, OURS)):
        first_seed = FIRST_REFERENCE_SEED + PASSES * number
        scene = load(technique)
        passes = []
        for seed in range(first_seed, first_seed + PASSES):
            passes.append(render(scene, share, seed))
            advance(share)
        stack = np.stack(passes)
        if not np.all(np.isfinite(stack)):
            raise UserError(f"with '{technique}' the scene has pixels that are infinite or not a number")
        if not np.any(stack):
            raise UserError("the scene renders black: does its light reach what the camera sees?")
        means.append(stack.mean(axis=0))
        variances.append(stack.var(axis=0, ddof=1) / PASSES)
        del scene
        gc.collect()
    noise = [variance.mean() for variance in variances]
    ours = noise[0] / sum(noise) if sum(noise) > 0 else 0.5
    return Reference(
        (1 - ours) * means[0] + ours * means[1],
        (1 - ours) ** 2 * variances[0] + ours**2 * variances[1],
        np.ones(means[0].shape[:2], dtype=bool),
        f"{BUILT_IN} and {OURS}, {PASSES * share} spp each",
    )


def compare(
    load: Callable[[str], "mi.Scene"], counts: Sequence[int], truth: Reference, advance: Callable[[int], None]
) -> list[Result]:
    """Render the scene that `load` gives for an emitter; `advance` is told the samples done each time."""
    runs = {(technique, spp): _Run() for spp in counts for technique in (BUILT_IN, OURS)}
    # In turns, so that whatever else the machine does slows both alike. One scene at a time, because JIT
    # variants compile all that may be called: every emitter that there is.
    for seed in range(1, RENDERS + 1):
        for technique in (BUILT_IN, OURS):
            scene = load(technique)
            for spp in counts:
                run = runs[technique, spp]
                render(scene, spp, seed=0)  # Caches and, in JIT variants, compilation do not count.
                start = time.perf_counter()
                run.images.append(render(scene, spp, seed))
                run.seconds += time.perf_counter() - start
                advance(2 * spp)
            del scene
            gc.collect()
    return [
        Result(technique, spp, run.images[0], run.seconds / RENDERS, rmse_against(run.images, truth))
        for (technique, spp), run in runs.items()
    ]


def samples_to_render(counts: Sequence[int], reference: int) -> int:
    """Return how many samples per pixel a comparison and its reference report in all."""
    return 2 * 2 * RENDERS * sum(counts) + 2 * PASSES * -(-reference // PASSES)


def rmse_against(stack: list[np.ndarray], truth: Reference) -> float:
    """Return the relative RMSE of some renders, less what the reference's own noise adds to it."""
    measured = np.mean(relative_mse(np.stack(stack), truth.image, truth.trusted))
    return float(max(measured - truth.noise, 0.0)) ** 0.5


HEADINGS = ("spp", "technique", "s/render", "rel. RMSE", "ratio", "equal-time ratio")
FOOTNOTE = (
    f"ratio: RMSE of {BUILT_IN} over that of {OURS} at equal samples; "
    "equal-time ratio: of RMSE^2 times seconds, so how much longer the other takes to be as good"
)


def rows(results: Sequence[Result]) -> list[tuple[str, ...]]:
    """Return the comparison in words, a row per result; ours has its ratios to the built-in emitter."""
    base = {one.spp: one for one in results if one.technique == BUILT_IN}
    lines = []
    for one in results:
        cells = [str(one.spp), one.technique, f"{one.seconds:.3f}", f"{one.rmse:.4f}"]
        if one.technique == OURS:
            ratio = base[one.spp].rmse / one.rmse if one.rmse > 0 else np.inf
            cells += [f"{ratio:.2f}x", f"{ratio**2 * base[one.spp].seconds / one.seconds:.2f}x"]
        lines.append((*cells, *[""] * (len(HEADINGS) - len(cells))))
    return lines


def table(results: Sequence[Result]) -> str:
    """Return the comparison as text."""
    widths = (5, 10, 9, 10, 8, 17)
    lines = [HEADINGS, *rows(results)]
    aligned = [
        " ".join(cell.rjust(width) for cell, width in zip(line, widths, strict=True)) for line in lines
    ]
    return "\n".join([*aligned, FOOTNOTE])
