"""Are the directions of `sample_direction` distributed by `pdf_direction`?

A chi-square test of each technique, case and mixture, through the plugin's own methods. The domain is the cap
itself, in coordinates that map equal solid angles to equal areas: the angle around its axis, and
t = (1 - cos) / (1 - cos of the cap's edge). Small caps are resolved like large ones.

Every test also shows that it can fail: a density that is 0.1 % off, and one for a slightly tilted normal,
must be rejected.
"""

from dataclasses import dataclass, replace
from functools import cache

import mitsuba as mi
import numpy as np
import pytest
from lights import light, point, rotation
from scipy.stats import chi2

SAMPLES = 60_000
BINS = (10, 20)  # in t, and around the axis
NODES = 12  # per bin and dimension: quadrature points of the expected counts

#: Probability that any of the tests of this file fails although all is well.
SIGNIFICANCE = 0.01

#: The quadrature finds the mass of a density to within 6e-5 in the cases below; the worst is a crescent at
#: the horizon, where densities have a kink.
MASS_TOLERANCE = 3e-4

DISTANCE = 2.5
POSITION = np.array([0.3, -0.2, 0.5])


@dataclass(frozen=True)
class Case:
    """A light as seen from a point: sine of its angular radius, and of the elevation of its centre."""

    technique: str
    radius_sin: float
    elevation_sin: float
    hemispheres: str = "front"
    defensive: float = 0.0
    medium: bool = False
    tilt: float = 0.0

    def __str__(self):
        """Name the test."""
        mixture = f"{self.hemispheres}-{self.defensive}" if not self.medium else "medium"
        return f"{self.technique}-s{self.radius_sin}-Z{self.elevation_sin}-{mixture}"


GEOMETRIES = [
    (0.5, 0.7),  # wholly above the horizon
    (0.8, 1.0),  # the centre at the zenith
    (0.5, 0.2),  # cut, centre above
    (0.9, 0.5),
    (0.5, -0.2),  # cut, centre below
    (0.9, -0.6),
    (0.02, 0.01),  # small, cut
    (0.02, -0.01),
]
MIXTURES = [("front", 0.0), ("both", 0.0), ("front", 0.125), ("both", 0.125)]
CASES = [
    *(
        Case(technique, *geometry, *mixture)
        for technique in ("projected", "projected_bounded")
        for geometry in GEOMETRIES
        for mixture in MIXTURES
    ),
    *(Case("solid_angle", *geometry) for geometry in GEOMETRIES),
    *(Case(technique, 0.5, 0.2, medium=True) for technique in ("projected", "projected_bounded")),
]
OTHER_VARIANTS = ["scalar_spectral", "scalar_spectral_polarized"]
OTHER_VARIANTS += [variant for variant in mi.variants() if variant.startswith("llvm_")]

# Sidak's correction: each test gets the level at which all of them together have SIGNIFICANCE.
LEVEL = 1 - (1 - SIGNIFICANCE) ** (1 / (len(CASES) + len(OTHER_VARIANTS)))


def build(case):
    """The emitter, the point, and the cap's frame (its axis last), all turned by a random rotation."""
    turn = rotation(seed=1000 + CASES.index(replace(case, tilt=0.0)))
    elevation_cos = np.sqrt(1 - case.elevation_sin**2)
    axis = turn @ [elevation_cos, 0, case.elevation_sin]
    side = turn @ [0, 1, 0]
    normal = turn @ [np.sin(case.tilt), 0, np.cos(case.tilt)]
    emitter = light(
        center=POSITION + DISTANCE * axis,
        radius=DISTANCE * case.radius_sin,
        technique=case.technique,
        hemispheres=case.hemispheres,
        defensive=case.defensive,
    ).emitter()
    it = point(POSITION, np.zeros(3) if case.medium else normal)
    return emitter, it, np.stack([np.cross(side, axis), side, axis])


def edge(case):
    """1 - cos of the angular radius."""
    s2 = case.radius_sin**2
    return s2 / (1 + np.sqrt(1 - s2))


