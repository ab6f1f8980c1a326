"""What is rendered for `make cross`, what is measured of it, and what it should reach.

Every scene is rendered four times, with different seeds, at each number of samples per pixel. The spread
over seeds, pixel by pixel, gives variances: renderers treat pixels independently of each other, so that the
variance of an image's mean follows from the pixels' (12288 of them with 3 degrees of freedom each: known to
a percent).
"""

from dataclasses import dataclass

import numpy as np
from spherecap_command.measure import DARK, error_scale
from spherecap_command.scene import BUILT_IN, OURS

from cross.jobs import RENDERERS, Renderer, Stack
from cross.reference import analytic_image, jittered_images, lit_pixels
from cross.scene import SCENES, Scene
from cross.worker import Job

WIDTH, HEIGHT = 128, 96
SPP = (1, 4, 16, 64, 256)
SEEDS = (1, 2, 3, 4)
# Samples per pixel of the images that are held against the reference, where they are more than the most of
# SPP. What of the sphere is above the floor in S4 is so little that uniform directions leave too much noise;
# of ten lights, the one that matters is chosen once in ten times.
PRECISE_SPP = {"S4": 1296, "ten lights": 1296}
# The squared error's own scale: all but the black disc inside the light counts on an open floor; penumbrae
# that are nearly black would decide alone elsewhere (see `spherecap_command.measure`).
OPEN_FLOOR_DARK = 0.001

# Targets: standard errors of the image mean, and by how many of them it may be off; relative errors of
# pixels; and the error of one sample, over that of exact values at random positions in the pixels.
LARGEST_STANDARD_ERROR = 2e-4
STANDARD_ERRORS = 3.0
LARGEST_PIXEL_ERROR = 0.015
OVER_JITTER = 1.15
# A side of the blocks of pixels whose errors are judged. Single pixels are still as noisy as they are wide:
# with 1024 samples 2 % where a shadow ends, 5 % in the closed box. Blocks of 4 x 4 are pixels of a smaller
# image.
BLOCK = 4
JITTER_SCENES = ("S1", "S2", "S4")
# What renderers differ by for good: rays that start off the surface (9e-5 (1 + |p|) in Mitsuba: 2.1e-5 of
# the image under the light that all but touches the floor), balls made of triangles (1.5e-4 of a shadow's
# area), sums in single precision (3e-6). A standard error of this size is added to those measured.
SYSTEMATIC = 2e-5


@dataclass(frozen=True)
class Series:
    """A renderer with settings. Samplers are independent or stratified, and compared with their like."""

    label: str
    renderer: Renderer
    light_sampling: str
    sampler: str
    is_independent: bool = False

    @property
    def is_uniform(self) -> bool:
        """Tell whether the whole light is sampled uniformly, what is below the horizon included."""
        return self.light_sampling in (BUILT_IN, "cone")

    def renders(self, scene: Scene) -> bool:
        """Tell whether it can render a scene: the C renderer knows direct light only."""
        return scene.bounces == 0 or self.renderer.name != "c"

    def job(self, scene: Scene, spp: int) -> Job:
        """Return one of its jobs."""
        return Job(scene.name, WIDTH, HEIGHT, self.light_sampling, self.sampler, spp, SEEDS)


AREA = Series("Mitsuba area", RENDERERS["mitsuba"], BUILT_IN, "independent", is_independent=True)
SPHERECAP = Series("Mitsuba spherecap", RENDERERS["mitsuba"], OURS, "independent", is_independent=True)
AREA_STRATIFIED = Series("Mitsuba area, multijitter", RENDERERS["mitsuba"], BUILT_IN, "multijitter")
SPHERECAP_STRATIFIED = Series("Mitsuba spherecap, multijitter", RENDERERS["mitsuba"], OURS, "multijitter")
C = Series("C spherecap", RENDERERS["c"], "projected", "independent", is_independent=True)
C_LATTICE = Series("C spherecap, lattice", RENDERERS["c"], "projected", "lattice")
LUXCORE = Series("LuxCore, Sobol", RENDERERS["luxcore"], "cone", "SOBOL")
CYCLES = Series("Cycles, Sobol", RENDERERS["cycles"], "cone", "TABULATED_SOBOL")
ALL_SERIES = (
    AREA,
    SPHERECAP,
    C,
    AREA_STRATIFIED,
    SPHERECAP_STRATIFIED,
    C_LATTICE,
    LUXCORE,
    CYCLES,
)

# Who is known to be wrong where; `make cross` fails if one of them is not, any more. Both form 1 - cos of
# the light's angular radius in single precision: at 1/1000 that is 5e-7, eight or nine units in the last
# place of 1.
KNOWN_WRONG = {
    ("far", AREA_STRATIFIED.label),
    ("far", LUXCORE.label),
}


