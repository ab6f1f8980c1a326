"""The methods of the emitter, in every scalar variant: to the bit what `area` does, but for the samples."""

import mitsuba as mi
import numpy as np
import pytest
from lights import array, light, point

RADIANCES = {
    "constant": 2.5,
    "rgb": {"type": "rgb", "value": [0.5, 1.0, 2.0]},
    "d65": {"type": "d65"},
    "spectrum": {"type": "spectrum", "value": [(400, 1.0), (700, 2.0)]},
}

# One of each case: wholly above the horizon, cut with its centre above, cut with its centre below; and a
# point in a medium.
NORMALS = {
    "above": (0, 0, 1),
    "centre above": (np.sqrt(1 - 0.1**2), 0, 0.1),
    "centre below": (np.sqrt(1 - 0.2**2), 0, -0.2),
    "medium": (0, 0, 0),
}


@pytest.fixture(params=RADIANCES)
def radiance(request):
    """Some spectra."""
    return RADIANCES[request.param]


def pair(radiance, **parameters):
    """The emitter, and the built-in one that it replaces."""
    ours = light("spherecap", radiance=radiance, **parameters)
    theirs = light("area", radiance=radiance)
    return ours, theirs


def surface_point(cosine):
    """A point of the light's surface, seen under this cosine."""
    si = point((0, 0, 2), (0, 0, -1))
    si.sh_frame = mi.Frame3f([0, 0, -1])
    si.wi = [np.sqrt(1 - cosine**2), 0, cosine]
    return si


@pytest.mark.parametrize("cosine", [1.0, 0.3, 1e-3, 0.0, -1e-3, -1.0])
def test_eval(variant, radiance, cosine):
    """Light leaves outwards only."""
    ours, theirs = pair(radiance)
    si = surface_point(cosine)
    value = array(ours.emitter().eval(si))
    assert np.array_equal(value, array(theirs.emitter().eval(si)))
    assert (value.max() > 0) == (cosine > 0)


def test_sample_ray(variant, radiance):
    """The same rays as those of `area`."""
    ours, theirs = pair(radiance)
    rng = np.random.default_rng(1)
    for _ in range(20):
        samples = (0.5, rng.random(), list(rng.random(2)), list(rng.random(2)))
        ray, weight = ours.emitter().sample_ray(*samples)
        expected_ray, expected_weight = theirs.emitter().sample_ray(*samples)
        assert np.array_equal(array(ray.o), array(expected_ray.o))
        assert np.array_equal(array(ray.d), array(expected_ray.d))
        assert np.array_equal(array(ray.wavelengths), array(expected_ray.wavelengths))
        assert ray.time == 0.5
        assert np.array_equal(array(weight), array(expected_weight))
        assert array(weight).max() > 0


def test_sample_position(variant):
    """The same positions."""
    ours, theirs = pair(1.0)
    for sample in ([0.2, 0.7], [0.0, 0.0], [0.9, 0.1]):
        ps, weight = ours.emitter().sample_position(0.25, sample)
        expected, expected_weight = theirs.emitter().sample_position(0.25, sample)
        for field in ("p", "n", "uv", "time", "pdf", "delta"):
            assert np.array_equal(array(getattr(ps, field)), array(getattr(expected, field))), field
        assert weight == expected_weight
        assert weight == pytest.approx(4 * np.pi, rel=1e-6)


def test_sample_wavelengths(variant, radiance):
    """The same wavelengths."""
    ours, theirs = pair(radiance)
    for sample in (0.0, 0.3, 0.99):
        wavelengths, weight = ours.emitter().sample_wavelengths(surface_point(1.0), sample)
        expected_wavelengths, expected = theirs.emitter().sample_wavelengths(surface_point(1.0), sample)
        assert np.array_equal(array(wavelengths), array(expected_wavelengths))
        assert np.array_equal(array(weight), array(expected))


