"""Reference images for the demo: the analytic answer where there is one, else many samples, kept on disk."""

import hashlib
from collections.abc import Callable
from dataclasses import asdict
from functools import partial
from pathlib import Path

import mitsuba as mi
import numpy as np
from spherecap_command.compare import PASSES, Reference, rendered_reference

from renderlab.floor_reference import FLOOR_SCENES, read_floor_scene, reference_image, trusted_pixels
from renderlab.scenes import OUTPUT, load_scene, scene_file

# With each emitter; stratified samples, in passes of a square number.
SPP = PASSES * 64


def needs_rendering(name: str, width: int, height: int) -> bool:
    """Tell whether `reference` will take a while."""
    return name not in FLOOR_SCENES and not cache_file(name, width, height).exists()


def cache_file(name: str, width: int, height: int) -> Path:
    """Return where a rendered reference is kept; a changed scene, size or Mitsuba gets another name."""
    parts = [
        scene_file(name).read_bytes(),
        f"{width} {height} {mi.variant()} {mi.__version__} {PASSES} {SPP}".encode(),
    ]
    if b'name="filename"' in parts[0]:
        meshes = sorted((scene_file(name).parent / "meshes").iterdir())
        parts += [path.read_bytes() for path in meshes]
    key = hashlib.sha256(b"\0".join(parts)).hexdigest()[:16]
    return OUTPUT / "references" / f"{name}-{key}.npz"


def reference(name: str, width: int, height: int, advance: Callable[[int], None]) -> Reference:
    """Return the reference of a scene; `advance` is told the samples done if it must be rendered."""
    if name in FLOOR_SCENES:
        floor = read_floor_scene(name, width=width, height=height)
        image = reference_image(floor)
        return Reference(image, np.zeros_like(image), trusted_pixels(floor), "analytic")
    file = cache_file(name, width, height)
    if not file.exists():
        size = {"width": width, "height": height}
        load = partial(load_scene, name, sampler="multijitter", spp=SPP // PASSES, **size)
        made = rendered_reference(load, SPP, advance)
        file.parent.mkdir(parents=True, exist_ok=True)
        np.savez(file, **asdict(made))
    with np.load(file) as kept:
        return Reference(kept["image"], kept["variance"], kept["trusted"], str(kept["origin"]))
