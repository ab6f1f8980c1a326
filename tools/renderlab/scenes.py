"""Load the scenes of this repository with a chosen emitter, and render them.

Images are float64 arrays of shape (height, width, 3), linear radiance.
"""

import importlib
import sys
from pathlib import Path

import mitsuba as mi
import numpy as np

REPOSITORY = Path(__file__).resolve().parents[2]
PLUGIN_PACKAGE = REPOSITORY / "mitsuba_plugin"
SCENES = REPOSITORY / "scenes"
OUTPUT = REPOSITORY / "out"

BUILT_IN = "area"
OURS = "spherecap"


class LabError(Exception):
    """Something the user can put right; the message says how."""


def scene_names() -> list[str]:
    """Return the names of all scenes, sorted."""
    return sorted(path.stem for path in SCENES.glob("*.xml"))


def scene_file(name: str) -> Path:
    """Return the XML file of a scene, or raise with the list of scenes that there are."""
    if name not in scene_names():
        raise LabError(f"there is no scene '{name}'; choose one of: {', '.join(scene_names())}")
    return SCENES / f"{name}.xml"


def use_variant(variant: str) -> None:
    """Select a Mitsuba variant, or raise with the list of variants that there are."""
    if variant not in mi.variants():
        raise LabError(f"Mitsuba has no variant '{variant}'; choose one of: {', '.join(mi.variants())}")
    try:
        mi.set_variant(variant)
    except Exception as error:  # Mitsuba raises ImportError or RuntimeError, e.g. for lack of a GPU.
        raise LabError(f"the variant '{variant}' does not work on this machine: {error}") from error


def register_plugin() -> None:
    """Make Mitsuba find the emitter `spherecap`; needs a variant to be set. Raise if it was not built."""
    if str(PLUGIN_PACKAGE) not in sys.path:
        sys.path.insert(0, str(PLUGIN_PACKAGE))
    try:
        importlib.import_module("spherecap")
        mi.load_dict({"type": "sphere", "light": {"type": OURS}})
    except Exception as error:
        raise LabError(f"the emitter '{OURS}' cannot be loaded: run `make build` first ({error})") from error


def load_scene(name: str, emitter: str, **parameters: object) -> "mi.Scene":
    """Load a scene with `emitter` on its lights; parameters replace `<default>` values of the XML file."""
    path = scene_file(name)
    if emitter == OURS:
        register_plugin()
    texts = {key: str(value) for key, value in parameters.items()}
    return mi.load_file(str(path), emitter=emitter, **texts)


def render(scene: "mi.Scene", spp: int, seed: int) -> np.ndarray:
    """Render with `spp` samples per pixel; other seeds give independent images."""
    return np.array(mi.render(scene, spp=spp, seed=seed), dtype=np.float64)


def render_stack(scene: "mi.Scene", spp: int, seeds: range) -> np.ndarray:
    """Render once per seed: an array of shape (seeds, height, width, 3)."""
    return np.stack([render(scene, spp, seed) for seed in seeds])
