"""Measure what the choice among several lights gains: equal-time ratios against the built-in emitter.

Each scene is rendered with `area` and with `spherecap`, whose lights are chosen by what each gives to the
point (`lights` = `all`) or, as Mitsuba does, blindly (`one`). The camera sees no light, and the integrator
samples lights alone, except where the name of the scene says otherwise: the noise is the emitters' own.

A ratio is the variance between renders with different seeds, times the processor time of a render, for `area`
over the same for ours: how much longer `area` takes to be as good. Renders take turns; the shortest counts.
"""

import argparse
import gc
import sys
import time
from collections.abc import Callable
from dataclasses import dataclass, field

import numpy as np
from renderlab.scenes import render_stack  # before Mitsuba
from spherecap_command.errors import UserError
from spherecap_command.scene import BUILT_IN, OURS, use_variant

import drjit as dr  # isort: skip
import mitsuba as mi  # isort: skip

# What lights a sphere: the emitter, without its radiance.
Emitter = dict[str, str]
EMITTERS: dict[str, Emitter] = {
    BUILT_IN: {"type": BUILT_IN},
    "one": {"type": OURS, "lights": "one"},
    "all": {"type": OURS, "lights": "all"},
}
VARIANTS = ("scalar_rgb", "llvm_ad_rgb")

LIGHTS_ALONE = {"type": "direct", "emitter_samples": 1, "bsdf_samples": 0, "hide_emitters": True}
PATH = {"type": "path", "max_depth": 4, "hide_emitters": True}


@dataclass(frozen=True)
class Light:
    """A sphere of uniform radiance."""

    centre: tuple[float, float, float]
    radius: float
    radiance: tuple[float, float, float]


TWO = (
    Light((-1.2, -0.5, 0.8), 0.25, (6, 4, 3)),
    Light((1.0, 1.4, 1.1), 0.45, (0.6, 1.2, 3)),
)
# Those of scenes/several_lights.xml.
SEVERAL = (
    Light((-1.2, -0.5, 0.8), 0.25, (6, 1.5, 1)),
    Light((1.3, -0.4, 0.05), 0.25, (1.5, 5, 1.2)),
    Light((0.2, 1.4, 1.1), 0.45, (0.6, 1.2, 3)),
    Light((0.1, -0.7, 0.25), 0.05, (60, 50, 30)),
)
# Ten behind the wall, each a hundred times as bright as the two before it.
WALLED = (
    *(Light((-2 + 0.45 * i, 1.2, 1.2), 0.15, (200, 200, 200)) for i in range(10)),
    *(Light((x, -0.6, 0.8), 0.15, (2, 2, 2)) for x in (-0.8, 0.8)),
)


def scattered(count: int) -> tuple[Light, ...]:
    """Return lights of many sizes, radiances and colours, the smaller ones brighter, all over the floor."""
    random = np.random.default_rng(3)
    lights = []
    for _ in range(count):
        radius = np.exp(random.uniform(np.log(0.04), np.log(0.3)))
        x, y, z = random.uniform([-3, -3, 0], [3, 3, 2])
        brightness = np.exp(random.uniform(np.log(0.5), np.log(5))) * 0.1 / radius * 8 / np.sqrt(count)
        colour = random.uniform(0.3, 1, 3)
        # None is hidden in the floor by more than two fifths of its radius, seen from its centre.
        centre = (float(x), float(y), float(max(z, 0.6 * radius)))
        lights.append(Light(centre, float(radius), tuple((brightness * colour).tolist())))
    return tuple(lights)


def objects() -> dict[str, dict]:
    """Return a ball and a block, which throw shadows."""
    return {
        "ball": {"type": "sphere", "center": [-0.35, 0.1, 0.35], "radius": 0.35, "bsdf": diffuse(0.7)},
        "block": {
            "type": "cube",
            "to_world": mi.ScalarTransform4f().translate([0.7, 0.25, 0.35]).scale([0.25, 0.25, 0.35]),
            "bsdf": diffuse(0.7),
        },
    }


def wall() -> dict[str, dict]:
    """Return a wall across the floor, higher than all lights."""
    to_world = mi.ScalarTransform4f().translate([0, 0.5, 1.5]).scale([6, 0.05, 1.5])
    return {"wall": {"type": "cube", "to_world": to_world, "bsdf": diffuse(0.5)}}


def diffuse(reflectance: float) -> dict:
    """Return a Lambertian BSDF."""
    return {"type": "diffuse", "reflectance": {"type": "rgb", "value": reflectance}}