@pytest.mark.parametrize("technique", ["projected", "projected_bounded", "solid_angle"])
@pytest.mark.parametrize("hemispheres", ["front", "both"])
@pytest.mark.parametrize("normal", NORMALS)
def test_sample_direction(variant, technique, hemispheres, normal):
    """All fields of a sample agree with each other, and with the density that is asked for it."""
    center, radius = np.array([0.5, -0.25, 3.0]), 1.25
    ours, theirs = (
        light(name, center, radius, 2.0, **parameters)
        for name, parameters in {
            "spherecap": dict(technique=technique, hemispheres=hemispheres, defensive=0.25),
            "area": {},
        }.items()
    )
    emitter = ours.emitter()
    it = point((0.1, 0.2, 0.3), NORMALS[normal], time=0.75)
    rng = np.random.default_rng(2)
    for _ in range(50):
        ds, weight = emitter.sample_direction(it, mi.Point2f(rng.random(2)))
        p, n, d = array(ds.p), array(ds.n), array(ds.d)
        assert ds.pdf > 0
        assert np.linalg.norm(n) == pytest.approx(1, abs=3e-7)
        assert np.linalg.norm(d) == pytest.approx(1, abs=3e-7)
        # The point is on the sphere, on the side that is seen, in the claimed direction and distance.
        assert np.linalg.norm(p - center) == pytest.approx(radius, rel=3e-7)
        assert p == pytest.approx(center + radius * n, abs=1e-6)
        assert np.dot(d, n) < 0
        assert array(it.p) + ds.dist * d == pytest.approx(p, abs=2e-6)
        assert ds.time == 0.75
        assert not ds.delta
        assert array(ds.uv) == pytest.approx([0, 0])
        assert ds.emitter == emitter

        # A unit vector in single precision resolves 6e-8, which counts where the cosine is small.
        cosine = abs(np.dot(d, array(it.n))) if normal != "medium" else 1.0
        assert emitter.pdf_direction(it, ds) == pytest.approx(ds.pdf, rel=1e-5 + 1e-6 / cosine)
        value = array(emitter.eval_direction(it, ds))
        assert np.array_equal(value, array(theirs.emitter().eval_direction(it, ds)))
        assert value.max() > 0
        assert array(weight) * ds.pdf == pytest.approx(value, rel=1e-6)


@pytest.mark.parametrize("technique", ["projected", "projected_bounded", "solid_angle"])
def test_random_numbers_at_the_ends(scalar_rgb, technique):
    """Mitsuba reuses random numbers: they may be exactly 0 or 1, or miss [0, 1] by a rounding error."""
    for normal in NORMALS.values():
        emitter = light(technique=technique, hemispheres="both", defensive=0.125).emitter()
        for u in (-1e-7, 0.0, 1.0 - 2.0**-24, 1.0, 1.0 + 1e-7):
            for v in (-1e-7, 0.0, 1.0 - 2.0**-24, 1.0, 1.0 + 1e-7):
                ds, weight = emitter.sample_direction(point(normal=normal), [u, v])
                assert np.isfinite(array(ds.d)).all()
                assert np.linalg.norm(array(ds.p) - [0, 0, 3]) == pytest.approx(1, rel=1e-6)
                assert np.isfinite(array(weight)).all()


def test_solid_angle_has_the_density_of_area(scalar_rgb):
    """To the precision of the built-in one."""
    ours, theirs = light(technique="solid_angle"), light("area")
    for normal in NORMALS.values():
        it = point((0.3, 0.2, 0.1), normal)
        ds, _ = ours.emitter().sample_direction(it, [0.3, 0.6])
        # The built-in density is a difference of two nearly equal numbers.
        assert ds.pdf == pytest.approx(theirs.emitter().pdf_direction(it, ds), rel=1e-5)
        assert ours.emitter().pdf_direction(it, ds) == pytest.approx(ds.pdf, rel=1e-5)


def test_projected_cancels_the_cosine(scalar_rgb):
    """What the emitter is for: cosine / density is the same for every sample, the projected solid angle."""
    for name, normal in NORMALS.items():
        if name == "medium":
            continue
        emitter = light(technique="projected", hemispheres="front", defensive=0.0).emitter()
        it = point(normal=normal)
        rng = np.random.default_rng(3)
        estimates = []
        for _ in range(500):
            ds, weight = emitter.sample_direction(it, mi.Point2f(rng.random(2)))
            estimates.append(array(weight)[0] * np.dot(array(ds.d), normal))
        assert np.std(estimates) < 1e-4 * np.mean(estimates), name


