"""Whole renders where Mitsuba compiles kernels: integrators, many lights, loops, freezing."""

import drjit as dr
import mitsuba as mi
import numpy as np
import pytest

LLVM_VARIANTS = [variant for variant in mi.variants() if variant.startswith("llvm_")]
assert len(LLVM_VARIANTS) == 5, f"the wheel has other LLVM variants than expected: {LLVM_VARIANTS}"


@pytest.fixture(autouse=True)
def llvm_ad_rgb():
    """Every test that does not say otherwise."""
    mi.set_variant("llvm_ad_rgb")
    yield
    mi.set_variant("llvm_ad_rgb")


def scene(emitter, integrator="path", lights=1, medium=False, size=24, **parameters):
    """A diffuse floor below one or more lights, the first of them cut by its horizon."""
    types = {
        "direct": {},
        # Without the sampling of silhouettes, which takes minutes and no emitter.
        "direct_projective": {"sppp": 0, "sppi": 0},
    }
    description = {
        "type": "scene",
        "integrator": {"type": integrator, **types.get(integrator, {"max_depth": 3})},
        "sensor": {
            "type": "perspective",
            "fov": 40,
            "to_world": mi.ScalarTransform4f().look_at([0, -6, 4], [0, 0, 0], [0, 0, 1]),
            "film": {"type": "hdrfilm", "width": size, "height": size, "rfilter": {"type": "box"}},
        },
        "floor": {
            "type": "rectangle",
            "to_world": mi.ScalarTransform4f().scale([4, 4, 1]),
            "bsdf": {"type": "diffuse", "reflectance": {"type": "rgb", "value": [0.5, 0.4, 0.3]}},
        },
    }
    for i in range(lights):
        angle = 2 * np.pi * i / lights
        description[f"light{i}"] = {
            "type": "sphere",
            "center": [0.5 + np.sin(angle), np.cos(angle) - 1, 0.3 + 0.4 * i / lights],
            "radius": 0.7 if lights == 1 else 0.2,
            "emitter": {
                "type": emitter,
                "radiance": {"type": "rgb", "value": [1.0, 0.5 + 0.4 * i / lights, 0.25]},
                **parameters,
            },
        }
    if medium:
        description["fog"] = {
            "type": "sphere",
            "center": [-1.2, 0, 0.6],
            "radius": 0.5,
            "bsdf": {"type": "null"},
            "interior": {"type": "homogeneous", "albedo": 0.8, "sigma_t": 2.0},
        }
    return mi.load_dict(description)


def render(loaded, spp=16, seed=0):
    """An image."""
    return np.array(mi.render(loaded, spp=spp, seed=seed))


def means(loaded, renders=16, spp=64, first=0):
    """Means of the quarters of independent images."""
    images = np.stack([render(loaded, spp, first + i) for i in range(renders)])
    n, h, w, c = images.shape
    return images.reshape(n, 2, h // 2, 2, w // 2, c).mean((2, 4)).reshape(n, -1)


def same_mean(a, b, scores=4.5):
    """Whether all means agree, to so many standard errors."""
    error = np.sqrt(a.var(0, ddof=1) / len(a) + b.var(0, ddof=1) / len(b))
    return (np.abs(a.mean(0) - b.mean(0)) <= scores * error + 2e-5 * a.mean(0)).all()


@pytest.mark.parametrize("integrator", ["direct", "path", "volpath", "prb"])
def test_integrators_agree_with_area(integrator):
    """And tell a light that is 3 % brighter."""
    medium = integrator == "volpath"
    ours = means(scene("spherecap", integrator, medium=medium))
    theirs = means(scene("area", integrator, medium=medium), first=100)
    assert same_mean(ours, theirs)
    assert not same_mean(1.03 * ours, theirs)


@pytest.mark.parametrize("lights", [1, 3])
def test_symbolic_and_evaluated_modes_agree(lights):
    """Loops and calls that are compiled, and ones that are run step by step."""
    loaded = scene("spherecap", lights=lights)
    images = {}
    for symbolic in (True, False):
        with (
            dr.scoped_set_flag(dr.JitFlag.SymbolicLoops, symbolic),
            dr.scoped_set_flag(dr.JitFlag.SymbolicCalls, symbolic),
            dr.scoped_set_flag(dr.JitFlag.SymbolicConditionals, symbolic),
        ):
            images[symbolic] = render(loaded)
    assert images[True].mean() > 0
    assert np.allclose(images[True], images[False], rtol=1e-5, atol=1e-6)


@pytest.mark.parametrize("variant", LLVM_VARIANTS)
def test_every_llvm_variant_renders(variant):
    """The image of `area`, to the noise."""
    mi.set_variant(variant)
    ours = means(scene("spherecap"), renders=8, spp=16)
    theirs = means(scene("area"), renders=8, spp=16, first=100)
    assert ours.mean() > 0
    assert same_mean(ours, theirs, scores=7)


def test_scalar_and_compiled_images_agree():
    """The same means in all of the image."""
    compiled = means(scene("spherecap"))
    mi.set_variant("scalar_rgb")
    assert same_mean(means(scene("spherecap"), first=100), compiled)


def test_frozen_renders_follow_the_light():
    """A frozen function renders what a fresh one would after the light has moved, and is not recorded again.

    But for a second time, as with `area`: at first the parameters are as the scene was loaded.
    """
    recordings = {}
    for emitter in ("area", "spherecap"):
        loaded = scene(emitter)
        params = mi.traverse(loaded)

        @dr.freeze
        def frozen(loaded, seed):
            return mi.render(loaded, spp=4, seed=seed)

        for i, x in enumerate((0.5, -0.5, 1.0, 0.25)):
            params["light0.to_world"] = mi.Transform4f().translate([x, 0.2, 0.3]).scale(0.7 + 0.1 * x)
            params["light0.emitter.radiance.value"] = mi.Color3f(1.0, 0.5 + x / 4, 0.25)
            params.update()
            seed = mi.UInt32(i)
            dr.make_opaque(seed)
            found = np.array(frozen(loaded, seed))
            expected = np.array(mi.render(loaded, spp=4, seed=seed))
            assert np.allclose(found, expected, rtol=1e-5, atol=1e-6), x
        recordings[emitter] = frozen.n_recordings
    assert recordings["spherecap"] <= recordings["area"] <= 2


@pytest.mark.parametrize("integrator", ["direct", "path", "prb"])
@pytest.mark.parametrize("lights", [1, 3])
def test_renders_of_a_moved_light_compile_nothing(integrator, lights):
    """Wherever it is, and where its numbers are equal to each other."""
    loaded = scene("spherecap", integrator, lights)
    params = mi.traverse(loaded)
    render(loaded)
    places = [(0.5, -0.3, 0.4, 0.7), (0.3, 0.3, 0.3, 0.3), (0, 0, 1, 1), (0.5, 0, 0.5, 0.5), (1, 2, 3, 0.1)]
    images = []
    with dr.scoped_set_flag(dr.JitFlag.KernelHistory, True):
        dr.kernel_history_clear()
        for *center, radius in places:
            params["light0.to_world"] = mi.Transform4f().translate(center).scale(radius)
            params.update()
            images.append(render(loaded))
        kernels = [k for k in dr.kernel_history() if k["type"] == dr.KernelType.JIT]
    assert len(kernels) >= len(places)
    assert all(k["cache_hit"] for k in kernels)
    assert len({image.tobytes() for image in images}) == len(places)
