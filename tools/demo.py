"""Render a scene with the built-in emitter and with spherecap at equal sample counts, and compare.

Prints a table and saves a labelled picture under out/. `make demo` runs it; see --help for the choices.
"""

import argparse
import sys
from functools import partial
from pathlib import Path

from renderlab.pictures import Panel, save_comparison
from renderlab.reference import SPP, needs_rendering, reference
from renderlab.scenes import OUTPUT, load_scene, scene_file, scene_names
from spherecap_command.compare import compare, samples_to_render, table
from spherecap_command.errors import UserError
from spherecap_command.scene import ParsedScene, use_variant
from tqdm import tqdm


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


def demo(scene: str, variant: str, spp: int, width: int, picture: Path | None) -> None:
    """Run the whole comparison."""
    scene_file(scene)  # Before anything slow: is there such a scene, such a variant?
    use_variant(variant)
    height = width * 3 // 4
    to_render = SPP if needs_rendering(scene, width, height) else 0
    with tqdm(total=samples_to_render([spp], to_render), unit=" spp") as bar:
        truth = reference(scene, width, height, bar.update)
        load = partial(load_scene, scene, spp=spp, width=width, height=height)
        results = compare(load, [spp], bar.update)
    title = f"{scene}: {spp} samples per pixel, {width} x {height}, {variant}"
    print(f"\n{title}; reference: {truth.origin}\n{table(results, truth)}")
    if ParsedScene(scene_file(scene), {}).integrator.get("hide_emitters", False):
        title += "\nThe light itself is hidden (hide_emitters), and so black: what counts is what it lights."
    path = picture or OUTPUT / "demo" / f"{scene}-{spp}spp-{variant}.png"
    panels = [Panel(one.image, f"{one.technique}   (relative RMSE {one.rmse(truth):.3g})") for one in results]
    save_comparison(path, title, panels, Panel(truth.image, f"reference ({truth.origin})"))
    print(f"picture: {path}")


def main() -> None:
    """Run, and turn mistakes that the user can put right into one line."""
    chosen = arguments()
    try:
        demo(chosen.scene, chosen.variant, chosen.spp, chosen.width, chosen.picture)
    except UserError as error:
        sys.exit(f"demo: {error}")


if __name__ == "__main__":
    main()
