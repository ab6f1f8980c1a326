"""Several lights choose among themselves at each point: densities, groups, and images against `area`."""

import gc
from functools import partial

import drjit as dr
import mitsuba as mi
import numpy as np
import pytest
from lights import point

VARIANTS = ["scalar_rgb", "llvm_ad_rgb"]
LLVM_VARIANTS = [variant for variant in mi.variants() if variant.startswith("llvm_")]

#: Lights of every kind beside each other, over a floor: centre, radius, radiance.
LIGHTS = [
    ([-1.2, -0.5, 0.8], 0.25, (6, 1.5, 1)),
    ([1.3, -0.4, 0.35], 0.25, (1.5, 5, 1.2)),
    ([0.2, 1.4, 1.1], 0.45, (0.6, 1.2, 3)),
    ([0.1, -0.7, 0.25], 0.05, (60, 50, 30)),
]
#: Touching the floor, below it, half sunk, around some of it, black, overlapping another.
HARD = [
    ([-0.6, 0, 0.3], 0.3, (3, 1, 1)),
    ([0, 0, -0.6], 0.5, (5, 5, 5)),
    ([0.8, 0.3, -0.05], 0.25, (1, 4, 1)),
    ([0.2, 1.2, 0.1], 0.6, (1, 1, 3)),
    ([0.1, -0.6, 0.5], 0.05, (0, 0, 0)),
    ([0.9, 0.4, 0.1], 0.3, (2, 2, 1)),
    ([0, -0.4, 1.5], 0.1, (30, 30, 30)),
]


@pytest.fixture(params=VARIANTS)
def variant(request):
    """One by one, and compiled."""
    mi.set_variant(request.param)
    return request.param


@pytest.fixture
def llvm_ad_rgb():
    """For what is about compiled kernels."""
    mi.set_variant("llvm_ad_rgb")


def sphere(center, radius, radiance, emitter="spherecap", **parameters):
    """A light."""
    rgb = {"type": "rgb", "value": [float(x) for x in radiance]}
    return {
        "type": "sphere",
        "center": [float(x) for x in center],
        "radius": float(radius),
        "emitter": {"type": emitter, "radiance": rgb, **parameters},
    }


def random_lights(count):
    """Lights of all sizes above a floor, most of them dim."""
    rng = np.random.default_rng(3)
    lights = []
    for _ in range(count):
        radius = np.exp(rng.uniform(np.log(0.04), np.log(0.3)))
        center = rng.uniform([-3, -3, 0.6 * radius], [3, 3, 2])
        strength = np.exp(rng.uniform(np.log(0.5), np.log(5))) * 0.8 / radius / count**0.5
        lights.append((center, radius, strength * rng.uniform(0.3, 1, 3)))
    return lights


def scene(
    those, emitter="spherecap", integrator=None, beside=None, size=12, sampler="independent", **parameters
):
    """Lights over a floor with a ball and a block on it, seen from a camera, and other things beside them."""
    transform = mi.ScalarTransform4f
    grey = {"type": "diffuse", "reflectance": {"type": "rgb", "value": 0.7}}
    description = {
        "type": "scene",
        "integrator": integrator
        or {"type": "direct", "emitter_samples": 1, "bsdf_samples": 0, "hide_emitters": True},
        "sensor": {
            "type": "perspective",
            "fov": 55,
            "to_world": transform().look_at(origin=[1, -4, 2.8], target=[0, 0.2, 0.3], up=[0, 0, 1]),
            "sampler": {"type": sampler},
            "film": {"type": "hdrfilm", "width": size, "height": size, "rfilter": {"type": "box"}},
        },
        "floor": {"type": "rectangle", "to_world": transform().scale(50), "bsdf": dict(grey)},
        "ball": {"type": "sphere", "center": [-0.35, 0.1, 0.35], "radius": 0.35, "bsdf": dict(grey)},
        "block": {
            "type": "cube",
            "to_world": transform().translate([0.7, 0.25, 0.35]).scale([0.25, 0.25, 0.35]),
            "bsdf": dict(grey),
        },
        **{f"light{i}": sphere(*light, emitter, **parameters) for i, light in enumerate(those)},
    }
    description.update(beside or {})
    return mi.load_dict(description)


