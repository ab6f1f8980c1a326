"""Derivatives of images with respect to all that a light and its surroundings are made of.

References are central differences of images, which our emitter renders nearly without noise. Nothing covers
anything in them, so no edge moves but the light's own outline, as sampled BSDFs see it. (Silhouettes are the
projective integrators': test_silhouettes.py.)
"""

import functools

import drjit as dr
import mitsuba as mi
import numpy as np
import pytest

#: The light's centre and radius: in full view of the floor, cut by its horizon, and mostly below it.
PLACES = {
    "above": ((3.5, 0.5, 2.5), 0.7),
    "cut": ((2.6, 0.3, 0.3), 0.7),
    "sunken": ((2.6, 0.5, -0.2), 0.7),
}
#: Lights beside it, which stay as they are.
OTHERS = [((-4.0, -2.0, 3.0), 0.5), ((-4.0, 2.0, 3.0), 0.5)]
#: What is moved or changed, from 0, and by how much for a difference.
STEPS = {"floor": 0.01, "x": 0.01, "z": 0.01, "radius": 0.01, "radiance": 0.05, "albedo": 0.05}
EMITTER_ALONE = {"type": "direct", "bsdf_samples": 0, "emitter_samples": 1}


@pytest.fixture(autouse=True)
def llvm_ad_rgb():
    """Every test that does not say otherwise."""
    mi.set_variant("llvm_ad_rgb")
    yield
    mi.set_variant("llvm_ad_rgb")


def scene(place, integrator, emitter="spherecap", lights=1, **parameters):
    """A floor, seen from above, and lights that are out of sight: the first is the one that changes."""
    description = {
        "type": "scene",
        "integrator": integrator,
        "sensor": {
            "type": "perspective",
            "fov": 30,
            "to_world": mi.ScalarTransform4f().look_at(origin=[0, -0.01, 6], target=[0, 0, 0], up=[0, 0, 1]),
            "film": {"type": "hdrfilm", "width": 8, "height": 8, "rfilter": {"type": "box"}},
        },
        "floor": {
            "type": "rectangle",
            "to_world": mi.ScalarTransform4f().scale(50),
            "bsdf": {"type": "diffuse", "reflectance": {"type": "rgb", "value": 0.5}},
        },
    }
    for i, (center, radius) in enumerate([place, *OTHERS][:lights]):
        description[f"light{i}"] = {
            "type": "sphere",
            "to_world": mi.ScalarTransform4f().translate(center).scale(radius),
            "emitter": {"type": emitter, "radiance": {"type": "rgb", "value": 10.0}, **parameters},
        }
    return mi.load_dict(description)


def change(params, place, changes):
    """Set all parameters to what they are, changed."""
    (x, y, z), radius = place
    transform = mi.Transform4f
    params["floor.to_world"] = transform().translate([0, 0, changes["floor"]]).scale(50)
    moved = transform().translate([x + changes["x"], y, z + changes["z"]])
    params["light0.to_world"] = moved.scale(radius + changes["radius"])
    params["light0.emitter.radiance.value"] = mi.Color3f(10 + changes["radiance"])
    params["floor.bsdf.reflectance.value"] = mi.Color3f(0.5 + changes["albedo"])
    params.update()


def gradients(loaded, place, spp=1024, seeds=8, render=mi.render):
    """The derivatives of the image's mean with respect to each of STEPS: one row per seed."""
    params = mi.traverse(loaded)
    rows = []
    for seed in range(seeds):
        changes = {name: mi.Float(0) for name in STEPS}
        dr.enable_grad(*changes.values())
        change(params, place, changes)
        dr.backward(dr.mean(render(loaded, params, spp=spp, seed=seed).array))
        rows.append([dr.grad(value)[0] for value in changes.values()])
    return np.array(rows)


@functools.cache
def differences(place, lights=1):
    """The same by differences: of order 1e-4 off, and nearly without noise.

    Light after light, as the choice among them is noise.
    """
    if lights > 1:
        unmoved = np.array([name in ("floor", "albedo") for name in STEPS])
        return differences(place) + unmoved * sum(differences(other) for other in OTHERS[: lights - 1])
    loaded = scene(place, EMITTER_ALONE)
    params = mi.traverse(loaded)
    found = []
    for name, step in STEPS.items():
        ends = []
        for sign in (1, -1):
            change(params, place, {other: mi.Float(sign * step * (other == name)) for other in STEPS})
            images = [np.array(mi.render(loaded, spp=1024, seed=seed)) for seed in range(2)]
            ends.append(np.mean(images, dtype=np.float64))
        found.append((ends[0] - ends[1]) / (2 * step))
    return np.array(found)


def assert_close(found, reference, relative):
    """Each mean is within six of its standard errors (of eight values: 1 in 2000) and a part of its size."""
    error = found.std(0, ddof=1) / np.sqrt(len(found))
    for i, name in enumerate(STEPS):
        print(f"{name}: {found.mean(0)[i]:.5f} +- {error[i]:.5f}, expected {reference[i]:.5f}")
    assert np.isfinite(found).all()
    assert (np.abs(found.mean(0) - reference) <= 6 * error + relative * np.abs(reference)).all()
    # A test that could not tell a derivative from none would be none.
    assert (6 * error < 0.2 * np.abs(reference)).all()


