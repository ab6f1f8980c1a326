"""Render with the emitter and print what came out. `smoke.py` runs it in the environment of each Mitsuba."""

import json
import sys
from pathlib import Path

import spherecap  # before Mitsuba: it says where LLVM is

import drjit as dr  # isort: skip
import mitsuba as mi  # isort: skip
import numpy as np  # isort: skip

mi.set_variant(sys.argv[1])
SCENES = Path(__file__).resolve().parents[2] / "scenes"
SEEDS = 16


def measure(scene: mi.Scene) -> dict[str, float]:
    """Return mean brightness with its standard error, and the noise of a pixel."""
    images = np.array([mi.render(scene, seed=seed) for seed in range(SEEDS)], dtype=np.float64)
    means = images.mean(axis=(1, 2, 3))
    return {
        "mean": means.mean(),
        "error": means.std(ddof=1) / SEEDS**0.5,
        "noise": images.std(axis=0, ddof=1).mean(),
    }


def load(emitter: str) -> mi.Scene:
    """Load a floor with a light that dips below it."""
    return mi.load_file(str(SCENES / "cut_light.xml"), emitter=emitter, width=32, height=24, spp=16)


def results() -> dict:
    """Render with both emitters, before and after the light is moved; and look at decisions and gradients."""
    found = {"mitsuba": mi.__version__, "built for": spherecap.BUILT_FOR}
    found |= {"variant": mi.variant(), "seeds": SEEDS, "gradients": []}
    for emitter in ("area", "spherecap"):
        scene = load(emitter)
        params = mi.traverse(scene)
        found[emitter] = {"in place": measure(scene)}
        params["light.to_world"] = mi.Transform4f().translate([0.4, 0.2, 0.9]).scale(0.5)
        params.update()
        found[emitter]["moved"] = measure(scene)

    # What an emitter concludes from the shapes of its scene: from a mesh, and from what an instance repeats.
    mesh = {"type": "obj", "filename": str(SCENES / "meshes/wavy.obj")}
    cube = {"type": "cube", "bsdf": {"type": "twosided", "bsdf": {"type": "diffuse"}}}
    found["decisions"] = [
        str(
            mi.load_dict(
                {"type": "scene", "light": {"type": "sphere", "emitter": {"type": "spherecap"}}, **shapes}
            ).emitters()[0]
        )
        for shapes in (
            {"mesh": mesh},
            {
                "group": {"type": "shapegroup", "cube": cube},
                "instance": {"type": "instance", "group": {"type": "ref", "id": "group"}},
            },
        )
    ]

    if "_ad_" in mi.variant():
        scene = load("spherecap")
        params = mi.traverse(scene)
        radiance = params["light.emitter.radiance.value"]
        dr.enable_grad(radiance)
        params.update()
        dr.backward(dr.mean(mi.render(scene, params).array))
        found["gradients"].append(np.array(dr.grad(radiance)).flatten().tolist())
    return found


json.dump(results(), sys.stdout)
