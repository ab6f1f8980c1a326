"""The recorded kernel: where Mitsuba compiles kernels, the plugin gives the scalar kernel's very bits."""

import ctypes
import os
import subprocess
from functools import partial
from pathlib import Path

import drjit as dr
import mitsuba as mi
import numpy as np
import pytest
from lights import light

REPOSITORY = Path(__file__).resolve().parents[2]
LLVM_VARIANTS = [variant for variant in mi.variants() if variant.startswith("llvm_")]

#: The library called in a loop, with what the plugin does around it.
BATCH = r"""
#include <math.h>
#include <string.h>
#include "spherecap.h"

void batch(uint32_t technique, uint32_t hemispheres, float defensive, const float *center, float radius,
           int count, const float *p, const float *n, const float *u, const float *direction,
           float *sample, float *pdf) {
    for (int i = 0; i < count; ++i, p += 3, n += 3, u += 2, direction += 3, sample += 11, ++pdf) {
        const float c[3] = {center[0] - p[0], center[1] - p[1], center[2] - p[2]};
        const spherecap_receiver_t receiver = {{n[0], n[1], n[2]}, technique, hemispheres, defensive};
        spherecap_sampler_t sampler;
        spherecap_sample_t s;
        spherecap_density_t density;
        spherecap_prepare(&receiver, c, radius, &sampler);
        spherecap_sample(&sampler, u[0], u[1], &s);
        memcpy(sample, s.direction, 12);
        memcpy(sample + 3, s.normal, 12);
        sample[6] = s.distance;
        sample[7] = s.density.solid_angle;
        for (int j = 0; j < 3; ++j)
            sample[8 + j] = fmaf(s.normal[j], radius, center[j]);
        spherecap_pdf_on_sphere(&sampler, direction, &density);
        *pdf = density.solid_angle;
    }
}
"""

TECHNIQUES = ["projected", "projected_bounded", "solid_angle"]
HEMISPHERES = ["front", "both"]
MIXTURES = [
    ("projected", "front", 0.0),
    ("projected", "both", 0.125),
    ("projected", "both", 0.0),
    ("projected_bounded", "front", 0.125),
    ("projected_bounded", "both", 0.0),
    ("solid_angle", "front", 0.0),
]
COUNT = 100_000
LIGHTS = [((0.0, 0.0, 3.0), 1.0), ((-250.5, 1e3, 33.0), 0.015)]


@pytest.fixture(scope="module")
def batch(tmp_path_factory):
    """The loop, linked with the library that the plugin was linked with."""
    folder = tmp_path_factory.mktemp("batch")
    (folder / "batch.c").write_text(BATCH)
    library = REPOSITORY / "target" / "release" / "libspherecap.a"
    command = [os.environ.get("CC", "cc"), "-O1", "-shared", "-fPIC", f"-I{REPOSITORY / 'include'}"]
    command += [
        str(folder / "batch.c"),
        str(library),
        "-lpthread",
        "-ldl",
        "-lm",
        "-o",
        str(folder / "batch.so"),
    ]
    subprocess.run(command, check=True)
    function = ctypes.CDLL(str(folder / "batch.so")).batch
    pointer = np.ctypeslib.ndpointer(np.float32, flags="C")
    function.argtypes = [
        ctypes.c_uint32,
        ctypes.c_uint32,
        ctypes.c_float,
        pointer,
        ctypes.c_float,
        ctypes.c_int,
    ]
    function.argtypes += [pointer] * 6
    function.restype = None
    return function


def unit(v):
    """Vectors of length one."""
    return v / np.linalg.norm(v, axis=1, keepdims=True)