def test_inside_the_sphere(variant):
    """The light emits outwards, so points inside get nothing, as with `area`."""
    ours, theirs = pair(1.0)
    for position in ((0, 0, 3), (0.5, 0.2, 3.3), (0, 0, 2.1)):
        it = point(position)
        ds, weight = ours.emitter().sample_direction(it, [0.3, 0.4])
        assert ds.pdf == 0
        assert array(weight).max() == 0
        _, weight = theirs.emitter().sample_direction(it, [0.3, 0.4])
        assert array(weight).max() == 0

        # A direction towards the sphere from inside meets it from behind.
        ds.d, ds.n, ds.dist = mi.Vector3f(0, 0, 1), mi.Normal3f(0, 0, 1), 0.5
        assert ours.emitter().pdf_direction(it, ds) == 0
        assert array(ours.emitter().eval_direction(it, ds)).max() == 0


def test_samples_of_the_edge_count(scalar_rgb):
    """There the normal is perpendicular to the direction, and by rounding faces away now and then."""
    emitter = light(technique="solid_angle").emitter()
    faces_away = 0
    for i in range(500):
        it = point((0.006 * i, -0.004 * i, 0.002 * i))
        ds, weight = emitter.sample_direction(it, (i / 500, i % 2))
        cosine = np.dot(array(ds.d), array(ds.n))
        assert abs(cosine) < 1e-3
        faces_away += cosine >= 0
        assert emitter.pdf_direction(it, ds) == pytest.approx(ds.pdf, rel=1e-5)
        assert array(emitter.eval_direction(it, ds)) == pytest.approx(array(weight) * ds.pdf, rel=1e-6)
    assert faces_away > 0


@pytest.mark.parametrize(
    ("hemispheres", "defensive", "lit"),
    [
        ("front", 0.0, False),
        ("both", 0.0, True),
        # A shading normal may see what the geometric normal does not.
        ("front", 0.125, True),
    ],
)
def test_below_the_horizon(scalar_rgb, hemispheres, defensive, lit):
    """A light that is wholly below the horizon."""
    emitter = light(hemispheres=hemispheres, defensive=defensive).emitter()
    it = point(normal=(0, 0, -1))
    ds, weight = emitter.sample_direction(it, [0.3, 0.4])
    assert (ds.pdf > 0) == lit
    assert (array(weight).max() > 0) == lit
    if lit:
        assert emitter.pdf_direction(it, ds) == pytest.approx(ds.pdf, rel=1e-5)


def test_front_has_no_density_below_the_horizon(scalar_rgb):
    """A sample there would be weighted by infinity."""
    normal = NORMALS["centre above"]
    emitter = light(hemispheres="front", defensive=0.0).emitter()
    it = point(normal=normal)
    ds = mi.DirectionSample3f()
    below = np.array([-0.2, 0, 1]) / np.linalg.norm([-0.2, 0, 1])
    assert np.dot(below, normal) < 0
    ds.d, ds.n = mi.Vector3f(below), mi.Normal3f(-below)
    assert emitter.pdf_direction(it, ds) == 0


def test_position_in_the_scene(variant):
    """What the scene asks of an emitter."""
    ours, theirs = pair(1.0)
    assert ours.emitter().bbox() == theirs.emitter().bbox() == ours.bbox()
    assert ours.emitter().flags() == theirs.emitter().flags() == mi.EmitterFlags.Surface
    assert ours.emitter().get_shape() == ours
    assert ours.emitter().sampling_weight() == 1.0
    assert not ours.emitter().is_environment()


def test_medium(scalar_rgb):
    """An emitter may name the medium that surrounds it."""
    sphere = mi.load_dict(
        {
            "type": "sphere",
            "emitter": {"type": "spherecap", "medium": {"type": "homogeneous"}},
        }
    )
    assert "HomogeneousMedium" in str(sphere.emitter())