@pytest.mark.parametrize("lights", [1, 3])
@pytest.mark.parametrize("place", PLACES.values(), ids=PLACES)
def test_light_samples(place, lights):
    """No edge moves: the derivatives are those of differences."""
    loaded = scene(place, EMITTER_ALONE, lights=lights)
    assert_close(gradients(loaded, place, seeds=8 * lights), differences(place, lights), 1e-3)


@pytest.mark.parametrize("technique", ["projected_bounded", "solid_angle"])
def test_techniques(technique):
    """A sample follows the sphere however it was chosen; also on both sides, and in a mixture."""
    for parameters in ({"hemispheres": "both"}, {"defensive": 0.25}):
        loaded = scene(PLACES["cut"], EMITTER_ALONE, technique=technique, **parameters)
        assert_close(gradients(loaded, PLACES["cut"]), differences(PLACES["cut"]), 1e-3)


@pytest.mark.parametrize("integrator", [{"type": "direct"}, {"type": "path", "max_depth": 2}])
@pytest.mark.parametrize("place", PLACES.values(), ids=PLACES)
def test_light_and_bsdf_samples(place, integrator):
    """Where sampled BSDFs see the light, its outline moves, which no sample knows: 1.2 % are lost at most.

    `area` loses up to 4 %: it uses light samples less.
    """
    assert_close(gradients(scene(place, integrator), place), differences(place), 0.015)


@pytest.mark.parametrize("place", PLACES.values(), ids=PLACES)
def test_the_technique_of_area(place):
    """Sampling by solid angle, `direct` gives what it gives with `area`, outlines included."""
    ours = gradients(scene(place, {"type": "direct"}, technique="solid_angle"), place)
    theirs = gradients(scene(place, {"type": "direct"}, "area"), place)
    error = np.sqrt((ours.var(0, ddof=1) + theirs.var(0, ddof=1)) / len(ours))
    difference = np.abs(ours.mean(0) - theirs.mean(0))
    assert (difference <= 6 * error).all()
    assert (6 * error < 0.2 * np.abs(ours.mean(0))).all()


@pytest.mark.parametrize("place", PLACES.values(), ids=PLACES)
@pytest.mark.parametrize(
    "parameters", [{}, {"defensive": 0.25}, {"hemispheres": "both"}, {"technique": "solid_angle"}]
)
def test_densities_are_of_one_function(place, parameters):
    """`direct` differentiates the weights of multiple importance sampling.

    Their derivatives cancel if the densities of light samples and of sampled BSDFs are those of one function
    of the direction: the derivatives along two ways differ by its slope times the difference of the ways.
    """
    emitter = scene(place, EMITTER_ALONE, **parameters).emitters()[0]
    count = 1000
    rng = mi.PCG32(count)
    it = dr.zeros(mi.SurfaceInteraction3f, count)
    it.n = mi.Normal3f(0, 0, 1)
    height = mi.Float(0)
    dr.enable_grad(height)
    it.p = mi.Point3f(0, 0, height)
    ds, _ = emitter.sample_direction(it, mi.Point2f(rng.next_float32(), rng.next_float32()))

    # The other way: a direction that does not move.
    still = dr.detach(ds)
    still_pdf = emitter.pdf_direction(it, still)
    dr.forward(height, dr.ADFlag.ClearEdges)  # keeps all gradients
    way, along, without = dr.grad(ds.d), dr.grad(ds.pdf), dr.grad(still_pdf)

    def density(step):
        moved = mi.DirectionSample3f(still)
        moved.d = dr.normalize(still.d - step * way)
        return emitter.pdf_direction(dr.detach(it), moved)

    step = 1e-3
    slope = (density(step) - density(-step)) / (2 * step)
    # Not where the step leaves the light, or crosses the horizon.
    inside = np.array((density(step) > 0) & (density(-step) > 0) & (dr.abs(still.d.z) > 3 * step))
    found = np.array(without - along)[inside]
    expected = np.array(slope)[inside]
    scale = np.abs(np.array(along))[inside] + np.abs(np.array(without))[inside] + np.abs(expected)
    assert inside.sum() > count / 2
    # Rounding of densities over the step: 1e-4 of them.
    assert (np.abs(found - expected) <= 2e-3 * scale + 1e-3 * np.array(still.pdf)[inside]).all()


