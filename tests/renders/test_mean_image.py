"""Same picture: mean images against the built-in emitter, and against the analytic answer where there is one.

Every test also turns down a copy that is 1 % too dark, so that passing means something.
"""

import numpy as np
import pytest
from gallery import Gallery, image_mean
from plan import PLANS, SIGNIFICANCE, Plan
from renderlab.estimate import Estimate, p_values, sidak
from renderlab.floor_reference import FLOOR_SCENES
from renderlab.pictures import save_failure
from renderlab.scenes import OUTPUT

COMPARABLE = [plan for plan in PLANS if plan.built_in_is_right]
# Light sampling alone: rays that the BSDF samples start a little above the floor and see more of the light.
ANALYTIC = [plan for plan in PLANS if plan.scene in FLOOR_SCENES and not plan.parameters]


def by_name(plan: Plan) -> str:
    """Name a test after its plan."""
    return plan.name


def check(
    plan: Plan, gallery: Gallery, ours: Estimate, reference: Estimate, mask: np.ndarray
) -> tuple[float, float]:
    """Compare per pixel where mask is true; save the images on failure.

    Return the corrected p-value, and that of a dimmed copy.
    """
    p = p_values(ours, reference)
    corrected = sidak(p[mask])
    if corrected < SIGNIFICANCE:
        folder = OUTPUT / "renders" / plan.name / gallery.variant
        save_failure(folder, ours.mean, reference.mean, np.where(mask[..., None], p, 1.0))
        pytest.fail(
            f"images differ: p = {corrected:.2g} over {p[mask].size} values; see {folder}", pytrace=False
        )
    dimmed = sidak(p_values(ours.dimmed(), reference)[mask])
    assert dimmed < SIGNIFICANCE, f"too noisy to tell a copy that is 1 % too dark (p = {dimmed:.2g})"
    return corrected, dimmed


@pytest.mark.parametrize("plan", COMPARABLE, ids=by_name)
def test_equals_built_in_per_pixel(plan: Plan, gallery: Gallery, record) -> None:
    """Z-test per pixel and channel."""
    ours = Estimate.from_stack(gallery.precise(plan, ours=True))
    built_in = Estimate.from_stack(gallery.precise(plan, ours=False))
    everywhere = np.ones(ours.mean.shape[:2], dtype=bool)
    p, dimmed = check(plan, gallery, ours, built_in, everywhere)
    record(plan.name, **{"p pixels": p, "dimmed": dimmed})


@pytest.mark.parametrize("plan", COMPARABLE, ids=by_name)
def test_equals_built_in_in_the_mean(plan: Plan, gallery: Gallery, record) -> None:
    """Z-test of the mean of the whole image, per channel."""
    ours = image_mean(gallery.precise(plan, ours=True))
    built_in = image_mean(gallery.precise(plan, ours=False))
    p = sidak(p_values(ours, built_in))
    dimmed = sidak(p_values(ours.dimmed(), built_in))
    record(plan.name, **{"p mean": p, "dimmed, mean": dimmed})
    assert p >= SIGNIFICANCE, f"means differ: {ours.mean} against {built_in.mean}, p = {p:.2g}"
    assert dimmed < SIGNIFICANCE, f"too noisy to tell a copy that is 1 % too dark (p = {dimmed:.2g})"


@pytest.mark.parametrize("plan", ANALYTIC, ids=by_name)
def test_equals_analytic_answer(plan: Plan, gallery: Gallery, record) -> None:
    """Z-test per pixel against a reference without noise."""
    ours = Estimate.from_stack(gallery.precise(plan, ours=True))
    _, reference, trusted = gallery.floor(plan, plan.width, plan.height)
    assert trusted.mean() > 0.5, "most pixels can be compared"
    p, dimmed = check(plan, gallery, ours, Estimate.exact(reference), trusted)
    record(plan.name, **{"p analytic": p, "dimmed, analytic": dimmed})