def configurations(center, radius, seed):
    """Points all around a light, with normals that put it in every place relative to the horizon."""
    rng = np.random.default_rng(seed)
    # s = r/d from nearly touching to far away, and some points inside.
    s = np.where(rng.random(COUNT) < 0.5, rng.random(COUNT), 10 ** rng.uniform(-5, 0, COUNT))
    near = rng.random(COUNT) < 0.05
    s[near] = 1 - 10 ** rng.uniform(-8, -1, near.sum())
    inside = rng.random(COUNT) < 0.02
    s[inside] = 1 + rng.random(inside.sum())
    towards = unit(rng.standard_normal((COUNT, 3)))
    p = np.asarray(center) - towards * (radius / s)[:, None]
    # Elevations: anywhere, or where the sphere is cut, or at or next to where it touches the horizon.
    kind = rng.integers(0, 4, COUNT)
    z = np.where(kind == 0, rng.uniform(-1, 1, COUNT), s * rng.uniform(-1.1, 1.1, COUNT))
    touching = s * rng.choice([-1, 0, 1], COUNT) * (1 + 10 ** rng.uniform(-8, -3, COUNT))
    z = np.clip(np.where(kind == 1, touching, z), -1, 1)
    across = unit(np.cross(towards, rng.standard_normal((COUNT, 3))))
    n = z[:, None] * towards + np.sqrt(1 - z**2)[:, None] * across
    # Normals as they come: rounded, not quite of unit length or wrong, of a medium, along an axis.
    n *= np.where(rng.random(COUNT) < 0.1, rng.uniform(0.9985, 1.0015, COUNT), 1)[:, None]
    n[rng.random(COUNT) < 0.02] = 0
    n[rng.random(COUNT) < 0.02] = [0, 0, 1]
    zenith = rng.random(COUNT) < 0.02
    n[zenith] = towards[zenith]
    u = rng.random((COUNT, 2))
    ends = rng.random((COUNT, 2)) < 0.02
    u[ends] = rng.choice([0, 2.0**-24, 0.5, 1 - 2.0**-24, 1], ends.sum())
    # Directions to points of the sphere.
    d = unit(np.asarray(center) + radius * unit(rng.standard_normal((COUNT, 3))) - p)
    return [np.ascontiguousarray(x, dtype=np.float32) for x in (p, n, u, d)]


def rows(*values):
    """Dr.Jit vectors as columns of an array."""
    dr.eval(*values)
    return np.concatenate([np.atleast_2d(value.numpy()) for value in values]).T


def same_bits(a, b):
    """Whether two arrays are equal; zeros may have either sign, NaN equals nothing."""
    return (a == b).all(axis=-1)


@pytest.mark.parametrize("place", LIGHTS, ids=["near", "far"])
@pytest.mark.parametrize(("technique", "hemispheres", "defensive"), MIXTURES)
def test_bits_of_the_scalar_kernel(batch, technique, hemispheres, defensive, place):
    """Samples and densities, over every case and many hard configurations: 1.2 million of each in all."""
    mi.set_variant("llvm_ad_rgb")
    center, radius = place
    emitter = light(
        center=center, radius=radius, technique=technique, hemispheres=hemispheres, defensive=defensive
    ).emitter()
    p, n, u, d = configurations(center, radius, seed=TECHNIQUES.index(technique))
    expected, expected_pdf = np.empty((COUNT, 11), np.float32), np.empty(COUNT, np.float32)
    # The transformation of a sphere is kept in single precision.
    light_center = np.float32(center)
    numbers = TECHNIQUES.index(technique), HEMISPHERES.index(hemispheres), defensive
    batch(*numbers, light_center, np.float32(radius), COUNT, p, n, u, d, expected, expected_pdf)

    it = dr.zeros(mi.SurfaceInteraction3f, COUNT)
    it.p, it.n = mi.Point3f(p.T), mi.Normal3f(n.T)
    # A mask that is no constant, as in an integrator's loop: then the kernel is in a conditional.
    active = mi.Bool(np.full(COUNT, fill_value=True))
    ds, weight = emitter.sample_direction(it, mi.Point2f(u.T), active)
    found = rows(ds.d, ds.n, ds.dist, ds.pdf, ds.p)
    assert np.isfinite(found).all()
    # The plugin alone knows that a point is one of the light's own (test_own_surface.py), and answers zero.
    own = np.abs(center + radius * n - p).max(1) < 2e-6 * (np.abs(center).max() + radius)
    assert own.mean() < 0.01
    agree = same_bits(found, expected) | own & (found[:, 7] == 0)
    sampled = ~own & (expected[:, 7] > 0)
    print(f"{agree.mean():.6f} agree, {sampled.mean():.3f} have something to sample")
    assert agree.all(), (found[~agree][:3], expected[~agree][:3], p[~agree][:3], n[~agree][:3])
    assert 0.2 < sampled.mean() < 0.99
    weight = rows(weight)[:, 0]
    assert np.array_equal(weight[sampled], 1 / expected[sampled, 7])
    assert not weight[~own & ~sampled].any()

    ds.d, ds.n = mi.Vector3f(d.T), mi.Normal3f(-d.T)
    found = rows(emitter.pdf_direction(it, ds, active))[:, 0]
    agree = (found == expected_pdf) | own & (found == 0)
    assert agree.all(), (found[~agree][:3], expected_pdf[~agree][:3])
    assert (found > 0).mean() > 0.1