@pytest.mark.parametrize("integrator", ["prb", "prb_basic", "direct_projective", "prb_projective"])
def test_integrators_that_attach_samples_themselves(integrator):
    """As with `area`: without silhouettes, all but what belongs to the light's place and size."""
    options = {"sppp": 0, "sppi": 0} if "projective" in integrator else {}
    if integrator != "direct_projective":
        options["max_depth"] = 2
    loaded = {
        emitter: scene(PLACES["above"], {"type": integrator, **options}, emitter)
        for emitter in ("spherecap", "area")
    }
    ours, theirs = (gradients(loaded[emitter], PLACES["above"]) for emitter in ("spherecap", "area"))
    names = list(STEPS)
    for name in ("x", "z", "radius"):
        assert not ours[:, names.index(name)].any()
        assert not theirs[:, names.index(name)].any()
    for name in ("floor", "radiance", "albedo"):
        i = names.index(name)
        error = ours[:, i].std(ddof=1) / np.sqrt(len(ours))
        print(f"{name}: {ours[:, i].mean():.5f} +- {error:.5f}, area {theirs[:, i].mean():.5f}")
        reference = differences(PLACES["above"])[i]
        assert abs(ours[:, i].mean() - reference) <= 6 * error + 1e-3 * abs(reference)


@pytest.mark.parametrize("variant", ["llvm_ad_mono", "llvm_ad_spectral", "llvm_ad_spectral_polarized"])
def test_variants(variant):
    """In other variants, the derivatives of `direct` are `area`'s."""
    mi.set_variant(variant)
    found = {}
    for emitter in ("spherecap", "area"):
        loaded = scene(PLACES["above"], EMITTER_ALONE, emitter)
        params = mi.traverse(loaded)
        rows = []
        for seed in range(8):
            height = mi.Float(0)
            dr.enable_grad(height)
            params["light0.to_world"] = mi.Transform4f().translate([3.5, 0.5, 2.5 + height]).scale(0.7)
            params.update()
            dr.backward(dr.mean(mi.render(loaded, params, spp=1024, seed=seed).array))
            rows.append(dr.grad(height)[0])
        found[emitter] = np.array(rows)
    error = np.sqrt(sum(rows.var(ddof=1) / len(rows) for rows in found.values()))
    assert abs(found["spherecap"].mean() - found["area"].mean()) <= 6 * error
    assert 6 * error < 0.2 * abs(found["area"].mean())


def test_gradients_change_no_image():
    """The same bits, whether or not they are asked for."""
    for integrator in (EMITTER_ALONE, {"type": "direct"}, {"type": "path", "max_depth": 3}):
        loaded = scene(PLACES["cut"], integrator)
        params = mi.traverse(loaded)
        plain = np.array(mi.render(loaded, spp=16))
        changes = {name: mi.Float(0) for name in STEPS}
        dr.enable_grad(*changes.values())
        change(params, PLACES["cut"], changes)
        attached = np.array(dr.detach(mi.render(loaded, params, spp=16)))
        assert np.array_equal(plain, attached)


def test_evaluated_and_symbolic_modes_agree():
    """Where Dr.Jit differentiates what it has recorded, and where it runs it step by step."""
    found = []
    for symbolic in (True, False):
        with (
            dr.scoped_set_flag(dr.JitFlag.SymbolicLoops, symbolic),
            dr.scoped_set_flag(dr.JitFlag.SymbolicCalls, symbolic),
            dr.scoped_set_flag(dr.JitFlag.SymbolicConditionals, symbolic),
        ):
            loaded = scene(PLACES["cut"], {"type": "direct"}, lights=3)
            found.append(gradients(loaded, PLACES["cut"], spp=64, seeds=1)[0])
    np.testing.assert_allclose(found[0], found[1], rtol=1e-3)


@pytest.mark.parametrize("hemispheres", ["front", "both"])
def test_hard_places_have_finite_derivatives(hemispheres):
    """Distant lights, points next to the light, on it and inside, and at its centre; samples at the limb."""
    emitter = scene(((0, 0, 0), 1), EMITTER_ALONE, hemispheres=hemispheres).emitters()[0]
    rng = np.random.default_rng(1)
    count = 100_000
    gap = 10 ** rng.uniform(-8, 8, count) * np.where(rng.random(count) < 0.1, -1, 1)
    towards, normal = rng.standard_normal((2, count, 3))
    towards /= np.linalg.norm(towards, axis=1, keepdims=True)
    normal /= np.linalg.norm(normal, axis=1, keepdims=True)
    own = rng.random(count) < 0.1
    normal[own] = towards[own]
    place = towards * np.maximum(1 + gap, 0)[:, None]
    it = dr.zeros(mi.SurfaceInteraction3f, count)
    it.p, it.n = mi.Point3f(place.T), mi.Normal3f(normal.T)
    dr.enable_grad(it.p)
    u = rng.choice([0, 1e-7, 0.3, 0.5, 1 - 2**-24, 1], (2, count))
    ds, weight = emitter.sample_direction(it, mi.Point2f(u))
    pdf = emitter.pdf_direction(it, ds)
    assert 0.3 < np.mean(np.array(ds.pdf) > 0) < 0.95
    for value in (ds.d, ds.dist, ds.p, ds.n, ds.pdf, weight, pdf):
        dr.clear_grad(it.p)
        dr.backward_from(dr.sum(value), dr.ADFlag.ClearInterior)
        found = np.array(dr.grad(it.p))
        assert np.isfinite(found).all()
        assert found.any()
