"""Lights of all sizes down to a millionth of their distance: the image is the analytic answer.

The built-in emitter is wrong from about 1/300 on (see test_built_in_error.py): it is no reference here.
"""

import pytest
from gallery import Gallery
from plan import SEEDS, SIGNIFICANCE
from renderlab.estimate import Estimate, p_values, sidak
from renderlab.floor_reference import read_floor_scene, reference_image, trusted_pixels
from renderlab.scenes import load_scene, render_stack
from spherecap_command.scene import OURS

SCENE = "tiny_far_light"
# Distance from the floor to the light's centre, scene units; scenes/tiny_far_light.xml.
HEIGHT = 1500


@pytest.mark.parametrize("inverse_sine", [1000, 5000, 20000, 1_000_000])
def test_equals_analytic_answer(inverse_sine: int, gallery: Gallery) -> None:
    """Z-test per pixel for a light of angular radius asin(1/inverse_sine) above the floor."""
    # Radiance goes with 1/radius^2, so that the floor keeps its brightness.
    lamp = {"radius": HEIGHT / inverse_sine, "radiance": inverse_sine**2 / 9}
    view = {"width": 16, "height": 12}
    scene = load_scene(SCENE, OURS, sampler="multijitter", **lamp, **view)
    ours = Estimate.from_stack(render_stack(scene, 16, range(1, SEEDS + 1)))
    floor = read_floor_scene(SCENE, **lamp, **view)
    reference = Estimate.exact(reference_image(floor))
    trusted = trusted_pixels(floor)
    p = sidak(p_values(ours, reference)[trusted])
    assert p >= SIGNIFICANCE, f"images differ: p = {p:.2g}"
    dimmed = sidak(p_values(ours.dimmed(), reference)[trusted])
    assert dimmed < SIGNIFICANCE, f"too noisy to tell a copy that is 1 % too dark (p = {dimmed:.2g})"