def sampled(loaded, it, u):
    """What random numbers give: light, density, the density that is asked for, direction, weight."""
    if dr.is_jit_v(mi.Float):
        ds, weight = loaded.sample_emitter_direction(it, mi.Point2f(u.T), False)
        asked = np.array(loaded.pdf_emitter_direction(it, ds))
        numbers, known = (
            np.array(dr.reinterpret_array(mi.UInt32, emitter))
            for emitter in (ds.emitter, loaded.emitters_dr())
        )
        order = {int(n): i for i, n in enumerate(known)}
        index = np.array([order.get(int(n), -1) for n in numbers])
        d, weight = np.array(ds.d), np.array(weight)
        d, weight = (a.T if a.shape[0] == 3 else a for a in (d, weight))
        return index, np.array(ds.pdf), asked, d, weight
    rows = []
    emitters = {emitter.ptr: i for i, emitter in enumerate(loaded.emitters())}
    for pair in u.tolist():
        ds, weight = loaded.sample_emitter_direction(it, pair, False)
        asked = loaded.pdf_emitter_direction(it, ds) if ds.pdf > 0 else 0.0
        index = emitters[ds.emitter.ptr] if ds.pdf > 0 else -1
        rows.append((index, ds.pdf, asked, np.array(ds.d), np.array(weight)))
    return [np.array(column) for column in zip(*rows, strict=True)]


@pytest.mark.parametrize("weights", [(1, 1, 1, 1), (1, 3, 0.5, 2)])
def test_choice_and_direction_together(variant, weights):
    """Each eighth of each light's solid angle is covered as densely as the samples say.

    Over all lights that Mitsuba may ask: by its own sampling, whose numbers these are.
    """
    lights = {
        f"l{i}": sphere(*light, sampling_weight=float(w))
        for i, (light, w) in enumerate(zip(LIGHTS, weights, strict=True))
    }
    loaded = mi.load_dict({"type": "scene", **lights})
    count = 400_000 if variant != "scalar_rgb" else 20_000
    u = np.random.default_rng(5).random((count, 2))
    index, pdf, asked, d, weight = sampled(loaded, point((0.3, -0.3, 0)), u)
    assert (pdf > 0).all()
    # It is asked for by a direction, whose rounding is some 1e-6 of the cosine here, and some more at a limb.
    np.testing.assert_allclose(asked, pdf, rtol=3e-5)
    for i, (center, radius, radiance) in enumerate(LIGHTS):
        axis = np.array(center) - [0.3, -0.3, 0]
        s = radius / np.linalg.norm(axis)
        assert axis[2] / np.linalg.norm(axis) > s  # all of it is above the horizon
        solid_angle = 2 * np.pi * s * s / (1 + np.sqrt(1 - s * s))
        axis /= np.linalg.norm(axis)
        side = np.cross(axis, [0, 0, 1])
        side /= np.linalg.norm(side)
        ours = index == i
        across = np.stack([d @ side, d @ np.cross(axis, side)])
        quarter = 2 * (across[0] > 0) + (across[1] > 0)
        # Half of the solid angle is within the angle whose 1 - cos is half of the light's.
        inner = 1 - d @ axis < solid_angle / (4 * np.pi)
        for cell in range(8):
            inside = ours & (quarter + 4 * inner == cell)
            estimate = np.where(inside, 1 / pdf, 0)
            error = estimate.std() / np.sqrt(count)
            assert abs(estimate.mean() - solid_angle / 8) < 4.5 * error + 1e-3 * solid_angle / 8
            assert error < 0.2 * solid_angle / 8
        np.testing.assert_allclose(
            weight[ours] * pdf[ours, None], np.tile(radiance, (ours.sum(), 1)), rtol=1e-4
        )