def series_of(scene: Scene) -> list[Series]:
    """Return who renders a scene."""
    return [series for series in ALL_SERIES if series.renders(scene)]


def agrees(found: dict[str, float]) -> bool:
    """Judge the image mean."""
    return abs(found["bias"]) <= allowed_bias(found)


def allowed_bias(found: dict[str, float]) -> float:
    """Return how far an image mean may be off."""
    return STANDARD_ERRORS * float(np.hypot(found["standard_error"], SYSTEMATIC))


def spp_of(series: Series, scene: Scene) -> tuple[int, ...]:
    """Return the numbers of samples per pixel that a series is rendered with."""
    precise = precise_spp(series, scene)
    return SPP if series.is_independent or precise in SPP else (*SPP, precise)


def precise_spp(series: Series, scene: Scene) -> int:
    """Return the samples per pixel that are enough to be held against the reference."""
    return PRECISE_SPP.get(scene.name, SPP[-1]) if series.is_uniform else SPP[-1]


def all_work() -> list[tuple[Series, Scene, int]]:
    """Return all that is to be rendered, the longest first: no core is left alone with it at the end."""
    work = [(x, scene, spp) for scene in SCENES for x in series_of(scene) for spp in spp_of(x, scene)]
    order = [LUXCORE.renderer, CYCLES.renderer, C.renderer, AREA.renderer]
    return sorted(work, key=lambda w: (order.index(w[0].renderer), -w[2] * (1 + w[1].bounces)))


@dataclass(frozen=True)
class Reference:
    """What an image should be.

    mask: the pixels that count. origin: "analytic" or "pooled". dark: see
    `spherecap_command.measure.error_scale`.
    """

    image: np.ndarray
    mask: np.ndarray
    origin: str
    dark: float

    @property
    def mean(self) -> float:
        """The mean over the pixels that count."""
        return float(self.image[self.mask].mean())


def reference_for(scene: Scene, precise: dict[Series, Stack]) -> Reference:
    """Return the analytic answer, or the plain mean of all precise images: no renderer's word counts more."""
    if scene.is_open_floor:
        height, width = next(iter(precise.values())).images.shape[1:]
        image = analytic_image(scene, width, height)
        return Reference(image, lit_pixels(scene, width, height), "analytic", OPEN_FLOOR_DARK)
    image = np.mean([stack.images.mean(axis=0) for stack in precise.values()], axis=0)
    return Reference(image, np.ones_like(image, dtype=bool), "pooled", DARK)


