"""What scenes gain at equal time, measured as `spherecap compare` does.

That needs no reference, and only one scene exists at a time.
"""

import gc

import many_lights
import numpy as np
from renderlab.scenes import load_scene, scene_names
from spherecap_command.compare import compare, equal_time, mean_of_all
from spherecap_command.scene import BUILT_IN, use_variant

import drjit as dr  # isort: skip (after what tells it where LLVM is)

SPP = 16
# Its light is seen so small that with `area` it renders black.
LEFT_OUT = "tiny_far_light"
# Variants, and a width at which a render takes a second or so, so that what is done once does not count.
WIDTHS = {"scalar_rgb": 192, "llvm_ad_rgb": 512}
# As `make lights` has them, but with fewer renders.
LIGHTS_WIDTH, LIGHTS_SEEDS = 48, 8


def scenes() -> list[dict]:
    """Measure the scenes of this repository: ratios of `area` over `spherecap`."""
    rows = []
    for variant, width in WIDTHS.items():
        use_variant(variant)
        for name in scene_names():
            if name == LEFT_OUT:
                continue
            size = {"width": width, "height": width * 3 // 4}
            # Lambdas are called within this turn of the loop.
            results = compare(lambda emitter: load_scene(name, emitter, **size), [SPP], lambda _: None)  # noqa: B023
            truth = mean_of_all(results)
            area, ours = results
            rows.append(
                {
                    "scene": name,
                    "variant": variant,
                    "error": area.rmse(truth) / ours.rmse(truth),
                    "time": ours.seconds / area.seconds,
                    "equal_time": equal_time(area, ours, truth),
                }
            )
            print(f"{variant} {name}: {rows[-1]['equal_time']:.3g}", flush=True)
            gc.collect()
    return rows


def lights() -> list[dict]:
    """Measure scenes with several lights, in which the choice among them counts, in `scalar_rgb`."""
    use_variant("scalar_rgb")
    before = dr.thread_count()
    dr.set_thread_count(1)  # as there: threads that wait for each other would count
    rows = []
    for name, scene in many_lights.SCENES.items():
        found = many_lights.measure(scene, LIGHTS_WIDTH, SPP, LIGHTS_SEEDS)
        variance, seconds = found[BUILT_IN]
        ratios = {way: variance * seconds / (v * s) for way, (v, s) in found.items() if way != BUILT_IN}
        rows.append({"scene": name, **ratios})
        print(f"{name}: {ratios['all']:.3g}", flush=True)
    dr.set_thread_count(before)
    return rows


def median_time(rows: list[dict], variant: str) -> float:
    """Return the time of a render over that with `area` at equal samples, the median of the scenes."""
    return float(np.median([row["time"] for row in rows if row["variant"] == variant]))