def test_strata_survive(variant):
    """The random number is used again for the direction, and what Mitsuba has done to it is undone."""
    lights = {f"l{i}": sphere(*light) for i, light in enumerate(random_lights(10))}
    loaded = mi.load_dict({"type": "scene", **lights})
    it = point((0.2, 0.1, 0))
    rng = np.random.default_rng(1)
    jitter, order = rng.random((200, 16, 2)), rng.permuted(np.tile(np.arange(16), (200, 1)), axis=1)
    strata = (np.stack([np.tile(np.arange(16), (200, 1)), order], 2) + jitter) / 16
    deviation = {}
    for name, u in (("strata", strata), ("independent", rng.random((200, 16, 2)))):
        *_, d, weight = sampled(loaded, it, u.reshape(-1, 2))
        # The irradiance by reds, which the choice does not look at.
        estimates = (weight[:, 0] * np.maximum(d[:, 2], 0)).reshape(200, 16).mean(1)
        deviation[name] = estimates.std()
    assert deviation["strata"] < 0.6 * deviation["independent"]


def test_one_light_is_as_before(variant):
    """A group of one is none: the same bits."""
    images = [
        np.array(mi.render(scene(LIGHTS[:1], lights=lights), spp=4, seed=1)) for lights in ("all", "one")
    ]
    assert np.array_equal(*images)


RENDERS = 32


def stack(loaded, spp, first):
    """Independent renders, of few and large pixels. They are traced once, where kernels are compiled."""

    def render(loaded, seed):
        return mi.render(loaded, spp=spp, seed=seed)

    # Mitsuba cannot freeze spectral renders, whatever their emitters.
    compiled = dr.is_jit_v(mi.Float) and not mi.is_spectral
    if compiled:
        render = dr.freeze(render)
    seeds = range(first, first + RENDERS)
    images = [render(loaded, dr.opaque(mi.UInt32, seed) if compiled else seed) for seed in seeds]
    return np.array(images, np.float64)[..., :3].reshape(RENDERS, -1)


def same(ours, theirs):
    """Whether all pixels agree, and the image does: each wrong by chance once in a thousand times.

    To 5 standard errors for each of 48 numbers, and 3.6 for one, as the variances have 31 degrees of freedom
    or more. In the image, a pixel brighter than most counts by its relative difference: else its noise would
    decide.
    """
    difference = ours.mean(0) - theirs.mean(0)
    error = np.sqrt((ours.var(0, ddof=1) + theirs.var(0, ddof=1)) / RENDERS)
    mean = theirs.mean(0)
    weight = 1 / np.maximum(mean, mean.mean())
    whole = [(a * weight).mean(1) for a in (ours, theirs)]
    error_of_whole = np.sqrt(sum(a.var(ddof=1) for a in whole) / RENDERS)
    score, score_of_whole = np.abs(difference / error).max(), (weight * difference).mean() / error_of_whole
    print(f"{(weight * difference).mean():+.3%} +- {error_of_whole:.3%}: {score_of_whole:.2f}; {score:.2f}")
    return score <= 5 and abs(score_of_whole) <= 3.6


def assert_same(those, integrator=None, beside=dict, spp=(1024, 8281), **parameters):
    """The image is that of `area`, and a copy that is 1 % dimmer is not. Samples are stratified: squares."""
    load = partial(scene, those, integrator=integrator, size=4, sampler="multijitter")
    ours = stack(load("spherecap", beside=beside(), **parameters), spp[0], 0)
    theirs = stack(load("area", beside=beside()), spp[1], 100)
    assert same(ours, theirs)
    assert not same(0.99 * ours, theirs), "too noisy to tell a dimmer copy"


def bumps(bsdf):
    """A BSDF with perturbed normals."""
    heights = np.random.default_rng(0).random((16, 16, 1)).astype(np.float32) * 0.3
    return {
        "type": "bumpmap",
        "arbitrary": {"type": "bitmap", "raw": True, "data": mi.TensorXf(heights)},
        "bsdf": bsdf,
    }


