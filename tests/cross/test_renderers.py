"""The analytic answer, Mitsuba with both emitters and the C renderer: the same images.

Smaller than in `make cross`, where pixels and convergence are looked at as well, and LuxCore and Cycles join
in: they are large downloads, and `make cross` fails where one of them is off in its mean or in blocks of
pixels (so if it is moved or turned, too), or too noisy to tell. Every renderer is also held against a copy of
itself that is 1 % too dark, which must be refused, and against pictures that are moved by a pixel or turned.
"""

from dataclasses import replace

import numpy as np
import pytest
from cross.compare import (
    AREA_STRATIFIED,
    C_LATTICE,
    KNOWN_WRONG,
    SPHERECAP_STRATIFIED,
    Reference,
    Series,
    agreement,
    agrees,
    reference_for,
)
from cross.jobs import Stack, carry_out, check
from cross.scene import SCENES, Scene, by_name
from cross.worker import Job

WIDTH, HEIGHT, SEEDS = 32, 24, tuple(range(1, 9))
# Samples per pixel: enough for every renderer to tell a copy that is 1 % too dark; the tests check it. Of
# S4 only a sliver is above the floor, and most uniform directions miss it; which of ten lights to sample,
# most renderers choose blindly.
SPP, MORE_SPP = 64, {"S4": 256, "ten lights": 256}
TESTED = (AREA_STRATIFIED, SPHERECAP_STRATIFIED, C_LATTICE)
CASES = [(scene, series) for scene in SCENES for series in TESTED if series.renders(scene)]
RIGHT = [(scene, series) for scene, series in CASES if (scene.name, series.label) not in KNOWN_WRONG]

Images = dict[str, dict[Series, Stack]]


def name(one: Scene | Series) -> str:
    """Name a test after its scene and series."""
    return one.name if isinstance(one, Scene) else one.label


def job(scene: Scene, series: Series) -> Job:
    """Return what is rendered."""
    spp = MORE_SPP.get(scene.name, SPP)
    return Job(scene.name, WIDTH, HEIGHT, series.light_sampling, series.sampler, spp, SEEDS)


@pytest.fixture(scope="module")
def images(tmp_path_factory: pytest.TempPathFactory) -> Images:
    """Render everything, on all cores."""
    for series in TESTED:
        check(series.renderer)
    work = [(series.renderer, job(scene, series)) for scene, series in CASES]
    stacks = carry_out(work, tmp_path_factory.mktemp("renders"), progress=lambda *_: None)
    result: Images = {scene.name: {} for scene in SCENES}
    for (scene, series), stack in zip(CASES, stacks, strict=True):
        result[scene.name][series] = stack
    return result


def judge(scene: Scene, series: Series, images: Images, factor: float) -> bool:
    """Tell whether a renderer's images, made brighter by a factor, agree with the reference in their mean."""
    precise = dict(images[scene.name])
    precise[series] = replace(precise[series], images=factor * precise[series].images)
    return agrees(agreement(series, precise, reference_for(scene, precise)))


@pytest.mark.parametrize(("scene", "series"), CASES, ids=name)
def test_image_mean_agrees(scene: Scene, series: Series, images: Images) -> None:
    """Within three standard errors of the analytic answer, or of the mean of all renderers."""
    is_wrong = (scene.name, series.label) in KNOWN_WRONG
    assert judge(scene, series, images, 1.0) != is_wrong, "it is off; or, if it is known to be, not any more"
    assert not judge(scene, series, images, 0.99 if not is_wrong else 0.9), "too noisy to tell a darker copy"


def distance(image: np.ndarray, reference: Reference) -> float:
    """Return how different two images are, pixel by pixel."""
    return float(np.abs(image - reference.image)[reference.mask].sum())


@pytest.mark.parametrize(("scene", "series"), RIGHT, ids=name)
def test_image_is_in_its_place(scene: Scene, series: Series, images: Images) -> None:
    """Moved by a pixel or turned it is further from the reference, by far."""
    reference = reference_for(scene, images[scene.name])
    image = images[scene.name][series].images.mean(axis=0)
    moved = [np.roll(image, step, axis) for axis in (0, 1) for step in (-1, 1)]
    for wrong in [*moved, image[::-1], image[:, ::-1]]:
        assert distance(image, reference) < 0.5 * distance(wrong, reference)


@pytest.mark.parametrize("technique", ["solid_angle", "projected_bounded"])
@pytest.mark.parametrize("scene", ["S2", "S4"])
def test_other_techniques_agree_in_c(scene: str, technique: str, images: Images, tmp_path) -> None:
    """Where the horizon cuts the light, with the centre above and below it."""
    series = replace(C_LATTICE, light_sampling=technique)
    (stack,) = carry_out([(series.renderer, job(by_name(scene), series))], tmp_path, progress=lambda *_: None)
    changed = {scene: {**images[scene], series: stack}}
    assert judge(by_name(scene), series, changed, 1.0)
    assert not judge(by_name(scene), series, changed, 0.99), "too noisy to tell a darker copy"
