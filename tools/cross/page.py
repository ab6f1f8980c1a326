"""Pictures, curves and a page. `section` makes the page's part from the numbers and pictures on disk."""

import base64
import html
import json
from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np
from renderlab.pictures import show
from spherecap_command.pictures import exposure, to_srgb

from cross.compare import (
    AREA,
    CYCLES,
    LUXCORE,
    SPHERECAP,
    SPP,
    C,
    Reference,
    Series,
    series_of,
)
from cross.jobs import Stack
from cross.scene import Scene

SHOWN = (AREA, LUXCORE, CYCLES, SPHERECAP, C)
SHOWN_SPP = 4
# One colour per light sampling's home; independent samplers dashed, stratified ones solid.
COLOURS = {"Mitsuba area": "tab:red", "Mitsuba spherecap": "tab:blue", "C spherecap": "tab:cyan"}
COLOURS |= {"LuxCore": "tab:orange", "Cycles": "tab:olive"}


def file_name(scene: str, kind: str) -> str:
    """Return the name of a scene's picture."""
    return f"{scene.replace(' ', '_')}-{kind}.png"


def save_pictures(
    folder: Path, scene: Scene, stacks: dict[tuple[Series, int], Stack], reference: Reference
) -> None:
    """Save what the renderers make of few samples, beside the reference."""
    shown = [series for series in SHOWN if series in series_of(scene)]
    panels = [("reference", reference.image)]
    panels += [(x.label, stacks[x, SHOWN_SPP].images[0]) for x in shown]
    factor = exposure(reference.image[..., None])
    figure, axes = plt.subplots(2, 3, figsize=(10.5, 5.7), layout="constrained")
    figure.suptitle(f"{scene.name}: {SHOWN_SPP} samples per pixel")
    for place, (title, image) in zip(axes.flat, panels, strict=False):
        show(place, to_srgb(image, factor), title, cmap="gray", vmin=0, vmax=1)
    for place in axes.flat[len(panels) :]:
        place.axis("off")
    figure.savefig(folder / file_name(scene.name, "pictures"), dpi=100)
    plt.close(figure)


def save_curves(folder: Path, scene: dict) -> None:
    """Save how errors fall with samples and with time."""
    figure, axes = plt.subplots(1, 2, figsize=(10.5, 4.2), sharey=True, layout="constrained")
    pixels = 128 * 96
    for row in scene["series"]:
        stem, _, sampler = row["label"].partition(", ")
        style = {
            "color": COLOURS[stem],
            "linestyle": "-" if sampler else "--",
            "marker": "o",
            "markersize": 3,
        }
        spp = np.array(row["spp"])
        axes[0].loglog(spp, row["rmse"], label=row["label"], **style)
        axes[1].loglog(spp * row["microseconds_per_sample"] * 1e-6 * pixels, row["rmse"], **style)
    if "jitter_floor" in scene:
        floor = scene["jitter_floor"] / np.sqrt(SPP)
        axes[0].loglog(SPP, floor, "k:", linewidth=1, label="jitter alone, independent")
    axes[0].set_xlabel("samples per pixel")
    axes[1].set_xlabel("CPU seconds per image (samples by time per sample)")
    axes[0].set_ylabel("relative RMSE")
    axes[0].set_title(scene["name"], fontsize=10)
    for place in axes:
        place.grid(visible=True, which="major", alpha=0.3)
    figure.legend(loc="outside right center", fontsize=8)
    figure.savefig(folder / file_name(scene["name"], "curves"), dpi=100)
    plt.close(figure)


def _image(path: Path) -> str:
    data = base64.b64encode(path.read_bytes()).decode()
    return f'<img alt="{html.escape(path.stem)}" src="data:image/png;base64,{data}">'


def _row(cells: list[str], kind: str = "td") -> str:
    return "<tr>" + "".join(f"<{kind}>{html.escape(cell)}</{kind}>" for cell in cells) + "</tr>"


def _scene(folder: Path, scene: dict) -> str:
    heads = [
        "",
        "bias",
        "\N{PLUS-MINUS SIGN} 95 %",
        "99th percentile",
        "of blocks",
        *(f"{n} spp" for n in SPP),
    ]
    heads += ["slope", "\N{MICRO SIGN}s per sample", "work, 1 spp", "work, 64 spp"]
    rows = [_row(heads, "th")]
    for row in scene["series"]:
        cells = [row["label"], "", "", "", ""]
        if "bias" in row:
            known = " (known)" if row["known_wrong"] else ""
            cells[1:] = [
                f"{row['bias']:+.1e}{known}",
                f"{1.96 * row['standard_error']:.0e}",
                f"{row['p99']:.2%}",
                f"{row['p99_blocks']:.2%}",
            ]
        cells += [f"{rmse:.5f}" for rmse in row["rmse"]]
        cells += [f"{row['slope']:.2f}", f"{row['microseconds_per_sample']:.3f}"]
        cells += [f"{1 / row['equal_time'][SPP.index(n)]:.2g}" for n in (1, 64)]
        rows.append(_row(cells))
    jitter = ""
    if "jitter_floor" in scene:
        jitter = (
            f" With exact values, the position in the pixel alone gives {scene['jitter_floor']:.4f} at 1 spp."
        )
    pictures, curves = (_image(folder / file_name(scene["name"], kind)) for kind in ("pictures", "curves"))
    return (
        f"<h3>{html.escape(scene['name'])}</h3>"
        f"<p>{html.escape(scene['about'])}. Reference: {scene['reference']}.{jitter}</p>"
        f"<table>{''.join(rows)}</table>{pictures}{curves}"
    )


def section(folder: Path) -> str:
    """Return the comparison as HTML, from `results.json` and the pictures in a folder."""
    results = json.loads((folder / "results.json").read_text())
    missed = [target for target in results["targets"] if not target["ok"]]
    items = "".join(f"<li>{html.escape(t['name'])}: {html.escape(t['text'])}</li>" for t in missed)
    reached = f"{len(results['targets']) - len(missed)} of {len(results['targets'])} targets reached"
    size = f"{results['width']} \N{MULTIPLICATION SIGN} {results['height']} pixels"
    return (
        f"<p>{size}, {results['seeds']} renders of each with different seeds, on "
        "one thread. Bias is that of the image mean; errors are relative, and RMSE is that of one render at "
        "so many samples per pixel. Work is CPU time until the same error, relative to Mitsuba's "
        "<code>area</code> with the same kind of sampler (independent or stratified).</p>"
        f"<p>{reached}.</p><ul>{items}</ul>{''.join(_scene(folder, scene) for scene in results['scenes'])}"
    )


def save_page(folder: Path) -> Path:
    """Save the section as a page of its own."""
    style = (
        "body{font:15px/1.5 sans-serif;max-width:1080px;margin:2em auto;padding:0 1em}"
        "table{border-collapse:collapse;font-size:12px;font-variant-numeric:tabular-nums;display:block;overflow-x:auto}"
        "td,th{padding:2px 8px;text-align:right;border-bottom:1px solid #ddd}td:first-child{text-align:left}"
        "img{max-width:100%;display:block;margin:8px 0}"
    )
    page = folder / "index.html"
    page.write_text(
        '<!DOCTYPE html><html lang="en"><head><meta charset="utf-8"><title>spherecap across renderers</title>'
        f'<meta name="viewport" content="width=device-width"><style>{style}</style></head>'
        f"<body><h2>Across renderers</h2>{section(folder)}</body></html>\n"
    )
    return page