def test_to_string(variant):
    """The text shows what is sampled."""
    text = str(light(technique="projected_bounded", hemispheres="both", defensive=0.5).emitter())
    for line in (
        "technique = projected_bounded",
        "hemispheres = both,",
        "defensive = 0.5,",
        "sphere = [center = [0, 0, 3], radius = 1]",
    ):
        assert line in text
    assert text.startswith("SphereCap[")


def test_traverse_radiance(variant):
    """The radiance can be changed under the names that `area` has."""
    ours, theirs = pair({"type": "rgb", "value": [1, 1, 1]})
    params = mi.traverse(ours)
    assert {key for key, _ in params} == {key for key, _ in mi.traverse(theirs)}
    if mi.is_spectral:
        return
    params["emitter.radiance.value"] = [0.5, 0.25, 0.125]
    params.update()
    ds, weight = ours.emitter().sample_direction(point(), [0.3, 0.4])
    value = array(mi.unpolarized_spectrum(weight)) * ds.pdf
    assert value == pytest.approx([0.5, 0.25, 0.125], rel=1e-6)


def test_move_through_traverse(variant):
    """A light that was moved and scaled samples as a new one does at its new place, to the bit."""
    moved = light(center=(0, 0, 3), radius=1.0, technique="projected")
    ds, _ = moved.emitter().sample_direction(point(), [0.3, 0.4])
    assert np.linalg.norm(array(ds.p) - [0, 0, 3]) == pytest.approx(1.0, rel=1e-6)

    params = mi.traverse(moved)
    params["to_world"] = mi.Transform4f().translate([1, 2, 5]).scale(2)
    params.update()
    fresh = light(center=(1, 2, 5), radius=2.0, technique="projected")
    for sample in ([0.3, 0.4], [0.9, 0.1]):
        ds, weight = moved.emitter().sample_direction(point(), sample)
        expected, expected_weight = fresh.emitter().sample_direction(point(), sample)
        assert np.linalg.norm(array(ds.p) - [1, 2, 5]) == pytest.approx(2.0, rel=1e-6)
        for field in ("p", "n", "d", "dist", "pdf"):
            assert np.array_equal(array(getattr(ds, field)), array(getattr(expected, field))), field
        assert np.array_equal(array(weight), array(expected_weight))
        assert moved.emitter().pdf_direction(point(), ds) == fresh.emitter().pdf_direction(point(), ds)
    assert moved.emitter().bbox() == fresh.emitter().bbox()


def test_move_in_a_scene(scalar_rgb):
    """Moved, turned and scaled at once."""
    scene = mi.load_dict(
        {
            "type": "scene",
            "light": {"type": "sphere", "center": [0, 0, 3], "emitter": {"type": "spherecap"}},
            "floor": {"type": "rectangle"},
        }
    )
    params = mi.traverse(scene)
    params["light.to_world"] = mi.Transform4f().translate([0, 0, 7]).rotate([0.6, 0, 0.8], 40).scale(0.5)
    params.update()
    ds, _ = scene.sample_emitter_direction(point(), [0.3, 0.4], True)
    assert np.linalg.norm(array(ds.p) - [0, 0, 7]) == pytest.approx(0.5, rel=1e-6)
    assert scene.pdf_emitter_direction(point(), ds) == pytest.approx(ds.pdf, rel=1e-5)


def test_a_rotated_sphere_samples_alike(scalar_rgb):
    """A sphere looks the same from all sides."""
    rotated = mi.load_dict(
        {
            "type": "sphere",
            "to_world": mi.ScalarTransform4f().translate([0, 0, 3]).rotate([0.6, 0.8, 0], 77).scale(1.5),
            "emitter": {"type": "spherecap"},
        }
    )
    straight = light(radius=1.5)
    ds, _ = rotated.emitter().sample_direction(point(), [0.3, 0.4])
    expected, _ = straight.emitter().sample_direction(point(), [0.3, 0.4])
    assert array(ds.d) == pytest.approx(array(expected.d), abs=1e-6)
    assert ds.pdf == pytest.approx(expected.pdf, rel=1e-5)
