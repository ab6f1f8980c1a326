"""`spherecap.sun` gives the irradiance that it is asked for, however small the sun; `area` does not."""

import math

import mitsuba as mi
import numpy as np
import pytest
import spherecap
from spherecap_command.scene import BUILT_IN, use_variant

IRRADIANCE = 1000.0
REFLECTANCE = 0.5
LIGHTS_ALONE = {"type": "direct", "bsdf_samples": 0}
DIRECTION = (2.0, -1.0, 2.0)
COSINE = 2 / 3  # with the floor's normal

# The direction towards a sun differs by 1e-6 over the scene, its irradiance by twice that; rounding adds
# less.
TOLERANCE = 1e-5


def world(integrator: dict, **more: dict) -> dict:
    """A floor that a camera sees from above, away from the origin."""
    return {
        "type": "scene",
        "integrator": integrator,
        "sensor": {
            "type": "perspective",
            "fov": 30,
            "to_world": mi.ScalarTransform4f().look_at(origin=[50, 20, 8], target=[50, 20, 0], up=[0, 1, 0]),
            "film": {
                "type": "hdrfilm",
                "width": 8,
                "height": 8,
                "component_format": "float32",
                "rfilter": {"type": "box"},
            },
        },
        "floor": {
            "type": "rectangle",
            "to_world": mi.ScalarTransform4f().translate([50, 20, 0]).scale(3),
            "bsdf": {"type": "diffuse", "reflectance": {"type": "rgb", "value": REFLECTANCE}},
        },
        **more,
    }


def rendered(degrees: float, integrator: dict, emitter: str = "spherecap") -> np.ndarray:
    """Return the floor under a sun, relative to the analytic answer."""
    scene = world(integrator)
    # Numbers as numpy has them, too.
    light = spherecap.sun(np.float32(DIRECTION), degrees, np.float32(IRRADIANCE), mi.load_dict(scene))
    light["emitter"]["type"] = emitter
    image = np.array(mi.render(mi.load_dict({**scene, "sun": light}), spp=16, seed=1), dtype=np.float64)
    return image / (IRRADIANCE * COSINE * REFLECTANCE / math.pi)


@pytest.fixture(params=["scalar_rgb", "llvm_ad_rgb"])
def any_variant(request: pytest.FixtureRequest) -> None:
    """One point at a time, and many."""
    use_variant(request.param)


# All above the floor: at 80 degrees the lowest point of the disc is 1.8 degrees above it.
@pytest.mark.parametrize("degrees", [1e-4, 1e-3, 0.01, 0.05, 0.533, 5, 40, 80])
def test_a_sun_gives_its_irradiance(any_variant: None, degrees: float) -> None:
    """In every pixel, at every size."""
    np.testing.assert_allclose(rendered(degrees, LIGHTS_ALONE), 1, rtol=TOLERANCE)


def test_a_sun_in_a_path_tracer(any_variant: None) -> None:
    """BSDF samples hardly ever meet it, and if they do its density is the right one."""
    path = {"type": "path", "max_depth": 3}
    np.testing.assert_allclose(rendered(0.533, path), 1, rtol=TOLERANCE)
    # Weighted against each other, samples are as good as light samples alone where both are rare.
    wide = rendered(40, path)
    deviation = wide.std() / math.sqrt(wide.size)
    assert abs(wide.mean() - 1) < 5 * deviation + TOLERANCE


def test_the_story_of_area(any_variant: None) -> None:
    """What the pages say of it: it rounds a cosine that is almost 1."""
    for degrees, error in ((0.533, 0.003), (0.05, 0.25)):
        assert rendered(degrees, LIGHTS_ALONE, BUILT_IN).mean() - 1 == pytest.approx(error, rel=0.15)
    assert np.all(rendered(0.02, LIGHTS_ALONE, BUILT_IN) > 0)
    assert not np.any(rendered(0.0195, LIGHTS_ALONE, BUILT_IN))


def test_a_sun_has_a_colour_and_a_disc(scalar_rgb: None) -> None:
    """Three numbers are red, green and blue; who looks at it sees its radiance."""
    scene = world({"type": "direct"})
    irradiance = np.array([1.0, 2.0, 3.0])
    light = spherecap.sun([0, 0, -4], 0.533, irradiance.tolist(), mi.load_dict(scene))
    scene["sensor"]["to_world"] = mi.ScalarTransform4f().look_at(
        origin=[50, 20, -1], target=[50, 20, -2], up=[0, 1, 0]
    )
    scene["sensor"] |= {"fov": 0.3, "far_clip": 1e9}
    image = np.array(mi.render(mi.load_dict({**scene, "sun": light}), spp=4))
    radiance = irradiance / (math.pi * math.sin(math.radians(0.533 / 2)) ** 2)
    np.testing.assert_allclose(image, np.broadcast_to(radiance, image.shape), rtol=1e-6)


def test_a_sun_throws_the_shadow_of_a_ball(scalar_rgb: None) -> None:
    """From straight above, as large as the ball, which is behind the camera."""
    ball = {"type": "sphere", "center": [50, 20, 1000], "radius": 0.5}
    scene = world(LIGHTS_ALONE, ball=ball)
    light = spherecap.sun([0, 0, 1], 1e-3, 1, mi.load_dict(scene))
    image = np.array(mi.render(mi.load_dict({**scene, "sun": light}), spp=64, seed=1))[..., 0]
    side = 2 * 8 * math.tan(math.radians(15))  # of what the camera sees
    shadow = 1 - image.mean() / image.max()
    # 4096 samples, of which 4.3 % are in the shadow: their share has a standard deviation of 8 %.
    assert shadow == pytest.approx(math.pi * 0.5**2 / side**2, rel=0.4)


@pytest.mark.parametrize(
    ("direction", "degrees", "message"),
    [
        ([0, 0, 0], 1, "The direction towards the sun is three numbers, not all 0"),
        ([0, 1], 1, "three numbers"),
        ([0, math.nan, 1], 1, "three numbers"),
        ([0, 0, 1], 5e-5, "1e-4 to 179 degrees large, not 5e-05"),
        ([0, 0, 1], 180, "1e-4 to 179 degrees"),
        ([0, 0, 1], math.nan, "1e-4 to 179 degrees"),
    ],
)
def test_mistakes_are_explained(
    scalar_rgb: None, direction: list[float], degrees: float, message: str
) -> None:
    """In a sentence."""
    with pytest.raises(ValueError, match=message):
        spherecap.sun(direction, degrees, 1, mi.load_dict(world(LIGHTS_ALONE)))


@pytest.mark.parametrize("irradiance", [-1, [1, 2], math.inf])
def test_wrong_irradiances_are_explained(scalar_rgb: None, irradiance: float | list[float]) -> None:
    """In a sentence, too."""
    with pytest.raises(ValueError, match="one number from 0, or three"):
        spherecap.sun([0, 0, 1], 1, irradiance, mi.load_dict(world(LIGHTS_ALONE)))


def test_an_empty_scene_is_explained(scalar_rgb: None) -> None:
    """There is nothing to be far away from."""
    with pytest.raises(ValueError, match="no shapes that a sun could light"):
        spherecap.sun([0, 0, 1], 1, 1, mi.load_dict({"type": "scene"}))
