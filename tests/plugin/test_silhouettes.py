"""Gradients of an image with respect to the light's place, which the sampling of its silhouette gives."""

import drjit as dr
import mitsuba as mi
import numpy as np
import pytest

START = (0.0, 0.0, 1.5)


@pytest.fixture(autouse=True)
def llvm_ad_rgb():
    """The one variant that is enough: the silhouette is the sphere's, the kernel does not see it."""
    mi.set_variant("llvm_ad_rgb")


def scene(emitter, integrator):
    """A floor, lit by a sphere out of sight."""
    film = {"type": "hdrfilm", "width": 8, "height": 6, "rfilter": {"type": "box"}}
    look = mi.ScalarTransform4f().look_at([0.5, -2, 2], [0.5, -0.9, 0], [0, 0, 1])
    return mi.load_dict(
        {
            "type": "scene",
            "integrator": integrator,
            "sensor": {"type": "perspective", "fov": 40, "to_world": look, "film": film},
            "floor": {"type": "rectangle", "to_world": mi.ScalarTransform4f().scale(8)},
            "light": {
                "type": "sphere",
                "radius": 0.5,
                "center": START,
                "emitter": {"type": emitter, "radiance": {"type": "rgb", "value": 1.0}},
            },
        }
    )


def move(params, axis, distance):
    """Move the light along an axis."""
    place = list(START)
    place[axis] = START[axis] + distance
    params["light.to_world"] = mi.Transform4f().translate(place) @ mi.Transform4f().scale(0.5)
    params.update()


def gradients(emitter, axis, seeds):
    """Return the derivative of the image's mean, once per seed.

    Guiding would take a minute to compile, and changes the noise only.
    """
    integrator = {"type": "direct_projective", "sppc": 16, "sppp": 0, "sppi": 4096, "guiding": "none"}
    results = []
    for seed in seeds:
        loaded = scene(emitter, integrator)
        params = mi.traverse(loaded)
        distance = mi.Float(0.0)
        dr.enable_grad(distance)
        move(params, axis, distance)
        dr.backward(dr.mean(mi.render(loaded, params, spp=0, seed=seed).array))
        results.append(dr.grad(distance)[0])
    return np.array(results)


def difference(axis, step=0.02):
    """Return the same by central differences: of order (step / 1.5)^2 off, and nearly without noise."""
    loaded = scene("spherecap", {"type": "direct", "emitter_samples": 1, "bsdf_samples": 0})
    params = mi.traverse(loaded)
    ends = []
    for distance in (step, -step):
        move(params, axis, distance)
        ends.append(np.mean(np.array(mi.render(loaded, spp=4096, seed=1)), dtype=np.float64))
    return (ends[0] - ends[1]) / (2 * step)


@pytest.mark.parametrize("axis", [0, 2])
def test_moving_the_light_changes_the_image_as_differences_say(axis):
    """Sideways and up, against differences and against `area`."""
    ours = gradients("spherecap", axis, range(4))
    theirs = gradients("area", axis, range(4, 8))
    reference = difference(axis)
    for found in (ours, theirs):
        error = found.std(ddof=1) / np.sqrt(len(found))
        # Four values: 6 of their standard errors are beyond 1 in 100 only.
        assert abs(found.mean() - reference) < 6 * error + 2e-3 * abs(reference)
        # A test that could not tell a gradient from none, or from one of the other sign, would be none.
        assert 6 * error < 0.5 * abs(reference)
