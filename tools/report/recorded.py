"""What sampling the emitter costs in Mitsuba's compiled variants, without tracing a ray."""

import gc
import json
import time
from pathlib import Path

import mitsuba as mi
import numpy as np
from spherecap_command.scene import BUILT_IN, OURS, use_variant

from report.data import about
from report.renders import key_of, plugin_files

import drjit as dr  # isort: skip (after what tells it where LLVM is)

VARIANT = "llvm_ad_rgb"
SEED = 1


def points(count: int, random: np.random.Generator) -> tuple[np.ndarray, np.ndarray]:
    """Return positions and normals that see the unit sphere in the mix of cases of `benches/scenes.rs`."""

    def directions() -> np.ndarray:
        v = random.normal(size=(count, 3))
        return v / np.linalg.norm(v, axis=1, keepdims=True)

    s = random.uniform(0.02, 0.9, count)
    case = random.random(count)
    inside = s * random.uniform(0.001, 0.999, count)
    z = np.where(case < 0.53, random.uniform(s, 0.999), np.where(case < 0.77, inside, -inside))
    to_centre = directions()
    tangent = np.cross(to_centre, directions())
    tangent /= np.linalg.norm(tangent, axis=1, keepdims=True)
    normals = z[:, None] * to_centre + np.sqrt(1 - z**2)[:, None] * tangent
    return -to_centre / s[:, None], normals


def scene(emitter: str) -> "mi.Scene":
    """Return a light and a diffuse floor, which stands for the surfaces that the points are on."""
    return mi.load_dict(
        {
            "type": "scene",
            "light": {"type": "sphere", "emitter": {"type": emitter}},
            "floor": {"type": "rectangle", "bsdf": {"type": "diffuse"}},
        }
    )


def seconds(emitter: str, surface: "mi.SurfaceInteraction3f", numbers: "mi.Point2f") -> float:
    """Return the time of a sample for each point, the shortest of eight.

    Calls are dispatched over all emitters that exist, so only one scene may.
    """
    gc.collect()
    whole = scene(emitter)  # The emitter does not keep its shape alive.
    light = whole.emitters()[0]
    times = []
    for _ in range(9):  # the first compiles
        start = time.perf_counter()
        sample, weight = light.sample_direction(surface, numbers)
        dr.eval(sample.d, sample.pdf, sample.dist, weight)
        dr.sync_thread()
        times.append(time.perf_counter() - start)
    return min(times[1:])


def measure(count: int, rounds: int) -> dict:
    """Return nanoseconds per sample of both emitters and their ratio: the shortest times of all rounds.

    All cores take part, so whatever else the machine does makes times longer by up to a factor of two.
    """
    use_variant(VARIANT)
    positions, normals = points(count, np.random.default_rng(SEED))
    surface = dr.zeros(mi.SurfaceInteraction3f, count)
    surface.p, surface.n = mi.Point3f(positions.T), mi.Normal3f(normals.T)
    surface.sh_frame = mi.Frame3f(mi.Vector3f(normals.T))
    numbers = mi.Point2f(np.random.default_rng(SEED + 1).random((2, count)).astype(np.float32))
    dr.eval(surface, numbers)
    times = np.array([[seconds(one, surface, numbers) for one in (BUILT_IN, OURS)] for _ in range(rounds)])
    area, ours = times.min(axis=0) / count * 1e9
    return {
        **about("make report", str(SEED)),
        "variant": VARIANT,
        "samples": count,
        "rounds": rounds,
        "area_nanoseconds": area,
        "spherecap_nanoseconds": ours,
        "ratio": ours / area,
    }


def recorded(folder: Path, count: int, rounds: int) -> dict:
    """Return what `measure` found for this emitter's binary, now or before."""
    file = folder / f"recorded-{key_of(plugin_files(), [count, rounds])}.json"
    if not file.exists():
        draft = file.with_suffix(".new")
        draft.write_text(json.dumps(measure(count, rounds), indent=1))
        draft.replace(file)
    return json.loads(file.read_text())