@pytest.mark.parametrize("masked", [False, True])
def test_conditionals_change_nothing(masked):
    """Sides of the kernel's branches that are skipped, or computed everywhere: the same bits.

    Points in no order, so that every vector of the processor holds all cases, and in one, so that most sides
    are skipped.
    """
    mi.set_variant("llvm_ad_rgb")
    (center, radius), _ = LIGHTS
    emitter = light(center=center, radius=radius, hemispheres="both", defensive=0.125).emitter()
    inputs = configurations(center, radius, seed=7)
    elevation = ((center - inputs[0]) * inputs[1]).sum(1)
    results = {}
    for is_sorted in (False, True):
        order = np.argsort(elevation) if is_sorted else np.arange(COUNT)
        p, n, u, d = (np.ascontiguousarray(x[order]) for x in inputs)
        it = dr.zeros(mi.SurfaceInteraction3f, COUNT)
        it.p, it.n = mi.Point3f(p.T), mi.Normal3f(n.T)
        # A mask that is no constant puts all of the kernel into one more conditional.
        active = mi.Bool(np.full(COUNT, fill_value=True)) if masked else mi.Bool(True)
        for symbolic in (False, True):
            with (
                dr.scoped_set_flag(dr.JitFlag.SymbolicConditionals, symbolic),
                dr.scoped_set_flag(dr.JitFlag.KernelHistory, True),
            ):
                dr.kernel_history_clear()
                ds, _ = emitter.sample_direction(it, mi.Point2f(u.T), active)
                sample = rows(ds.d, ds.n, ds.dist, ds.pdf, ds.p)
                ds.d, ds.n = mi.Vector3f(d.T), mi.Normal3f(-d.T)
                density = rows(emitter.pdf_direction(it, ds, active))
                code = "".join(k["ir"].read() for k in dr.kernel_history() if k["type"] == dr.KernelType.JIT)
            assert ("Symbolic conditional: spherecap branch" in code) == symbolic
            found = np.empty((COUNT, sample.shape[1] + 1), np.float32)
            found[order] = np.concatenate([sample, density], axis=1)
            results[is_sorted, symbolic] = found
    first, *others = results.values()
    assert np.isfinite(first).all()
    assert (first[:, 7] > 0).mean() > 0.2
    for other in others:
        assert np.array_equal(first, other)


def test_inactive_lanes_give_nothing():
    """Neither samples nor densities."""
    mi.set_variant("llvm_ad_rgb")
    emitter = light().emitter()
    it = dr.zeros(mi.SurfaceInteraction3f, 4)
    it.n = mi.Normal3f(0, 0, 1)
    active = mi.Bool([True, False, True, False])
    ds, weight = emitter.sample_direction(it, mi.Point2f(0.3, 0.4), active)
    assert list(ds.pdf.numpy() > 0) == [True, False, True, False]
    assert list(weight.x.numpy() > 0) == [True, False, True, False]
    assert list(emitter.pdf_direction(it, ds, active).numpy() > 0) == [True, False, True, False]


def test_one_mask_for_many_points():
    """A mask of one entry, which Dr.Jit compares with nothing before it ends the process."""
    mi.set_variant("llvm_ad_rgb")
    emitter = light().emitter()
    it = dr.zeros(mi.SurfaceInteraction3f)
    it.n = [0, 0, 1]
    u = mi.Point2f(dr.linspace(mi.Float, 0, 1, 100), 0.3)
    for lit in (True, False):
        active = dr.opaque(mi.Bool, lit)
        ds, weight = emitter.sample_direction(it, u, active)
        pdf = emitter.pdf_direction(it, ds, active)
        assert [dr.width(ds.pdf), dr.width(pdf)] == [100, 100]
        for value in (ds.pdf, pdf, weight.x):
            assert dr.all((value > 0) == lit)


def test_nothing_is_left_behind():
    """Recording makes hundreds of variables, and keeps none."""
    mi.set_variant("llvm_ad_rgb")
    emitter = light().emitter()
    it = dr.zeros(mi.SurfaceInteraction3f)
    it.n = [0, 0, 1]

    def variables():
        return len(dr.whos(as_string=True).splitlines())

    def draw():
        ds, weight = emitter.sample_direction(it, mi.Point2f(0.3, 0.4))
        return rows(ds.d, ds.pdf, emitter.pdf_direction(it, ds), weight)

    draw()
    before = variables()
    for _ in range(5):
        draw()
    assert variables() == before


