"""LuxCoreRender, in an environment of its own. Samplers are its RANDOM and SOBOL; light sampling is `cone`.

Its sphere lights sample the cone of directions uniformly, as Mitsuba's `area` does.
"""

import math
import sys
import time
from pathlib import Path

import numpy as np
import pyluxcore

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))

from cross import worker
from cross.mesh import lamp_bodies, mesh
from cross.scene import Scene


def properties(values: dict[str, object]) -> "pyluxcore.Properties":
    """Return LuxCore's form of a dictionary."""
    result = pyluxcore.Properties()
    for key, value in values.items():
        result.Set(pyluxcore.Property(key, list(value) if isinstance(value, tuple) else value))
    return result


def load(scene: Scene, job: worker.Job) -> "pyluxcore.Scene":
    """Build the scene."""
    camera = scene.camera
    # An explicit window makes the field of view horizontal. The image comes out one pixel too low, so the
    # window is moved by as much.
    edge, pixel = job.height / job.width, 2 / job.width
    values = {
        "scene.camera.type": "perspective",
        "scene.camera.lookat.orig": camera.eye,
        "scene.camera.lookat.target": camera.target,
        "scene.camera.up": (0, 0, 1),
        "scene.camera.fieldofview": camera.fov,
        "scene.camera.autovolume.enable": False,
        "scene.camera.screenwindow": (-1.0, 1.0, -edge - pixel, edge - pixel),
    }
    for i, light in enumerate(scene.lights):
        # `gain` multiplies a power: pi L through each of the sphere's 4 pi r^2.
        gain = 4 * math.pi**2 * light.radius**2 * light.radiance
        values |= {
            f"scene.lights.light{i}.type": "sphere",
            f"scene.lights.light{i}.position": light.centre,
            f"scene.lights.light{i}.radius": light.radius,
            f"scene.lights.light{i}.gain": (gain, gain, gain),
        }
    result = pyluxcore.Scene()
    result.Parse(properties(values))
    for i, one in enumerate([*scene.shapes, *lamp_bodies(scene)]):
        vertices, triangles = mesh(one)
        result.DefineMesh(f"mesh{i}", vertices, triangles, None, None, None, None)
        result.Parse(
            properties(
                {
                    f"scene.materials.material{i}.type": "matte",
                    f"scene.materials.material{i}.kd": (one.albedo,) * 3,
                    f"scene.objects.object{i}.shape": f"mesh{i}",
                    f"scene.objects.object{i}.material": f"material{i}",
                    f"scene.objects.object{i}.camerainvisible": i >= len(scene.shapes),
                }
            )
        )
    return result


def settings(scene: Scene, job: worker.Job, seed: int) -> "pyluxcore.Properties":
    """Return how to render: light sampling alone, no clamping, pixels independent of each other."""
    # LuxCore counts both ends of a path, but for direct light 1 does (and 2 takes longer).
    depth = scene.bounces + 2 if scene.bounces else 1
    return properties(
        {
            "renderengine.type": "PATHCPU",
            # One thread: on several, RANDOM is not reproducible.
            "native.threads.count": 1,
            "renderengine.seed": seed + 1,
            "path.pathdepth.total": depth,
            "path.pathdepth.diffuse": depth,
            "path.pathdepth.glossy": depth,
            "path.pathdepth.specular": depth,
            "path.russianroulette.depth": 100,
            "path.clamping.variance.maxvalue": 0.0,
            "lightstrategy.type": "UNIFORM",
            "sampler.type": job.sampler,
            "sampler.sobol.adaptive.strength": 0.0,
            "sampler.random.adaptive.strength": 0.0,
            "film.width": job.width,
            "film.height": job.height,
            "film.filter.type": "NONE",
            "film.outputs.0.type": "RGB",
            "film.outputs.0.filename": "rgb.exr",
            "film.outputs.1.type": "SAMPLECOUNT",
            "film.outputs.1.filename": "count.exr",
            "batch.haltspp": job.spp,
        }
    )


def render(scene: Scene, job: worker.Job, seed: int) -> tuple[np.ndarray, float]:
    """Render once. The sample counts of pixels differ a little; each pixel is the mean of its samples."""
    config = pyluxcore.RenderConfig(settings(scene, job, seed), load(scene, job))
    session = pyluxcore.RenderSession(config)
    session.Start()
    while not session.HasDone():
        time.sleep(0.002)
        session.UpdateStats()  # Without it `haltspp` is never noticed.
    session.Stop()
    film = session.GetFilm()
    shape = (job.height, job.width)
    rgb = np.empty((*shape, 3), dtype=np.float32)
    count = np.empty(shape, dtype=np.uint32)
    film.GetOutputFloat(pyluxcore.FilmOutputType.RGB, rgb, 0)
    film.GetOutputUInt(pyluxcore.FilmOutputType.SAMPLECOUNT, count, 0)
    return rgb[::-1, :, 0], float(count.mean())  # Rows are bottom-up.


def ignore(message: str) -> None:
    """Take LuxCore's log. It has a name because a handler that is gone when the process ends aborts it."""


if __name__ == "__main__":
    pyluxcore.Init(ignore)
    worker.run(render)
