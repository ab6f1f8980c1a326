"""How a renderer's process takes orders: a job as JSON per line on standard input, and a line back.

A job is a scene in one size with one sampler, a number of samples per pixel, and seeds. Its images, shape
(seeds, height, width), are saved with the CPU seconds that each took, and the samples that each pixel really
got on average.
"""

import json
import os
import sys
from collections.abc import Callable
from dataclasses import asdict, dataclass, replace
from pathlib import Path

import numpy as np

from cross.scene import Scene, by_name

# What a renderer does: (scene, job, seed) to an image and its mean samples per pixel.
Render = Callable[[Scene, "Job", int], tuple[np.ndarray, float]]


@dataclass(frozen=True)
class Job:
    """Independent renders with equal settings."""

    scene: str
    width: int
    height: int
    # The renderer's own words for how lights and pixels are sampled.
    light_sampling: str
    sampler: str
    spp: int
    seeds: tuple[int, ...]

    def to_json(self, path: Path) -> str:
        """Return the order to render this and save it as `path`."""
        return json.dumps({"path": str(path), "job": asdict(self)})


def cpu_seconds() -> float:
    """Return the CPU time of this process, its threads and its children that have ended."""
    times = os.times()
    return times.user + times.system + times.children_user + times.children_system


def save(path: Path, **arrays: np.ndarray) -> None:
    """Write an .npz file that is either complete or not there."""
    path.parent.mkdir(parents=True, exist_ok=True)
    partial = path.with_suffix(f".{os.getpid()}.partial")
    with partial.open("wb") as file:
        np.savez(file, **arrays)
    partial.rename(path)


def run(render: Render) -> None:
    """Carry out the jobs on standard input."""
    for line in sys.stdin:
        order = json.loads(line)
        job = Job(**order["job"])
        scene = by_name(job.scene)
        images, seconds, samples = [], [], []
        render(scene, replace(job, spp=1), 0)  # Caches and compilation do not count.
        for seed in job.seeds:
            start = cpu_seconds()
            image, spp = render(scene, job, seed)
            seconds.append(cpu_seconds() - start)
            images.append(image.astype(np.float32))
            samples.append(spp)
        save(Path(order["path"]), images=np.stack(images), seconds=np.array(seconds), spp=np.array(samples))
        # On a line of its own: renderers print to the same place.
        print(f"\n{order['path']}", flush=True)
