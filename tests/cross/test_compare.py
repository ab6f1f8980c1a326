"""What is measured and judged, on made-up images whose truth is known; and that table and page show it."""

import json
from pathlib import Path

import numpy as np
import pytest
from cross.compare import (
    AREA,
    HEIGHT,
    LUXCORE,
    SEEDS,
    SPHERECAP,
    SPHERECAP_STRATIFIED,
    SPP,
    WIDTH,
    Series,
    agreement,
    agrees,
    measure_scene,
    reference_for,
    series_of,
    spp_of,
    targets,
)
from cross.jobs import Stack
from cross.page import file_name, save_curves, save_page, save_pictures
from cross.reference import analytic_image
from cross.scene import SCENES, by_name
from cross.table import table

SCENE = by_name("S1")
# Relative deviation of one sample: about that of the built-in emitter on S1. Ours is made ten times as
# precise.
NOISE = 0.14

Stacks = dict[tuple[Series, int], Stack]


def made_up(noise: dict[Series, float], factor: dict[Series, float]) -> Stacks:
    """Return images of S1 with independent noise, those of some series brighter by a factor."""
    truth = analytic_image(SCENE, WIDTH, HEIGHT)
    random = np.random.default_rng(1)
    stacks = {}
    for series in series_of(SCENE):
        for spp in spp_of(series, SCENE):
            noisy = random.normal(
                factor.get(series, 1), noise.get(series, NOISE) / spp**0.5, (len(SEEDS), HEIGHT, WIDTH)
            )
            count = np.full(len(SEEDS), float(spp))
            stacks[series, spp] = Stack(noisy * truth, 1e-6 * count, count)
    return stacks


OURS = {SPHERECAP: NOISE / 10, SPHERECAP_STRATIFIED: NOISE / 10}


def missed(noise: dict[Series, float], factor: dict[Series, float]) -> list[str]:
    """Return the names of the targets that made-up images miss."""
    numbers, _ = measure_scene(SCENE, made_up(noise, factor))
    return [target["name"] for target in targets([numbers]) if not target["ok"]]


def test_good_images_reach_all_targets() -> None:
    """Noise alone is no reason to fail."""
    assert missed(OURS, {}) == []


@pytest.mark.parametrize(
    ("noise", "factor", "expected"),
    [
        (OURS, {LUXCORE: 0.99}, ["S1: LuxCore, Sobol agrees in the mean"]),
        (OURS, {LUXCORE: 0.999}, ["S1: LuxCore, Sobol agrees in the mean"]),
        (
            OURS | {SPHERECAP: 1.2 * NOISE},
            {},
            ["S1: one sample is down to jitter", "S1: Mitsuba spherecap is never noisier than Mitsuba area"],
        ),
        (
            OURS | {LUXCORE: 60 * NOISE},
            {},
            ["S1: LuxCore, Sobol is precise", "S1: LuxCore, Sobol agrees in blocks of pixels"],
        ),
    ],
)
def test_bad_images_miss_their_targets(
    noise: dict[Series, float], factor: dict[Series, float], expected: list[str]
) -> None:
    """Those, and no others."""
    assert missed(noise, factor) == expected


def test_numbers_are_those_that_went_in() -> None:
    """Errors, slope, time and work. The squared error of 4 x 12288 normal numbers is known to 0.64 %."""
    numbers, _ = measure_scene(SCENE, made_up(OURS, {}))
    rows = {row["label"]: row for row in numbers["series"]}
    area, ours = rows[AREA.label], rows[SPHERECAP.label]
    np.testing.assert_allclose(area["rmse"], NOISE / np.sqrt(SPP), rtol=4 * 0.0032)
    np.testing.assert_allclose(ours["rmse"], NOISE / 10 / np.sqrt(SPP), rtol=4 * 0.0032)
    assert abs(area["slope"] + 0.5) < 0.01
    assert area["microseconds_per_sample"] == pytest.approx(1 / (WIDTH * HEIGHT))
    np.testing.assert_allclose(ours["equal_time"], 100, rtol=4 * 0.0064 * 2**0.5)


def test_standard_error_is_the_spread_of_means() -> None:
    """Against the truth of the noise: 12288 variances with 3 degrees of freedom are known to 0.4 %."""
    stacks = made_up({}, {})
    precise = {LUXCORE: stacks[LUXCORE, SPP[-1]]}
    reference = reference_for(SCENE, precise)
    truth = reference.image[reference.mask]
    expected = NOISE / np.sqrt(SPP[-1] * len(SEEDS)) * np.linalg.norm(truth) / truth.sum()
    found = agreement(LUXCORE, precise, reference)
    assert found["standard_error"] == pytest.approx(expected, rel=0.02)
    assert agrees(found)


def test_table_and_page_show_everything(tmp_path: Path) -> None:
    """Every series with its numbers, pictures within the page, and what was missed."""
    stacks = made_up(OURS, {LUXCORE: 0.99})
    numbers, reference = measure_scene(SCENE, stacks)
    results = {"width": WIDTH, "height": HEIGHT, "seeds": len(SEEDS)}
    results |= {"scenes": [numbers], "targets": targets([numbers])}
    (tmp_path / "results.json").write_text(json.dumps(results))
    save_pictures(tmp_path, SCENE, stacks, reference)
    save_curves(tmp_path, numbers)
    text, page = table(results), save_page(tmp_path).read_text()
    for series in series_of(SCENE):
        assert series.label in text
        assert series.label in page
    assert "MISSED  S1: LuxCore, Sobol agrees in the mean: bias -" in text
    assert "LuxCore, Sobol agrees in the mean: bias -" in page
    assert page.count("<img ") == page.count('src="data:image/png;base64,') == 2
    for kind in ("pictures", "curves"):
        assert (tmp_path / file_name("S1", kind)).stat().st_size > 10_000


def test_the_readme_counts_right() -> None:
    """The scenes in a word, the samples in figures."""
    text = " ".join((Path(__file__).parents[2] / "README.md").read_text(encoding="utf-8").split())
    number = {8: "eight", 9: "nine", 10: "ten"}[len(SCENES)]
    assert f"renders the same {number} scenes" in text
    assert f"error at {SPP[0]} to {SPP[-1]} samples per pixel" in text
