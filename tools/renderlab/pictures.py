"""Pictures for people: tone mapping, the demo's side-by-side sheet, and what a failing test leaves behind."""

from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

import matplotlib
import matplotlib.pyplot as plt
import numpy as np
from spherecap_command.measure import error_scale
from spherecap_command.pictures import densest_crop, exposure, save_exr, to_srgb

matplotlib.use("Agg")  # No display is needed.


def show(axes: plt.Axes, image: np.ndarray, title: str = "", **options: object) -> None:
    """Draw pixels as squares, without axes."""
    axes.imshow(image, interpolation="nearest", **options)
    axes.set_title(title, fontsize=10)
    axes.set_xticks([])
    axes.set_yticks([])


def save_failure(folder: Path, image: np.ndarray, reference: np.ndarray, p: np.ndarray) -> None:
    """Save render, reference, error and p-values of a failed test: EXR files, and all four in one PNG."""
    folder.mkdir(parents=True, exist_ok=True)
    error = image - reference
    for name, values in (("render", image), ("reference", reference), ("error", error), ("p_values", p)):
        save_exr(folder / f"{name}.exr", values)
    figure, axes = plt.subplots(2, 2, figsize=(9, 7), layout="constrained")
    factor = exposure(reference)
    show(axes[0, 0], to_srgb(image, factor), "render")
    show(axes[0, 1], to_srgb(reference, factor), "reference")
    relative = error.mean(axis=-1) / error_scale(reference.mean(axis=-1))
    span = max(float(np.abs(relative).max()), 1e-12)
    show(axes[1, 0], relative, "relative error", cmap="RdBu", vmin=-span, vmax=span)
    figure.colorbar(axes[1, 0].images[0])
    decades = np.log10(np.maximum(p.min(axis=-1), 1e-20))
    show(axes[1, 1], decades, "log10 of p (per pixel)", cmap="magma", vmin=-10, vmax=0)
    figure.colorbar(axes[1, 1].images[0])
    figure.savefig(folder / "sheet.png", dpi=100)
    plt.close(figure)


@dataclass(frozen=True)
class Panel:
    """One column of the demo's sheet; the reference has no error."""

    image: np.ndarray
    label: str


def save_comparison(path: Path, title: str, panels: Sequence[Panel], reference: Panel) -> None:
    """Save the sheet: a column per technique and reference; rows: picture, enlarged crop, relative error."""
    factor = exposure(reference.image)
    luminance = reference.image.mean(axis=-1)
    scale = error_scale(luminance)
    errors = [(panel.image - reference.image).mean(axis=-1) / scale for panel in panels]
    side = reference.image.shape[0] // 4
    visible = np.abs(to_srgb(panels[0].image, factor) - to_srgb(reference.image, factor)).mean(axis=-1)
    rows, columns = densest_crop(visible, side)

    height, width = luminance.shape
    count = len(panels) + 1
    figure, axes = plt.subplots(
        3,
        count,
        figsize=(4.4 * count, 4.4 * (2 * height / width + 1) + 1),
        height_ratios=[height / width, 1, height / width],
        layout="constrained",
    )
    figure.suptitle(title, fontsize=13)
    figure.get_layout_engine().set(rect=(0, 0, 1, 0.98))  # Or the title sits on the labels.
    for column, panel in enumerate([*panels, reference]):
        show(axes[0, column], to_srgb(panel.image, factor), panel.label)
        frame = plt.Rectangle(
            (columns.start, rows.start), side, side, fill=False, color="tab:red", linewidth=1.2
        )
        axes[0, column].add_patch(frame)
        show(axes[1, column], to_srgb(panel.image[rows, columns], factor), "the framed part, enlarged")
    for column, error in enumerate(errors):
        show(axes[2, column], error, "relative error", cmap="RdBu", vmin=-1, vmax=1)
    axes[2, -1].axis("off")
    place = axes[2, -1].inset_axes([0.05, 0.5, 0.9, 0.06])
    bar = figure.colorbar(axes[2, 0].images[0], cax=place, orientation="horizontal")
    bar.set_label("error relative to the reference, clipped at the ends")
    path.parent.mkdir(parents=True, exist_ok=True)
    figure.savefig(path, dpi=100)
    plt.close(figure)
