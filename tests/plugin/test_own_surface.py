"""A light does not light itself, and lights what touches it."""

import drjit as dr
import mitsuba as mi
import numpy as np
import pytest
from lights import light, point

VARIANTS = ["scalar_rgb", "llvm_ad_rgb"]


@pytest.fixture(params=VARIANTS, autouse=True)
def variant(request):
    """Points of a sphere are found and rounded in two ways."""
    mi.set_variant(request.param)


@pytest.mark.parametrize("integrator", ["direct", "path", "volpath", "volpathmis"])
@pytest.mark.parametrize(
    ("center", "radius", "distance"),
    [((0.1, 0, 0.2), 0.5, 4), ((0.1, 0, 0.2), 0.5, 4e3), ((-30, 2e3, 70), 0.7, 40), ((0, 0, 0), 2e-3, 0.003)],
)
def test_a_frosted_light_shows_its_radiance(integrator, center, radius, distance):
    """Alone in the world, and though its surface scatters light from everywhere.

    Every pixel: `area`'s are 2.01 to 9 in the mean for 2, or NaN.
    """
    center = np.array(center)
    look = mi.ScalarTransform4f().look_at(
        origin=(center - [0, distance, 0]).tolist(), target=center.tolist(), up=[0, 0, 1]
    )
    scene = mi.load_dict(
        {
            "type": "scene",
            "integrator": {"type": integrator},
            "sensor": {
                "type": "perspective",
                "near_clip": distance * 1e-3,
                "far_clip": distance * 10,
                # What is seen is well within the light.
                "fov": 2 * np.degrees(np.arctan(0.6 * radius / distance)),
                "to_world": look,
                "film": {"type": "hdrfilm", "width": 16, "height": 16, "rfilter": {"type": "box"}},
            },
            "light": {
                "type": "sphere",
                "center": center.tolist(),
                "radius": radius,
                "bsdf": {"type": "roughdielectric", "alpha": 0.3},
                "emitter": {"type": "spherecap", "radiance": {"type": "rgb", "value": 2.0}},
            },
        }
    )
    image = np.array(mi.render(scene, spp=16))
    np.testing.assert_allclose(image, 2.0, rtol=1e-6)


def interactions(sphere, count, farthest):
    """Points where rays from everywhere, up to some distance, meet a sphere of radius 1 at the origin."""
    scene = mi.load_dict({"type": "scene", "sphere": sphere})
    rng = np.random.default_rng(1)
    far, near = rng.standard_normal((2, count, 3))
    near /= np.linalg.norm(near, axis=1, keepdims=True)
    far *= 10 ** rng.uniform(0.5, np.log10(farthest), (count, 1)) / np.linalg.norm(far, axis=1, keepdims=True)
    way = (near - far) / np.linalg.norm(near - far, axis=1, keepdims=True)
    if dr.is_jit_v(mi.Float):
        rays = mi.Ray3f(mi.Point3f(far.T), mi.Vector3f(way.T))
        return [scene.ray_intersect(rays)]
    return [scene.ray_intersect(mi.Ray3f(o, d)) for o, d in zip(far, way, strict=True)]


def test_its_own_points_have_no_samples_and_no_density():
    """Wherever a ray has found them."""
    sphere = light(center=(0, 0, 0), hemispheres="both")
    count = 100_000 if dr.is_jit_v(mi.Float) else 1000
    found = interactions(sphere, count, 1000)
    assert sum(np.count_nonzero(si.is_valid()) for si in found) > 0.9 * count
    for si in found:
        ds, weight = sphere.emitter().sample_direction(si, mi.Point2f(0.3, 0.4))
        assert dr.all((ds.pdf == 0) & (weight.x == 0))
        inwards = mi.DirectionSample3f()
        inwards.d, inwards.n = -si.n, si.n
        assert dr.all(sphere.emitter().pdf_direction(si, inwards) == 0)


@pytest.mark.parametrize("side", [1e-5, 1e-4, 1e-3, 1e-2, 1])
def test_a_floor_that_it_touches_from_below_is_lit(side):
    """All of it but the touching point, to the rounding of places: there is no dark spot."""
    sphere = light(center=(0, 0, -1), hemispheres="both")
    for angle in np.linspace(0, 6, 7):
        it = point((side * np.cos(angle), side * np.sin(angle), 0))
        it.t = 10
        ds, weight = sphere.emitter().sample_direction(it, mi.Point2f(0.3, 0.4))
        assert dr.all((ds.pdf > 0) & (weight.x > 0))
        assert dr.all(sphere.emitter().pdf_direction(it, ds) > 0)


@pytest.mark.parametrize("gap", [1e-4, 1e-2, 1])
def test_a_globe_around_it_is_lit_from_within(gap):
    """The normals of its points, too, have the centre exactly below them.

    From not too far away: rays of length 1000 find points to 1e-4 only.
    """
    sphere = light(center=(0, 0, 0), hemispheres="both")
    globe = mi.load_dict({"type": "sphere", "radius": 1 + gap})
    for si in interactions(globe, 1000 if dr.is_jit_v(mi.Float) else 100, 10):
        ds, weight = sphere.emitter().sample_direction(si, mi.Point2f(0.3, 0.4))
        assert dr.all((si.t == np.inf) | ((ds.pdf > 0) & (weight.x > 0)))