#: What may be beside the lights.
BESIDE = {
    "nothing": dict,
    "other emitters": lambda: {
        "sky": {
            "type": "envmap",
            "bitmap": mi.Bitmap(np.float32(np.linspace(0.01, 0.05, 96).reshape(4, 8, 3))),
        },
        "point": {"type": "point", "position": [0.5, -1, 1.5], "intensity": {"type": "rgb", "value": 0.05}},
        "panel": {
            "type": "rectangle",
            "to_world": mi.ScalarTransform4f().translate([0, 0, 3]).rotate([1, 0, 0], 180),
            "emitter": {"type": "area", "radiance": {"type": "rgb", "value": 0.1}},
        },
    },
    "two sides": lambda: {
        "wall": {
            "type": "rectangle",
            "to_world": mi.ScalarTransform4f()
            .translate([0, 0.3, 0.5])
            .rotate([1, 0, 0], 80)
            .scale([0.8, 0.5, 1]),
            "bsdf": {"type": "twosided", "b": {"type": "diffuse"}},
        }
    },
    "bumps": lambda: {
        "ball": {
            "type": "sphere",
            "center": [-0.35, 0.1, 0.35],
            "radius": 0.35,
            "bsdf": bumps({"type": "diffuse"}),
        }
    },
}


def traced(kind, depth=3, **parameters):
    """An integrator."""
    depth = {} if kind == "direct" else {"max_depth": depth}
    return {"type": kind, "hide_emitters": True, **depth, **parameters}


@pytest.mark.parametrize("beside", BESIDE)
def test_images_are_those_of_area(llvm_ad_rgb, beside):
    """Of lights of every hard kind, whatever else there is."""
    # A vertical wall of two sides has penumbrae all over.
    spp = (6400 if beside == "two sides" else 1600, 8281)
    assert_same(HARD, traced("path", 4), BESIDE[beside], spp)


@pytest.mark.parametrize(
    ("name", "integrator"),
    [("scalar_rgb", "path"), *(("llvm_ad_rgb", i) for i in ("direct", "path", "prb", "ptracer"))],
)
def test_integrators(name, integrator):
    """All that sample emitters, and one that starts at them."""
    mi.set_variant(name)
    spp = (484, 4096) if name == "scalar_rgb" else (4096 if integrator == "ptracer" else 1024, 8281)
    assert_same(LIGHTS, traced(integrator), spp=spp)


def test_lights_that_are_seen(llvm_ad_rgb):
    """Rays from the camera meet them, too."""
    assert_same(LIGHTS, traced("path", hide_emitters=False), spp=(4096, 8281))


def fog():
    """Wide and deep: where a boundary is between surface and light, light is lost, of `area`, too."""
    return {
        "fog": {
            "type": "cube",
            "to_world": mi.ScalarTransform4f().translate([0, 0, 0.9]).scale([8, 8, 0.95]),
            "bsdf": {"type": "null"},
            "interior": {"type": "homogeneous", "albedo": 0.8, "sigma_t": 0.2},
        }
    }


@pytest.mark.parametrize("integrator", ["volpath", "volpathmis", "prbvolpath"])
def test_fog(llvm_ad_rgb, integrator):
    """Lights within, choosing for points of no surface."""
    # With few bounces `prbvolpath` is not `volpath` with `area` either.
    depth = 16 if integrator == "prbvolpath" else 3
    assert_same(LIGHTS[:3], traced(integrator, depth, rr_depth=100), fog, (2025, 8281))


def test_fog_in_lights(llvm_ad_rgb):
    """And around lights that are cut by the floor, touch it, or hold some of the fog."""
    assert_same([HARD[0], HARD[2], HARD[3], LIGHTS[0]], traced("volpath"), fog, (8281, 8281))


