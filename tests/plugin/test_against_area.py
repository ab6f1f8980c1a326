"""Renders converge to what `area` gives, with every technique, where the emitter has to decide by itself."""

from functools import cache

import mitsuba as mi
import numpy as np
import pytest
from scipy.stats import t as student

TECHNIQUES = ["projected", "projected_bounded", "solid_angle"]

#: The first shows directions that are never sampled, the second densities that are wrong.
INTEGRATORS = {
    "emitter sampling": {"type": "direct", "emitter_samples": 1, "bsdf_samples": 0},
    "path": {"type": "path", "max_depth": 3},
}


def diffuse():
    """The light is cut by the floor's horizon: both cut cases, in front only."""
    return {"type": "diffuse"}


def two_sided():
    """The floor is seen from below by the camera, and lit from there."""
    return {"type": "twosided", "bsdf": diffuse()}


def translucent():
    """Light passes from one side to the other."""
    return {"type": "roughdielectric", "alpha": 0.5}


def tilted():
    """Shading normals 45 degrees off: light from below the geometric horizon contributes, too."""
    normal = np.array([np.sqrt(0.5), 0, np.sqrt(0.5)])
    bitmap = mi.Bitmap(np.full((2, 2, 3), (normal + 1) / 2, dtype=np.float32))
    texture = {"type": "bitmap", "raw": True, "bitmap": bitmap}
    return {"type": "normalmap", "normalmap": texture, "bsdf": diffuse()}


FLOORS = {
    "diffuse": (diffuse, 4),
    "two-sided": (two_sided, -4),
    "translucent": (translucent, 4),
    "tilted": (tilted, 4),
}

RENDERS = 32
SAMPLES = 64
BLOCKS = 4  # each way

#: Probability that any of the tests of this file fails although all is well.
SIGNIFICANCE = 0.01
COMPARISONS = len(FLOORS) * len(INTEGRATORS) * len(TECHNIQUES) * BLOCKS**2
LEVEL = 1 - (1 - SIGNIFICANCE) ** (1 / COMPARISONS)


@cache
def blocks(emitter, technique, floor, integrator):
    """Means of the blocks of an image, for each of a number of independent renders."""
    bsdf, camera_height = FLOORS[floor]
    parameters = {"technique": technique} if technique else {}
    scene = mi.load_dict(
        {
            "type": "scene",
            "integrator": INTEGRATORS[integrator],
            "sensor": {
                "type": "perspective",
                "fov": 40,
                "to_world": mi.ScalarTransform4f().look_at([0, -6, camera_height], [0, 0, 0], [0, 0, 1]),
                "film": {
                    "type": "hdrfilm",
                    "width": 16,
                    "height": 16,
                    "rfilter": {"type": "box"},
                    "pixel_format": "luminance",
                },
            },
            "light": {
                "type": "sphere",
                "center": [0.5, 0, 0.3],
                "radius": 0.7,
                "emitter": {"type": emitter, **parameters},
            },
            "floor": {
                "type": "rectangle",
                "to_world": mi.ScalarTransform4f().scale([4, 4, 1]),
                "bsdf": bsdf(),
            },
        }
    )
    # The sets of random numbers must differ between the two emitters.
    first = RENDERS * (["area", *TECHNIQUES].index(technique or "area"))
    images = [np.array(mi.render(scene, spp=SAMPLES, seed=first + i)) for i in range(RENDERS)]
    size = 16 // BLOCKS
    return np.reshape(images, (RENDERS, BLOCKS, size, BLOCKS, size)).mean((2, 4))


def agree(a, b):
    """Welch's test of each block: are the means equal?"""
    variance = (a.var(0, ddof=1) + b.var(0, ddof=1)) / RENDERS
    difference = a.mean(0) - b.mean(0)
    # Blocks that are equally black have no variance.
    score = np.abs(difference) / np.sqrt(np.where(variance > 0, variance, 1))
    p_values = 2 * student.sf(score, RENDERS - 1)
    print(f"smallest p-value {p_values.min():.3g}, mean {a.mean():.5f} and {b.mean():.5f}")
    return p_values.min() > LEVEL


@pytest.mark.parametrize("technique", TECHNIQUES)
@pytest.mark.parametrize("integrator", INTEGRATORS)
@pytest.mark.parametrize("floor", FLOORS)
def test_same_image(scalar_rgb, floor, integrator, technique):
    """And not the image of a light that is brighter by some per cent."""
    ours = blocks("spherecap", technique, floor, integrator)
    theirs = blocks("area", None, floor, integrator)
    assert theirs.mean() > 0
    assert agree(ours, theirs)
    assert not agree(1.05 * ours, theirs)