@cache
def observed(case, variant="scalar_rgb"):
    """Samples per bin."""
    mi.set_variant(variant)
    emitter, it, frame = build(case)
    random = np.random.default_rng(2000 + CASES.index(case)).random((SAMPLES, 2))
    if variant.startswith("llvm"):
        directions = emitter.sample_direction(it, mi.Point2f(random.T))[0].d.numpy().T.astype(np.float64)
    else:
        directions = np.empty((SAMPLES, 3))
        for i, (u, v) in enumerate(random.tolist()):
            d = emitter.sample_direction(it, mi.Point2f(u, v))[0].d
            directions[i] = d.x, d.y, d.z

    across, along, forward = frame @ directions.T
    # |d - axis|^2 / 2 is 1 - cos, without its cancellation.
    t = (across**2 + along**2 + (forward - 1) ** 2) / 2 / edge(case)
    assert t.max() < 1 + 1e-6 / edge(case), "a sample misses the sphere"
    if case.hemispheres == "front" and case.defensive == 0 and case.technique != "solid_angle":
        assert case.medium or (directions @ np.array(it.n)).min() > -1e-7, "a sample is below the horizon"
    angle = np.arctan2(along, across) / (2 * np.pi) % 1
    return np.histogram2d(t.clip(0, 1), angle, BINS, [(0, 1), (0, 1)])[0]


@cache
def expected(case, variant="scalar_rgb"):
    """Samples per bin according to `pdf_direction`, by the midpoint rule."""
    mi.set_variant(variant)
    emitter, it, frame = build(case)
    t, angle = (
        ((np.arange(bins * NODES) + 0.5) / (bins * NODES)).reshape(shape)
        for bins, shape in zip(BINS, ((-1, 1), (1, -1)), strict=True)
    )
    versine = t * edge(case)
    sine = np.sqrt(versine * (2 - versine))
    local = np.broadcast_arrays(
        sine * np.cos(2 * np.pi * angle), sine * np.sin(2 * np.pi * angle), 1 - versine
    )
    directions = np.tensordot(np.stack(local, axis=-1), frame, 1)

    density = np.empty(directions.shape[:2])
    ds = mi.DirectionSample3f()
    flat = density.reshape(-1)
    if variant.startswith("llvm"):
        ds.d = mi.Vector3f(directions.reshape(-1, 3).T)
        ds.n = mi.Normal3f(-ds.d)
        flat[:] = emitter.pdf_direction(it, ds).numpy()
    else:
        for i, (x, y, z) in enumerate(directions.reshape(-1, 3).tolist()):
            ds.d = mi.Vector3f(x, y, z)
            ds.n = mi.Normal3f(-x, -y, -z)
            flat[i] = emitter.pdf_direction(it, ds)
    solid_angle_of_a_node = 2 * np.pi * edge(case) / density.size
    per_bin = density.reshape(BINS[0], NODES, BINS[1], NODES).sum((1, 3)) * solid_angle_of_a_node
    return SAMPLES * per_bin


def accepted(counts, expectation):
    """Does the density integrate to one, and do the samples follow it? Bins of less than ten are pooled."""
    mass = expectation.sum() / SAMPLES
    small = expectation < 10
    pool = [counts[small].sum()], [expectation[small].sum()]
    f, e = (
        np.concatenate([whole[~small], rest]) for whole, rest in zip((counts, expectation), pool, strict=True)
    )
    f, e = (f, e) if e[-1] >= 10 else (f[:-1], e[:-1])
    statistic = ((f - e) ** 2 / e).sum()
    p_value = chi2.sf(statistic, len(e) - 1)
    print(f"mass {mass:.6f}, chi-square {statistic:.1f} of {len(e) - 1}, p = {p_value:.3g}")
    return abs(mass - 1) < MASS_TOLERANCE and p_value > LEVEL


@pytest.mark.parametrize("case", CASES, ids=str)
def test_samples_follow_the_density(case):
    """And no other density."""
    counts = observed(case)
    assert accepted(counts, expected(case))
    assert not accepted(counts, expected(case) * 1.001)
    assert not accepted(counts, expected(case) * 0.999)
    if case.technique != "solid_angle" and not case.medium:
        assert not accepted(counts, expected(replace(case, tilt=0.3 * case.radius_sin)))


@pytest.mark.parametrize("variant", OTHER_VARIANTS)
def test_in_other_variants(variant):
    """The cut cap with its centre below the horizon, with everything mixed in."""
    case = Case("projected", 0.5, -0.2, "both", 0.125)
    assert accepted(observed(case, variant), expected(case, variant))