@pytest.mark.parametrize("name", ["scalar_rgb", "scalar_spectral", *LLVM_VARIANTS])
def test_variants(name):
    """One by one and compiled, with colours, wavelengths and polarisation."""
    mi.set_variant(name)
    assert_same(LIGHTS, spp=(484, 4096) if name == "scalar_rgb" else (784, 6724))


@pytest.mark.parametrize("count", [2, 10, 100, 400])
def test_many_lights(llvm_ad_rgb, count):
    """Each costs time, and takes none of the precision."""
    rng = np.random.default_rng(3)
    # Far from the floor: near it, `area` all but never samples the one that counts.
    low, high = [-3, -3, 0.8], [3, 3, 2.5]
    lights = [
        (rng.uniform(low, high), rng.uniform(0.1, 0.2), rng.uniform(5, 10, 3) / count) for _ in range(count)
    ]
    assert_same(lights, spp=(2304, 16641) if count == 400 else (1024, 8281))


def render(loaded):
    """Render an image, and wait for it."""
    return np.array(mi.render(loaded, spp=1))


def kernels_of(work):
    """The kernels that Dr.Jit runs for some work."""
    dr.kernel_history_clear()
    with dr.scoped_set_flag(dr.JitFlag.KernelHistory, True):
        work()
        return [k for k in dr.kernel_history() if k["type"] == dr.KernelType.JIT]


def test_one_program_for_any_number(llvm_ad_rgb):
    """What is compiled for ten lights is what is compiled for a hundred."""
    operations = []
    for count in (10, 100):
        loaded = scene(random_lights(count))
        gc.collect()
        kernels = kernels_of(partial(render, loaded))
        operations.append(max(k["operation_count"] for k in kernels))
    print(operations)
    assert operations[1] <= 1.02 * operations[0]
    assert operations[1] < 6000


@pytest.mark.parametrize("symbolic", [True, False])
def test_any_light_that_is_asked_answers_for_all(llvm_ad_rgb, symbolic):
    """Recorded once for all in a virtual call, one after the other, or asked by itself: the answer is one.

    Each light has a weight of its own, and so a part of its own of the random number. What was recorded is
    kept no longer than the call.
    """
    weighed = zip(LIGHTS, (1.0, 3.0, 0.5, 2.0), strict=True)
    lights = {f"light{i}": sphere(*light, sampling_weight=w) for i, (light, w) in enumerate(weighed)}
    loaded = scene([], beside=lights)
    emitters = loaded.emitters()
    count, n = len(emitters), 64
    u = np.random.default_rng(9).random((3, n)).astype(np.float32)
    it = dr.zeros(mi.Interaction3f, n)
    it.p = mi.Point3f(mi.Float(u[2] - 0.5), 0.1, 0)
    it.n = [0, 0, 1]
    sample = mi.Point2f(mi.Float(u[0]), mi.Float(u[1]))

    def answers(asked, of):
        ds, weight = asked.sample_direction(it, sample)
        pdf = asked.pdf_direction(it, ds)
        dr.eval(ds, weight, pdf)
        return np.array([np.array(x)[of] for x in (*ds.d, ds.dist, ds.pdf, *weight, pdf)])

    def of_all():
        which = dr.arange(mi.UInt32, n) % count
        with dr.scoped_set_flag(dr.JitFlag.SymbolicCalls, symbolic):
            return answers(dr.gather(mi.EmitterPtr, loaded.emitters_dr(), which), slice(None))

    def variables():
        return len(dr.whos(as_string=True).splitlines())

    together = of_all()
    before = variables()
    np.testing.assert_array_equal(of_all(), together)
    assert variables() == before
    # Other programs, with other numbers known when they are compiled, may round otherwise around the kernel.
    for i, emitter in enumerate(emitters):
        of = slice(i, None, count)
        np.testing.assert_allclose(together[:, of], answers(emitter, of), rtol=1e-6, atol=1e-7)


