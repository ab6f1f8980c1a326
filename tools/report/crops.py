"""Pictures side by side: `area`, ours, the reference."""

import json
from collections.abc import Callable
from dataclasses import asdict
from pathlib import Path

from renderlab.pictures import Panel, save_comparison
from renderlab.reference import reference
from renderlab.scenes import load_scene
from spherecap_command.compare import render
from spherecap_command.measure import relative_rmse
from spherecap_command.scene import BUILT_IN, OURS, use_variant

from report.convergence import size
from report.data import about
from report.page import Section, picture
from report.renders import Settings, cache_file, reference_samples

SEED = 1


def files(folder: Path, scene: str, settings: Settings) -> tuple[Path, Path]:
    """Return where a picture and what is said of it are kept."""
    kept = cache_file(folder, scene, settings)
    return kept.with_suffix(".png"), kept


def samples_to_render(folder: Path, settings: Settings) -> int:
    """Return how many samples per pixel are still to be taken, for a progress bar."""
    use_variant(settings.variant)
    missing = [scene for scene in settings.scenes if not files(folder, scene, settings)[1].exists()]
    return 2 * len(missing) * settings.spp[0] + reference_samples(missing, settings)


def compare(folder: Path, scene: str, settings: Settings, advance: Callable[[int], object]) -> None:
    """Render one scene with both emitters and keep the sheet."""
    (spp,) = settings.spp
    truth = reference(scene, settings.width, settings.height, advance)
    panels, errors = [], {}
    for emitter in (BUILT_IN, OURS):
        loaded = load_scene(scene, emitter, width=settings.width, height=settings.height)
        image = render(loaded, spp, SEED)
        errors[emitter] = relative_rmse(image, truth.image, truth.trusted)
        panels.append(Panel(image, f"{emitter}   (relative RMSE {errors[emitter]:.3g})"))
        advance(spp)
    sheet, kept = files(folder, scene, settings)
    draft = sheet.with_suffix(".new.png")
    title = f"{scene}: {spp} samples per pixel"
    save_comparison(draft, title, panels, Panel(truth.image, f"reference ({truth.origin})"))
    draft.replace(sheet)
    kept.write_text(json.dumps({"errors": errors, "about": about("make report", str(SEED))}))


def section(folder: Path, settings: Settings, advance: Callable[[int], object]) -> Section:
    """Return the sheets, rendering those that are missing."""
    use_variant(settings.variant)
    folder.mkdir(parents=True, exist_ok=True)
    parts = []
    for scene in settings.scenes:
        sheet, kept = files(folder, scene, settings)
        if not kept.exists():
            compare(folder, scene, settings, advance)
        found = json.loads(kept.read_text())
        area, ours = (found["errors"][emitter] for emitter in (BUILT_IN, OURS))
        caption = (
            f"{scene}: relative RMSE {area:.3g} with <code>area</code>, {ours:.3g} with "
            "<code>spherecap</code>, "
            f"both with {settings.spp[0]} samples per pixel, {size(asdict(settings))}, "
            f"{settings.variant}. The middle row enlarges where they differ most."
        )
        parts.append(picture(sheet.read_bytes(), f"crops-{scene}", caption, found["about"]))
    return Section("crops", "Pictures side by side", "".join(parts))
