"""Load the scenes of this repository with a chosen emitter, and render them.

Images are float64 arrays of shape (height, width, 3), linear radiance.
"""

from pathlib import Path

import mitsuba as mi
import numpy as np
from spherecap_command.compare import render
from spherecap_command.errors import UserError
from spherecap_command.scene import OURS, ParsedScene

REPOSITORY = Path(__file__).resolve().parents[2]
SCENES = REPOSITORY / "scenes"
OUTPUT = REPOSITORY / "out"


def scene_names() -> list[str]:
    """Return the names of all scenes, sorted."""
    return sorted(path.stem for path in SCENES.glob("*.xml"))


def scene_file(name: str) -> Path:
    """Return the XML file of a scene, or raise with the list of scenes that there are."""
    if name not in scene_names():
        raise UserError(f"there is no scene '{name}'; choose one of: {', '.join(scene_names())}")
    return SCENES / f"{name}.xml"


def load_scene(name: str, emitter: str, **parameters: object) -> "mi.Scene":
    """Load a scene with `emitter` on its lights; parameters replace `<default>` values of the XML file."""
    path = scene_file(name)
    texts = {key: str(value) for key, value in parameters.items()}
    return mi.load_file(str(path), emitter=emitter, **texts)


def load_technique(name: str, technique: str, **parameters: object) -> "mi.Scene":
    """Load a scene with our emitter and one of its techniques, which the scene files do not choose."""
    texts = {key: str(value) for key, value in parameters.items()}
    scene = ParsedScene(scene_file(name), {"emitter": OURS, **texts})
    for light in scene.convertible:
        scene.state.nodes[light.node].props["technique"] = technique
    return scene.load(OURS)


def render_stack(scene: "mi.Scene", spp: int, seeds: range) -> np.ndarray:
    """Render once per seed: an array of shape (seeds, height, width, 3)."""
    return np.stack([render(scene, spp, seed) for seed in seeds])