@dataclass(frozen=True)
class Scene:
    """What stands and shines on a floor, and how it is rendered."""

    lights: tuple[Light, ...]
    others: Callable[[], dict[str, dict]] = objects
    integrator: dict = field(default_factory=lambda: LIGHTS_ALONE)

    def load(self, emitter: Emitter, width: int, spp: int) -> "mi.Scene":
        """Load it, 4 : 3, in the current variant."""
        description = {
            "type": "scene",
            "integrator": self.integrator,
            "sensor": {
                "type": "perspective",
                "fov": 55,
                "to_world": mi.ScalarTransform4f().look_at(
                    origin=[1, -4, 2.8], target=[0, 0.2, 0.3], up=[0, 0, 1]
                ),
                "sampler": {"type": "independent", "sample_count": spp},
                "film": {
                    "type": "hdrfilm",
                    "width": width,
                    "height": width * 3 // 4,
                    "component_format": "float32",
                    "rfilter": {"type": "box"},
                },
            },
            "floor": {
                "type": "rectangle",
                "to_world": mi.ScalarTransform4f().scale(50),
                "bsdf": diffuse(0.6),
            },
            **self.others(),
        }
        for i, light in enumerate(self.lights):
            radiance = {"type": "rgb", "value": list(light.radiance)}
            description[f"light_{i}"] = {
                "type": "sphere",
                "center": list(light.centre),
                "radius": light.radius,
                "emitter": {**emitter, "radiance": radiance},
            }
        return mi.load_dict(description)


SCENES = {
    "2 lights": Scene(TWO),
    "several_lights": Scene(SEVERAL),
    "10 lights": Scene(scattered(10)),
    "100 lights": Scene(scattered(100)),
    "several_lights, path with MIS": Scene(SEVERAL, integrator=PATH),
    "wall": Scene(WALLED, others=wall),
}


def arguments() -> argparse.Namespace:
    """Read the command line."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--scenes", nargs="+", default=list(SCENES), choices=SCENES, metavar="NAME")
    parser.add_argument("--variants", nargs="+", default=VARIANTS, metavar="VARIANT")
    parser.add_argument("--spp", type=int, default=16, help="samples per pixel (default: %(default)s)")
    parser.add_argument("--width", type=int, default=48, help="pixels (default: %(default)s)")
    parser.add_argument("--seeds", type=int, default=16, help="renders of each (default: %(default)s)")
    chosen = parser.parse_args()
    if chosen.spp < 1 or chosen.width < 2 or chosen.seeds < 2:
        parser.error("--spp must be at least 1, --width and --seeds at least 2")
    return chosen


def measure(scene: Scene, width: int, spp: int, seeds: int) -> dict[str, tuple[float, float]]:
    """Return the variance and the shortest processor time, in seconds, of renders with each of `EMITTERS`."""
    images: dict[str, list[np.ndarray]] = {name: [] for name in EMITTERS}
    seconds = dict.fromkeys(EMITTERS, np.inf)
    for seed in range(seeds):
        for name, emitter in EMITTERS.items():
            # One scene at a time: JIT variants trace, in every render, all emitters that there are.
            loaded = scene.load(emitter, width, spp)
            render_stack(loaded, spp, range(seeds, seeds + 1))  # Compilation does not count.
            start = time.process_time()
            images[name].append(render_stack(loaded, spp, range(seed, seed + 1))[0])
            seconds[name] = min(seconds[name], time.process_time() - start)
            del loaded
            gc.collect()
    return {name: (float(np.var(images[name], axis=0, ddof=1).mean()), seconds[name]) for name in EMITTERS}


def main() -> None:
    """Measure all scenes in all variants, and print a table."""
    chosen = arguments()
    dr.set_thread_count(1)  # Threads that wait for each other would count.
    print(f"{chosen.width} x {chosen.width * 3 // 4} pixels, {chosen.spp} spp, {chosen.seeds} seeds")
    print(f"{'':<30} {'':<12} {'equal-time ratio':>17} {'time over area':>17}")
    print(f"{'scene':<30} {'variant':<12} {'one':>8} {'all':>8} {'one':>8} {'all':>8}")
    try:
        for name in chosen.scenes:
            for variant in chosen.variants:
                use_variant(variant)
                found = measure(SCENES[name], chosen.width, chosen.spp, chosen.seeds)
                variance, seconds = found[BUILT_IN]
                ours = [found[lights] for lights in ("one", "all")]
                ratios = [variance * seconds / (v * s) if v > 0 else np.inf for v, s in ours]
                cells = [f"{ratio:8.3g}" for ratio in ratios] + [f"{s / seconds:8.2f}" for _, s in ours]
                print(f"{name:<30} {variant:<12} {' '.join(cells)}", flush=True)
    except UserError as error:
        sys.exit(f"many_lights: {error}")


if __name__ == "__main__":
    main()
