"""Render a scene with the built-in emitter and with spherecap at equal sample counts, and compare.

Prints a table and saves a labelled picture under out/. `make demo` runs it; see --help for the choices.
"""

import argparse
import gc
import sys
import time
from dataclasses import dataclass, field
from pathlib import Path

import numpy as np
from renderlab.estimate import error_scale, relative_mse
from renderlab.pictures import Panel, save_comparison
from renderlab.reference import PASSES, Reference, needs_rendering, reference
from renderlab.scenes import (
    BUILT_IN,
    OURS,
    OUTPUT,
    LabError,
    load_scene,
    register_plugin,
    render,
    scene_file,
    scene_names,
    use_variant,
)
from tqdm import tqdm

# Time is measured over this many renders with different seeds, and the error over all of them.
RENDERS = 4


@dataclass
class Run:
    """The images of one technique so far, and the seconds they took."""

    images: list[np.ndarray] = field(default_factory=list)
    seconds: float = 0.0


@dataclass(frozen=True)
class Result:
    """One technique: its first image, seconds per render, and relative RMSE over all renders."""

    technique: str
    image: np.ndarray
    seconds: float
    rmse: float


def arguments() -> argparse.Namespace:
    """Read the command line."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--scene", default="cut_light", help=f"one of: {', '.join(scene_names())}")
    parser.add_argument("--variant", default="scalar_rgb", help="variant of Mitsuba (default: %(default)s)")
    parser.add_argument("--spp", type=int, default=16, help="samples per pixel (default: %(default)s)")
    parser.add_argument(
        "--width", type=int, default=256, help="pixels; height is 3/4 of it (default: %(default)s)"
    )
    parser.add_argument("--picture", type=Path, help="file for the picture (default: in out/demo)")
    chosen = parser.parse_args()
    if chosen.spp < 1 or chosen.width < 16:
        parser.error("--spp must be at least 1 and --width at least 16")
    return chosen


def rmse_against(stack: list[np.ndarray], truth: Reference) -> float:
    """Return the relative RMSE of some renders, less what the reference's own noise adds to it."""
    own = np.mean((truth.variance / error_scale(truth.image) ** 2)[truth.trusted])
    measured = np.mean(relative_mse(np.stack(stack), truth.image, truth.trusted))
    return float(max(measured - own, 0.0)) ** 0.5


def table(results: list[Result]) -> str:
    """Return the comparison as text; the first result is what the others are compared with."""
    base = results[0]
    lines = [
        f"{'technique':<12} {'s/render':>9} {'rel. RMSE':>10} {'ratio':>7} {'equal-time efficiency':>22}"
    ]
    for one in results:
        ratio = base.rmse / one.rmse if one.rmse > 0 else np.inf
        gain = ratio**2 * base.seconds / one.seconds
        lines.append(f"{one.technique:<12} {one.seconds:9.3f} {one.rmse:10.4f} {ratio:6.2f}x {gain:21.2f}x")
    lines.append(
        f"ratio: RMSE of {base.technique} over its own, at equal samples; efficiency: 1 / (RMSE^2 time)"
    )
    return "\n".join(lines)


def compare(scene: str, variant: str, spp: int, width: int, picture: Path | None) -> None:
    """Run the whole comparison."""
    scene_file(scene)  # Before anything slow: is there such a scene, variant, plugin?
    use_variant(variant)
    register_plugin()
    height = width * 3 // 4
    techniques = (BUILT_IN, OURS)
    passes = PASSES if needs_rendering(scene, width, height) else 0
    with tqdm(total=passes + RENDERS * len(techniques), unit="render") as bar:
        bar.set_description("reference")
        truth = reference(scene, width, height, bar.update)
        runs = {technique: Run() for technique in techniques}
        # In turns, so that whatever else the machine does slows both alike. One scene at a time, because JIT
        # variants compile all that may be called: every emitter that there is.
        for seed in range(1, RENDERS + 1):
            for technique, run in runs.items():
                bar.set_description(technique)
                loaded = load_scene(scene, technique, spp=spp, width=width, height=height)
                render(loaded, spp, seed=0)  # Caches and, in JIT variants, compilation do not count.
                start = time.perf_counter()
                run.images.append(render(loaded, spp, seed))
                run.seconds += time.perf_counter() - start
                del loaded
                gc.collect()
                bar.update()
    results = [
        Result(technique, run.images[0], run.seconds / RENDERS, rmse_against(run.images, truth))
        for technique, run in runs.items()
    ]
    title = f"{scene}: {spp} samples per pixel, {width} x {height}, {variant}"
    print(f"\n{title}; reference: {truth.origin}\n{table(results)}")
    path = picture or OUTPUT / "demo" / f"{scene}-{spp}spp-{variant}.png"
    panels = [Panel(one.image, f"{one.technique}   (relative RMSE {one.rmse:.3g})") for one in results]
    save_comparison(path, title, panels, Panel(truth.image, f"reference ({truth.origin})"))
    print(f"picture: {path}")


def main() -> None:
    """Run, and turn mistakes that the user can put right into one line."""
    chosen = arguments()
    try:
        compare(chosen.scene, chosen.variant, chosen.spp, chosen.width, chosen.picture)
    except LabError as error:
        sys.exit(f"demo: {error}")


if __name__ == "__main__":
    main()
