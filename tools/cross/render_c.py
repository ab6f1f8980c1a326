"""The C renderer of `tests/c/renderer.c`: it knows direct light only, on one thread.

Light sampling is one of the library's techniques; samplers are `independent` and `lattice`.
"""

import subprocess
import sys
from pathlib import Path

import numpy as np

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))

from cross import worker
from cross.scene import Scene, as_text

PROGRAM = Path(__file__).resolve().parents[2] / "build" / "renderer"


def read_pfm(data: bytes) -> np.ndarray:
    """Return a grey image of the PFM format."""
    kind, size, scale, pixels = data.split(b"\n", 3)
    if kind != b"Pf":
        raise ValueError(f"not a grey PFM image: it starts with {kind[:10]}")
    width, height = (int(n) for n in size.split())
    order = "<" if float(scale) < 0 else ">"
    return np.frombuffer(pixels, dtype=f"{order}f4").reshape(height, width)[::-1]  # Rows are bottom-up.


def render(scene: Scene, job: worker.Job, seed: int) -> tuple[np.ndarray, float]:
    """Render once."""
    done = subprocess.run(
        [PROGRAM, job.light_sampling, job.sampler, str(job.spp), str(seed)],
        input=as_text(scene, job.width, job.height).encode(),
        capture_output=True,
    )
    if done.returncode != 0:
        raise RuntimeError(done.stderr.decode(errors="replace").strip())
    return read_pfm(done.stdout), float(job.spp)


if __name__ == "__main__":
    worker.run(render)
