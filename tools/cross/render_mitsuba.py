"""Mitsuba, with the emitter that the job names. Samplers are `independent` or `multijitter`."""

import sys
from pathlib import Path

import numpy as np

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))

import renderlab  # noqa: F401 (registers the plugin, or says how to build it)
from spherecap_command.scene import use_variant

from cross import worker
from cross.scene import Ball, Box, Rectangle, Scene, Shape

import drjit as dr  # isort: skip (after renderlab, which says where LLVM is)
import mitsuba as mi  # isort: skip

VARIANT = "llvm_ad_rgb"


def shape(one: Shape) -> dict:
    """Return a shape as a Mitsuba dictionary."""
    transform = mi.ScalarTransform4f
    match one:
        case Rectangle(centre, u, v, _):
            columns = np.eye(4)
            columns[:3, 0], columns[:3, 1], columns[:3, 2], columns[:3, 3] = u, v, np.cross(u, v), centre
            description = {"type": "rectangle", "to_world": transform(columns)}
        case Ball(centre, radius, _):
            description = {"type": "sphere", "center": list(centre), "radius": radius}
        case Box(low, high, _):
            middle, half = np.add(high, low) / 2, np.subtract(high, low) / 2
            to_world = transform().translate(middle.tolist()).scale(half.tolist())
            description = {"type": "cube", "to_world": to_world}
    diffuse = {"type": "diffuse", "reflectance": {"type": "rgb", "value": one.albedo}}
    if isinstance(one, Rectangle) and one.two_sided:
        diffuse = {"type": "twosided", "bsdf": diffuse}
    return {**description, "bsdf": diffuse}


def load(scene: Scene, job: worker.Job) -> "mi.Scene":
    """Build the scene."""
    camera = scene.camera
    if scene.bounces == 0:
        # Light sampling alone: all of the noise is the emitter's own.
        integrator = {"type": "direct", "emitter_samples": 1, "bsdf_samples": 0, "hide_emitters": True}
    else:
        integrator = {"type": "path", "max_depth": scene.bounces + 2, "rr_depth": 100, "hide_emitters": True}
    description = {
        "type": "scene",
        "integrator": integrator,
        "sensor": {
            "type": "perspective",
            "fov": camera.fov,
            "fov_axis": "x",
            "to_world": mi.ScalarTransform4f().look_at(
                origin=list(camera.eye), target=list(camera.target), up=[0, 0, 1]
            ),
            "sampler": {"type": job.sampler, "sample_count": job.spp},
            "film": {
                "type": "hdrfilm",
                "width": job.width,
                "height": job.height,
                "pixel_format": "luminance",
                "component_format": "float32",
                "rfilter": {"type": "box"},
            },
        },
    }
    for i, one in enumerate(scene.shapes):
        description[f"shape_{i}"] = shape(one)
    for i, light in enumerate(scene.lights):
        description[f"light_{i}"] = {
            "type": "sphere",
            "center": list(light.centre),
            "radius": light.radius,
            "bsdf": {"type": "diffuse", "reflectance": {"type": "rgb", "value": 0.0}},
            "emitter": {
                "type": job.light_sampling,
                "radiance": {"type": "rgb", "value": light.radiance},
            },
        }
    return mi.load_dict(description)


def render(scene: Scene, job: worker.Job, seed: int) -> tuple[np.ndarray, float]:
    """Render once."""
    image = mi.render(load(scene, job), spp=job.spp, seed=seed)
    return np.array(image)[..., 0], float(job.spp)


if __name__ == "__main__":
    use_variant(VARIANT)
    dr.set_thread_count(1)  # Several workers share the machine.
    worker.run(render)