def test_lights_that_change(llvm_ad_rgb):
    """A light that moves, grows or changes its radiance is chosen by what it is now; nothing is compiled."""
    loaded = scene(LIGHTS)
    params = mi.traverse(loaded)
    np.array(mi.render(loaded, spp=1))
    changed = [list(light) for light in LIGHTS]

    def change(i, center, radius, radiance):
        changed[i] = [center, radius, radiance]
        params[f"light{i}.to_world"] = mi.Transform4f().translate(center).scale(radius)
        params[f"light{i}.emitter.radiance.value"] = mi.Color3f(radiance)
        params.update()
        np.array(mi.render(loaded, spp=1))

    change(0, [-1, 0.5, 0.6], 0.2, [1.0, 2.0, 3.0])
    kernels = kernels_of(lambda: change(3, [0.5, 0.5, 1.5], 0.5, [0.5, 0.5, 0.5]))
    kernels += kernels_of(lambda: change(1, [0.5, 0.5, 0.5], 0.5, [0.0, 0.0, 0.0]))
    assert kernels
    assert all(k["cache_hit"] for k in kernels)
    fresh = scene(changed)
    images = [np.array(mi.render(s, spp=16, seed=3)) for s in (loaded, fresh)]
    np.testing.assert_allclose(*images, rtol=1e-4, atol=1e-6)


def test_weights_that_change(variant):
    """They multiply into the choice, and densities stay right."""
    loaded = scene(LIGHTS)
    params = mi.traverse(loaded)
    for i, weight in enumerate((1.0, 0.0, 2.0, 5.0)):
        params[f"light{i}.emitter.sampling_weight"] = weight
    params.update()
    u = np.random.default_rng(5).random((2000, 2))
    it = point((0.3, -0.3, 0))
    index, pdf, asked, _, _ = sampled(loaded, it, u)
    np.testing.assert_allclose(asked, pdf, rtol=3e-5)
    fresh = [
        sphere(*light, sampling_weight=weight)
        for light, weight in zip(LIGHTS, (1.0, 0.0, 2.0, 5.0), strict=True)
    ]
    other = scene([], beside={f"light{i}": light for i, light in enumerate(fresh)})
    again = sampled(other, it, u)
    np.testing.assert_allclose(again[1], pdf, rtol=1e-5)
    # The second is never chosen, and a ray that meets it by chance has the whole weight.
    assert len(np.unique(index)) == 3
    ds = mi.DirectionSample3f()
    ds.d = dr.normalize(mi.Vector3f([x - y for x, y in zip(LIGHTS[1][0], (0.3, -0.3, 0), strict=True)]))
    ds.n = -ds.d
    assert dr.all(loaded.emitters()[1].pdf_direction(it, ds) == 0)


def test_frozen(llvm_ad_rgb):
    """A frozen function follows lights as a fresh render does."""
    loaded = scene(LIGHTS)
    params = mi.traverse(loaded)

    @dr.freeze
    def frozen(loaded, seed):
        return mi.render(loaded, spp=4, seed=seed)

    for i, x in enumerate((-1.0, -0.5, 0.5, 1.0)):
        params["light0.to_world"] = mi.Transform4f().translate([x, 0.2, 0.9]).scale(0.2)
        params["light3.emitter.radiance.value"] = mi.Color3f(10 + x, 5, 3)
        params.update()
        seed = mi.UInt32(i)
        dr.make_opaque(seed)
        found = np.array(frozen(loaded, seed))
        expected = np.array(mi.render(loaded, spp=4, seed=seed))
        np.testing.assert_allclose(found, expected, rtol=1e-4, atol=1e-6)
    assert frozen.n_recordings <= 2