def in_blocks(image: np.ndarray, mask: np.ndarray) -> np.ndarray:
    """Return the means of all blocks that are wholly in the mask."""
    height, width = image.shape
    shape = (height // BLOCK, BLOCK, width // BLOCK, BLOCK)
    return image.reshape(shape).mean(axis=(1, 3))[mask.reshape(shape).all(axis=(1, 3))]


def percentile_99(values: np.ndarray, reference: np.ndarray) -> float:
    """Return the 99th percentile of relative errors."""
    return float(np.percentile(np.abs(values - reference) / error_scale(reference), 99))


def standard_error(stack: Stack, reference: Reference) -> float:
    """Return the standard error of the stack's mean image's mean, relative to the reference's."""
    variance = stack.images[:, reference.mask].var(axis=0, ddof=1) / len(stack.images)
    return float(np.sqrt(variance.sum()) / variance.size / reference.mean)


def agreement(series: Series, precise: dict[Series, Stack], reference: Reference) -> dict[str, float]:
    """Return how far a mean image is off: `bias` and `standard_error` of its mean, the 99th percentile of its
    pixels' errors, `p99`, and of its blocks', `p99_blocks`.

    All are relative. Against a pooled reference, which the series is a part of, `standard_error` is that of
    the difference; `own_error` is that of its own mean.
    """
    image = precise[series].images.mean(axis=0)
    own = standard_error(precise[series], reference)
    error = own
    if reference.origin == "pooled":
        count = len(precise)
        errors = [standard_error(stack, reference) for other, stack in precise.items() if other != series]
        error = float(np.hypot(own * (count - 1) / count, np.linalg.norm(errors) / count))
    blocks, block_reference = (in_blocks(values, reference.mask) for values in (image, reference.image))
    return {
        "bias": float(image[reference.mask].mean() / reference.mean - 1),
        "standard_error": error,
        "own_error": own,
        "p99": percentile_99(image[reference.mask], reference.image[reference.mask]),
        "p99_blocks": percentile_99(blocks, block_reference),
    }


def squared_error(stack: Stack, reference: Reference) -> tuple[float, float]:
    """Return the relative mean squared error of one render, and that number's standard error.

    A pooled reference contains these very renders, so there the spread between seeds is taken instead.
    """
    images, scale = (
        stack.images[:, reference.mask],
        error_scale(reference.image, reference.dark)[reference.mask],
    )
    if reference.origin == "analytic":
        squared = ((images - reference.image[reference.mask]) / scale) ** 2
    else:
        squared = images.var(axis=0, ddof=1) / scale**2
    return float(squared.mean()), float(squared.std() / np.sqrt(squared.size))


def slope(spp: list[float], rmse: list[float]) -> float:
    """Return the exponent of the error's fall with the number of samples, by least squares."""
    return float(np.polyfit(np.log(spp), np.log(rmse), 1)[0])


def measure_scene(scene: Scene, stacks: dict[tuple[Series, int], Stack]) -> tuple[dict, Reference]:
    """Return all numbers of one scene, and its reference."""
    series_here = series_of(scene)
    precise = {x: stacks[x, precise_spp(x, scene)] for x in series_here if not x.is_independent}
    reference = reference_for(scene, precise)
    rows = {}
    for series in series_here:
        own = [stacks[series, spp] for spp in SPP]
        errors = [squared_error(stack, reference) for stack in own]
        rmse = [error**0.5 for error, _ in errors]
        spp = [float(stack.spp.mean()) for stack in own]
        row = {
            "label": series.label,
            "spp": spp,
            "rmse": rmse,
            "squared_error_error": [error for _, error in errors],
            "slope": slope(spp, rmse),
            # Of the longest renders, where what is done once per image counts least.
            "microseconds_per_sample": float(np.median(own[-1].seconds / own[-1].spp))
            / (WIDTH * HEIGHT)
            * 1e6,
        }
        if series in precise:
            row |= agreement(series, precise, reference)
            row["known_wrong"] = (scene.name, series.label) in KNOWN_WRONG
        rows[series] = row
    for series, row in rows.items():
        base = rows[AREA if series.is_independent else AREA_STRATIFIED]
        # Work is squared error by time; LuxCore takes a few samples more than it is asked for.
        row["equal_time"] = [_work(base, i) / _work(row, i) for i in range(len(SPP))]
    result = {
        "name": scene.name,
        "about": scene.about,
        "reference": reference.origin,
        "mean": reference.mean,
        "series": list(rows.values()),
    }
    if reference.origin == "analytic":
        exact = Stack(jittered_images(scene, WIDTH, HEIGHT, range(len(SEEDS))), np.zeros(1), np.ones(1))
        result["jitter_floor"] = squared_error(exact, reference)[0] ** 0.5
    return result, reference


def _work(row: dict, i: int) -> float:
    return row["rmse"][i] ** 2 * row["spp"][i] * row["microseconds_per_sample"]


def targets(scenes: list[dict]) -> list[dict]:
    """Return what was to be reached: a name, whether it was, and the number that decides."""
    found = []

    def add(name: str, ok: bool, text: str) -> None:
        found.append({"name": name, "ok": bool(ok), "text": text})

    for scene in scenes:
        rows = {row["label"]: row for row in scene["series"]}
        for label, row in rows.items():
            if "bias" not in row:
                continue
            name = f"{scene['name']}: {label}"
            text = f"bias {row['bias']:+.1e}, allowed {allowed_bias(row):.1e}"
            if row["known_wrong"]:
                add(f"{name} is off, as is known", not agrees(row), text)
                continue
            add(f"{name} agrees in the mean", agrees(row), text)
            error = row["own_error"]
            add(f"{name} is precise", error <= LARGEST_STANDARD_ERROR, f"standard error {error:.1e}")
            add(
                f"{name} agrees in blocks of pixels",
                row["p99_blocks"] <= LARGEST_PIXEL_ERROR,
                f"99th percentile {row['p99_blocks']:.2%}",
            )
        if scene["name"] in JITTER_SCENES:
            ratio = rows[SPHERECAP.label]["rmse"][0] / scene["jitter_floor"]
            add(
                f"{scene['name']}: one sample is down to jitter",
                ratio <= OVER_JITTER,
                f"{ratio:.3f} times the jitter",
            )
        for ours, base in ((SPHERECAP, AREA), (SPHERECAP_STRATIFIED, AREA_STRATIFIED)):
            a, b = rows[ours.label], rows[base.label]
            excess = max(
                (a["rmse"][i] ** 2 - b["rmse"][i] ** 2)
                / np.hypot(a["squared_error_error"][i], b["squared_error_error"][i])
                for i in range(len(SPP))
            )
            add(
                f"{scene['name']}: {ours.label} is never noisier than {base.label}",
                excess <= STANDARD_ERRORS,
                f"{excess:+.1f} standard errors at worst",
            )
    return found
