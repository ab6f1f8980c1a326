"""Reference images for the demo: the analytic answer where there is one, else many samples, kept on disk."""

import hashlib
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

import mitsuba as mi
import numpy as np

from renderlab.estimate import Estimate
from renderlab.floor_reference import FLOOR_SCENES, read_floor_scene, reference_image, trusted_pixels
from renderlab.scenes import BUILT_IN, OUTPUT, load_scene, render, scene_file

# Stratified samples in independent passes; 16 * 64 samples per pixel in all.
PASSES = 16
SPP_PER_PASS = 64
FIRST_SEED = 5000


@dataclass(frozen=True)
class Reference:
    """An image, the variance of its pixels, the pixels to be trusted, and where it comes from, in words."""

    image: np.ndarray
    variance: np.ndarray
    trusted: np.ndarray
    origin: str


def needs_rendering(name: str, width: int, height: int) -> bool:
    """Tell whether `reference` will take a while."""
    return name not in FLOOR_SCENES and not cache_file(name, width, height).exists()


def cache_file(name: str, width: int, height: int) -> Path:
    """Return where a rendered reference is kept; a changed scene, size or Mitsuba gets another name."""
    parts = [
        scene_file(name).read_bytes(),
        f"{width} {height} {mi.variant()} {mi.__version__} {PASSES} {SPP_PER_PASS}".encode(),
    ]
    if b'name="filename"' in parts[0]:
        meshes = sorted((scene_file(name).parent / "meshes").iterdir())
        parts += [path.read_bytes() for path in meshes]
    key = hashlib.sha256(b"\0".join(parts)).hexdigest()[:16]
    return OUTPUT / "references" / f"{name}-{key}.npz"


def reference(name: str, width: int, height: int, progress: Callable[[], None] = lambda: None) -> Reference:
    """Return the reference of a scene; `progress` is called after each pass if it must be rendered.

    Rendered references use the built-in emitter, so that ours is never compared with itself.
    """
    if name in FLOOR_SCENES:
        floor = read_floor_scene(name, width=width, height=height)
        image = reference_image(floor)
        return Reference(image, np.zeros_like(image), trusted_pixels(floor), "analytic")
    trusted = np.ones((height, width), dtype=bool)
    origin = f"{BUILT_IN}, {PASSES * SPP_PER_PASS} spp"
    file = cache_file(name, width, height)
    if file.exists():
        with np.load(file) as kept:
            image, variance = (kept[key].astype(np.float64) for key in ("image", "variance"))
        return Reference(image, variance, trusted, origin)
    scene = load_scene(name, BUILT_IN, sampler="multijitter", spp=SPP_PER_PASS, width=width, height=height)
    passes = []
    for number in range(PASSES):
        passes.append(render(scene, SPP_PER_PASS, FIRST_SEED + number))
        progress()
    estimate = Estimate.from_stack(np.stack(passes))
    file.parent.mkdir(parents=True, exist_ok=True)
    np.savez(file, image=estimate.mean.astype(np.float32), variance=estimate.variance.astype(np.float32))
    return Reference(estimate.mean, estimate.variance, trusted, origin)