def test_lights_of_two_scenes(variant):
    """A light that is in two scenes samples itself alone in both; both are right, in either order."""
    shared = [mi.load_dict(sphere(*light)) for light in LIGHTS[:2]]
    first = mi.load_dict({"type": "scene", "a": shared[0], "b": shared[1], "c": sphere(*LIGHTS[2])})
    it = point((0.3, -0.3, 0))
    u = np.random.default_rng(5).random((500, 2))
    before = sampled(first, it, u)
    second = mi.load_dict({"type": "scene", "a": shared[0], "d": sphere(*LIGHTS[3])})
    for loaded, count in ((first, 3), (second, 2)):
        index, pdf, asked, _, _ = sampled(loaded, it, u)
        np.testing.assert_allclose(asked, pdf, rtol=3e-5)
        # Mitsuba's choice: as often each.
        assert np.bincount(index[index >= 0], minlength=count).max() < 1.3 * len(u) / count
    assert np.bincount(before[0]).max() > 1.3 * len(u) / 3
    # The others go on choosing among themselves.
    third = mi.load_dict({"type": "scene", "a": shared[0], "b": sphere(*LIGHTS[1]), "c": sphere(*LIGHTS[3])})
    index, pdf, asked, _, _ = sampled(third, it, u)
    np.testing.assert_allclose(asked, pdf, rtol=3e-5)
    counts = np.bincount(index[index >= 0], minlength=3) / len(u)
    assert counts[0] == pytest.approx(1 / 3, abs=0.08)
    assert counts[1] < 0.25 < 0.4 < counts[2]


@pytest.mark.parametrize("name", ["scalar_spectral", "llvm_ad_spectral"])
def test_a_line_of_a_spectrum(name):
    """A light that is black at all wavelengths that are looked at is sampled all the same."""
    mi.set_variant(name)
    line = sphere(*LIGHTS[0])
    line["emitter"]["radiance"] = {
        "type": "irregular",
        "wavelengths": "360, 551, 552, 553, 830",
        "values": "0, 0, 100, 0, 0",
    }
    loaded = mi.load_dict({"type": "scene", "a": line, "b": sphere(*LIGHTS[1])})
    index, pdf, asked, _, _ = sampled(
        loaded, point((0.3, -0.3, 0)), np.random.default_rng(5).random((2000, 2))
    )
    np.testing.assert_allclose(asked, pdf, rtol=3e-5)
    # Half of what goes evenly to all.
    assert np.mean(index == 0) == pytest.approx(0.025, abs=0.012)


def test_lights_too_bright_to_be_added_up(variant):
    """Densities are those of dim lights, where the sum of what all give is beyond single precision."""
    densities = []
    for radiance in (1.0, 3e38):
        around = [sphere([x, y, 1], 1.2, [radiance] * 3) for x in (-1, 1) for y in (-1, 1)]
        loaded = mi.load_dict({"type": "scene", **{f"l{i}": light for i, light in enumerate(around)}})
        u = np.random.default_rng(5).random((200, 2))
        densities.append(sampled(loaded, point(), u)[1])
    assert (densities[0] > 0).all()
    np.testing.assert_allclose(densities[1], densities[0], rtol=1e-4)


def test_scenes_that_are_freed(variant):
    """A light outlives its scene, and the others of its group."""
    survivor = mi.load_dict(sphere(*LIGHTS[0]))
    loaded = mi.load_dict({"type": "scene", "a": survivor, "b": sphere(*LIGHTS[1])})
    it = point((0.3, -0.3, 0))
    u = np.random.default_rng(5).random((50, 2))
    sampled(loaded, it, u)
    del loaded
    gc.collect()
    ds, _ = survivor.emitter().sample_direction(it, mi.Point2f(0.3, 0.4))
    assert dr.all(ds.pdf > 0)
    assert dr.all(dr.abs(survivor.emitter().pdf_direction(it, ds) - ds.pdf) <= 1e-5 * ds.pdf)


