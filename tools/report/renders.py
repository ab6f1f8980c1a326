"""Render scenes with `area` and each technique, at several numbers of samples, and keep the errors.

What is kept of a scene is found again by all that it depends on: the scene, the emitter's binary, Mitsuba,
the settings. A report that was interrupted goes on with the next scene.
"""

import gc
import hashlib
import json
import time
from collections.abc import Callable
from dataclasses import asdict, dataclass
from pathlib import Path

import mitsuba as mi
import numpy as np
from renderlab.reference import SPP, needs_rendering, reference
from renderlab.scenes import REPOSITORY, SCENES, load_scene, load_technique, scene_file
from spherecap_command.compare import render
from spherecap_command.measure import relative_mse
from spherecap_command.scene import BUILT_IN, use_variant

from report.data import about

TECHNIQUES = ("solid_angle", "projected_bounded", "projected")
METHODS = (BUILT_IN, *TECHNIQUES)


@dataclass(frozen=True)
class Settings:
    """What is rendered. seeds: independent renders at each number of samples per pixel."""

    scenes: tuple[str, ...]
    spp: tuple[int, ...]
    seeds: int
    width: int
    height: int
    variant: str = "scalar_rgb"


def load(name: str, method: str, **parameters: object) -> "mi.Scene":
    """Load a scene with `area`, or with our emitter and a technique."""
    if method == BUILT_IN:
        return load_scene(name, BUILT_IN, **parameters)
    return load_technique(name, method, **parameters)


def plugin_files() -> list[Path]:
    """Return the emitter's binary."""
    return sorted((REPOSITORY / "mitsuba_plugin" / "spherecap" / "plugins").glob("*.so"))


def key_of(files: list[Path], settings: object) -> str:
    """Return a name for what depends on files, on settings and on Mitsuba."""
    parts = [path.read_bytes() for path in files]
    parts.append(json.dumps([settings, mi.__version__], sort_keys=True).encode())
    return hashlib.sha256(b"\0".join(hashlib.sha256(part).digest() for part in parts)).hexdigest()[:16]


def cache_file(folder: Path, scene: str, settings: Settings) -> Path:
    """Return where the errors of a scene are kept."""
    numbers = {name: value for name, value in asdict(settings).items() if name != "scenes"}
    files = [scene_file(scene), *sorted((SCENES / "meshes").iterdir()), *plugin_files()]
    key = key_of(files, [numbers, METHODS])
    return folder / f"{scene}-{key}.json"


def samples_to_render(folder: Path, settings: Settings) -> int:
    """Return how many samples per pixel are still to be taken, for a progress bar."""
    use_variant(settings.variant)
    missing = [scene for scene in settings.scenes if not cache_file(folder, scene, settings).exists()]
    return len(missing) * len(METHODS) * settings.seeds * sum(settings.spp) + reference_samples(
        missing, settings
    )


def reference_samples(scenes: list[str], settings: Settings) -> int:
    """Return how many samples per pixel the references take that are not kept: two emitters'."""
    return 2 * SPP * sum(needs_rendering(scene, settings.width, settings.height) for scene in scenes)


def measure(scene: str, settings: Settings, advance: Callable[[int], object]) -> dict:
    """Render one scene: for each method relative squared errors and seconds, shape (spp, seeds)."""
    size = {"width": settings.width, "height": settings.height}
    truth = reference(scene, settings.width, settings.height, advance)
    shape = (len(settings.spp), settings.seeds)
    found = {method: {"squared": np.zeros(shape), "seconds": np.zeros(shape)} for method in METHODS}
    loaded = {method: load(scene, method, **size) for method in METHODS}
    for one in loaded.values():
        render(one, 1, seed=0)  # What is done once does not count.
    # Methods in turns, so that whatever else the machine does slows all alike.
    for i, spp in enumerate(settings.spp):
        for j in range(settings.seeds):
            for number, (method, one) in enumerate(loaded.items()):
                start = time.perf_counter()
                # Seeds of their own, so that errors are independent.
                image = render(one, spp, seed=1 + (number * len(settings.spp) + i) * settings.seeds + j)
                found[method]["seconds"][i, j] = time.perf_counter() - start
                squared = relative_mse(image, truth.image, truth.trusted) - truth.noise
                found[method]["squared"][i, j] = squared
                advance(spp)
    del loaded
    gc.collect()
    return {
        "about": about("make report", f"1 to {len(METHODS) * len(settings.spp) * settings.seeds}"),
        "scene": scene,
        "settings": asdict(settings),
        "reference": truth.origin,
        "reference_error": truth.noise**0.5,
        "methods": {
            method: {key: values.tolist() for key, values in arrays.items()}
            for method, arrays in found.items()
        },
    }


def renders(folder: Path, settings: Settings, advance: Callable[[int], object]) -> list[dict]:
    """Return what `measure` found for each scene, now or before."""
    use_variant(settings.variant)
    folder.mkdir(parents=True, exist_ok=True)
    results = []
    for scene in settings.scenes:
        file = cache_file(folder, scene, settings)
        if not file.exists():
            draft = file.with_suffix(".new")
            draft.write_text(json.dumps(measure(scene, settings, advance)))
            draft.replace(file)
        results.append(json.loads(file.read_text()))
    return results
