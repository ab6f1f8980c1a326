"""Render all scenes with all renderers, print a table, save numbers, pictures and a page: `make cross`."""

import json
import sys
import time
from concurrent.futures import ProcessPoolExecutor

from renderlab.scenes import OUTPUT
from spherecap_command.errors import UserError
from tqdm import tqdm

from cross.compare import HEIGHT, SEEDS, WIDTH, Series, all_work, measure_scene, targets
from cross.jobs import RENDERERS, Stack, carry_out, check
from cross.page import save_curves, save_page, save_pictures
from cross.scene import SCENES, Scene
from cross.table import table

FOLDER = OUTPUT / "cross"


def evaluate(scene: Scene, stacks: dict[tuple[Series, int], Stack]) -> dict:
    """Measure a scene's renders, save its pictures, and return the numbers."""
    numbers, reference = measure_scene(scene, stacks)
    save_pictures(FOLDER, scene, stacks, reference)
    save_curves(FOLDER, numbers)
    return numbers


def main() -> None:
    """Do it all. The status is 1 where a target is missed or a renderer fails."""
    start = time.perf_counter()
    for renderer in RENDERERS.values():
        check(renderer)
    work = all_work()
    with tqdm(total=len(work), unit="job") as bar:

        def progress(renderer, job) -> None:
            bar.set_description(f"{renderer.name}, {job.scene}, {job.spp} spp", refresh=False)
            bar.update()

        done = carry_out([(x.renderer, x.job(scene, spp)) for x, scene, spp in work], progress=progress)
    stacks = {key: stack for key, stack in zip(work, done, strict=True)}
    by_scene = [
        {(x, spp): stack for (x, where, spp), stack in stacks.items() if where == scene} for scene in SCENES
    ]
    with ProcessPoolExecutor() as pool:
        measuring = pool.map(evaluate, SCENES, by_scene)
        scenes = list(tqdm(measuring, total=len(SCENES), unit="scene", desc="measuring"))
    results = {
        "width": WIDTH,
        "height": HEIGHT,
        "seeds": len(SEEDS),
        "scenes": scenes,
        "targets": targets(scenes),
    }
    (FOLDER / "results.json").write_text(json.dumps(results, indent=1))
    print(table(results))
    print(f"page: {save_page(FOLDER)}; numbers: {FOLDER / 'results.json'}")
    print(f"took {time.perf_counter() - start:.0f} s")
    if not all(target["ok"] for target in results["targets"]):
        sys.exit(1)


if __name__ == "__main__":
    try:
        main()
    except UserError as error:
        sys.exit(f"cross: {error}")