def test_who_joins(variant):
    """Lights that sample in other ways, or alone, are no part of the group; sums are right all the same."""
    apart = {
        "a": sphere(*LIGHTS[0]),
        "b": sphere(*LIGHTS[1], technique="solid_angle"),
        "c": sphere(*LIGHTS[2], lights="one"),
        "d": sphere(*LIGHTS[3]),
        "e": sphere([2, 2, 2], 0.3, (1, 1, 1), "area"),
    }
    loaded = mi.load_dict({"type": "scene", **apart})
    u = np.random.default_rng(5).random((2000, 2))
    index, pdf, asked, _, _ = sampled(loaded, point((0.3, -0.3, 0)), u)
    np.testing.assert_allclose(asked, pdf, rtol=1e-4)
    counts = np.bincount(index, minlength=5) / len(u)
    # Mitsuba gives each a fifth, and the two of the group share theirs.
    assert sorted(counts)[1:4] == pytest.approx([0.2, 0.2, 0.2], abs=0.05)
    assert sorted(counts)[0] < 0.1
    with pytest.raises(RuntimeError, match='"all", "one"'):
        mi.load_dict(sphere(*LIGHTS[0], lights="some"))


def test_a_black_light_keeps_its_gradient(llvm_ad_rgb):
    """It is sampled while it is being optimised."""
    loaded = scene([*LIGHTS[:2], ([0.2, 1.4, 1.1], 0.45, (0, 0, 0))])
    key = "light2.emitter.radiance.value"
    for integrator in ("direct", "prb"):
        params = mi.traverse(loaded)
        value = mi.Color3f(0.0)
        dr.enable_grad(value)
        params[key] = value
        params.update()
        options = (
            {"hide_emitters": True} if integrator == "direct" else {"max_depth": 2, "hide_emitters": True}
        )
        image = mi.render(loaded, params, integrator=mi.load_dict({"type": integrator, **options}), spp=4096)
        dr.backward(dr.mean(image.array))
        found = np.array(dr.grad(value)).ravel()
        step = 1.0  # the image is linear in it
        params[key] = mi.Color3f(step)
        params.update()
        brighter = np.array(mi.render(loaded, spp=1024)).mean()
        params[key] = mi.Color3f(0.0)
        params.update()
        expected = (brighter - np.array(mi.render(loaded, spp=1024)).mean()) / step
        assert found.sum() == pytest.approx(expected, rel=0.05)


@pytest.mark.parametrize("integrator", ["prb", "path"])
def test_gradients_with_respect_to_colours(llvm_ad_rgb, integrator):
    """Channels of a reflectance, against differences, and of a radiance, in which the image is linear."""
    options = {"max_depth": 3, "hide_emitters": True}
    loaded = scene(LIGHTS, integrator={"type": integrator, **options}, size=24)
    references = {"type": "path", **options}

    def mean(those, reflectance):
        plain = scene(those, integrator=references, size=24)
        params = mi.traverse(plain)
        params["ball.bsdf.reflectance.value"] = mi.Color3f(reflectance)
        params.update()
        images = [np.array(mi.render(plain, spp=256, seed=seed)) for seed in range(8)]
        return np.mean(images, (0, 1, 2), dtype=np.float64) / 3

    center, radius, radiance = LIGHTS[1]
    expected = {
        "ball.bsdf.reflectance.value": (mean(LIGHTS, 0.75) - mean(LIGHTS, 0.65)) / 0.1,
        "light1.emitter.radiance.value": mean([(center, radius, [1, 1, 1])], 0.7),
    }
    params = mi.traverse(loaded)
    for key, value in (("ball.bsdf.reflectance.value", 0.7), ("light1.emitter.radiance.value", radiance)):
        rows = []
        for seed in range(12):
            colour = mi.Color3f(value)
            dr.enable_grad(colour)
            params[key] = colour
            params.update()
            dr.backward(dr.mean(mi.render(loaded, params, spp=64, seed=seed).array))
            rows.append(np.array(dr.grad(colour)).ravel())
        params[key] = mi.Color3f(value)
        found, error = np.mean(rows, 0), np.std(rows, 0, ddof=1) / np.sqrt(len(rows))
        print(f"{key}: {found} +- {error}, expected {expected[key]}")
        # Twelve renders: six standard errors are beyond 1 in 5000; what is expected is more precise.
        assert (np.abs(found - expected[key]) < 6 * error + 2e-3 * np.abs(expected[key])).all()
        assert (error < 0.02 * np.abs(expected[key])).all()