def kernels_of(work):
    """The kernels that Dr.Jit runs for some work, as their hashes."""
    dr.kernel_history_clear()
    with dr.scoped_set_flag(dr.JitFlag.KernelHistory, True):
        work()
        dr.sync_thread()
        return [k["hash"] for k in dr.kernel_history() if k["type"] == dr.KernelType.JIT]


#: Centres and radii: equal numbers and zeros, here and there, and none.
PLACES = [
    ((1, 2, 5), 2.0),
    ((0, 0.5, 7), 0.25),
    ((2, 2, 2), 2.0),
    ((0, 0, 0), 1.0),
    ((3, 3, 7), 3.0),
    ((3, -3, 0.7), 0.3),
]


@pytest.mark.parametrize("variant", LLVM_VARIANTS)
def test_moving_the_light_compiles_nothing(variant):
    """Nor does changing its radius, or its radiance: one kernel serves, and none but the sphere's own runs.

    Points are in memory, as a renderer's are. (Dr.Jit sorts what it compiles by age, and constants are as old
    as the first of their value that is still alive: with constants a kernel may be another next time.)
    """
    mi.set_variant(variant)
    spheres = {name: light(name, radiance=2.0) for name in ("area", "spherecap")}
    it = dr.zeros(mi.SurfaceInteraction3f, 16)
    it.p = mi.Point3f(0, 0, 20)
    it.n = mi.Normal3f(0, 0, -1)
    sample = mi.Point2f(0.3, 0.4)
    dr.make_opaque(it, sample)

    updates, kernels, moved = {}, {}, {}
    for name, sphere in spheres.items():
        params = mi.traverse(sphere)
        for center, radius in PLACES:
            params["to_world"] = mi.Transform4f().translate(center).scale(radius)
            params["emitter.radiance.value"] = mi.Float(radius)
            updates.setdefault(name, []).append(kernels_of(params.update))
            ds, weight = sphere.emitter().sample_direction(it, sample)
            kernels.setdefault(name, []).append(kernels_of(partial(dr.eval, ds, weight)))
            moved.setdefault(name, []).append(rows(ds.p))

    assert updates["spherecap"] == updates["area"]
    assert all(kernel == kernels["spherecap"][0] for kernel in kernels["spherecap"])
    for (center, radius), found in zip(PLACES, moved["spherecap"], strict=True):
        assert np.linalg.norm(found - center, axis=1) == pytest.approx(radius, rel=1e-5)
    assert len({found.tobytes() for found in moved["spherecap"]}) == len(PLACES)


# Without conditionals, what is computed; with them, the merging of their results, too.
@pytest.mark.parametrize(
    ("symbolic", "budget"),
    [(False, {"sample": 525, "pdf": 275}), (True, {"sample": 640, "pdf": 305})],
    ids=["selects", "conditionals"],
)
def test_recording_has_a_budget(symbolic, budget):
    """Operations of a sample and of a density, and milliseconds to compile them, beside `area`'s."""
    mi.set_variant("llvm_ad_rgb")
    it = dr.zeros(mi.SurfaceInteraction3f, 1 << 10)
    rng = mi.PCG32(1 << 10)
    it.p, it.n = mi.Point3f(rng.next_float32()), dr.normalize(mi.Normal3f(rng.next_float32(), 0, 1))
    u = mi.Point2f(rng.next_float32(), rng.next_float32())
    dr.eval(it, u)
    counts = {}
    for name, parameters in (("area", {}), ("spherecap", {"hemispheres": "front", "defensive": 0.0})):
        emitter = light(name, **parameters).emitter()
        ds, _ = emitter.sample_direction(it, u)
        dr.eval(ds)
        for what in budget:
            with (
                dr.scoped_set_flag(dr.JitFlag.SymbolicConditionals, symbolic),
                dr.scoped_set_flag(dr.JitFlag.KernelHistory, True),
            ):
                result = (
                    emitter.sample_direction(it, u) if what == "sample" else emitter.pdf_direction(it, ds)
                )
                dr.flush_kernel_cache()
                dr.kernel_history_clear()
                dr.eval(result)
                kernels = [k for k in dr.kernel_history() if k["type"] == dr.KernelType.JIT]
            counts[name, what] = sum(k["operation_count"] for k in kernels)
            compilation = sum(k["codegen_time"] + k["backend_time"] for k in kernels)
            print(f"{name} {what}: {counts[name, what]} operations, {compilation:.1f} ms")
    for what, most in budget.items():
        assert counts["spherecap", what] - counts["area", what] <= most
