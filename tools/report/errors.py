"""Errors of single precision over all caps, sizes from 1e-6 to all but touching."""

import matplotlib.pyplot as plt
import numpy as np
from matplotlib.colors import LogNorm

from report.page import Section, figure

METHODS = ("published", "projected_bounded", "projected")
KINDS = {
    "area": "projected solid angle, relative",
    "density": "reported density, relative",
    "position": "position, in cap radii",
    "inverse": "inverse of a sample",
    "lost": "share of lost samples",
}


def draw(data: dict) -> plt.Figure:
    """Draw a row for each kind of error and a column for each method."""
    drawing, axes = plt.subplots(
        len(KINDS), len(METHODS), figsize=(12, 15), sharex=True, sharey=True, layout="constrained"
    )
    s, rest = np.array(data["radius"]), np.array(data["radius_complement"])
    rows = np.log10(s / rest)
    for line, (kind, name) in zip(axes, KINDS.items(), strict=True):
        norm = plt.Normalize(0, 1) if kind == "lost" else LogNorm(1e-8, 1)
        for place, method in zip(line, METHODS, strict=True):
            values = np.array(data[method][kind], dtype=float)
            place.set_facecolor("#bbbbbb")
            if np.isfinite(values).any():
                mesh = place.pcolormesh(
                    data["column"], rows, values, cmap="inferno", norm=norm, rasterized=True
                )
            else:
                place.text(0.5, 0.5, "not computed", ha="center", transform=place.transAxes)
            for edge in (0, 1):
                place.axvline(edge, color="w", linewidth=0.6)
            place.set_title(f"{method}: {name}", fontsize=9)
        drawing.colorbar(mesh, ax=line, extend="neither" if kind == "lost" else "both")
        line[0].set_ylabel("s = r/d")
        line[0].set_yticks([-6, -4, -2, 0, 2, 4, 6])
        line[0].set_yticklabels(["1e-6", "1e-4", "0.01", "0.5", "0.99", "1 - 1e-4", "1 - 1e-6"])
    for place in axes[-1]:
        place.set_xticks([-1, 0, 1, 2])
        first, *_, last = place.set_xticklabels(["sets", "centre on\nhorizon", "touches\nhorizon", "zenith"])
        first.set_horizontalalignment("left")
        last.set_horizontalalignment("right")
    return drawing


def section(maps: dict) -> Section:
    """Return the figure, and its numbers as a table."""
    data = maps["error_maps"]
    heads = "".join(f"<th>{name}</th>" for name in KINDS.values())
    lines = []
    for method in METHODS:
        cells = []
        for kind in KINDS:
            values = np.array(data[method][kind], dtype=float)
            if not np.isfinite(values).any():
                cells.append("<td></td>")
            elif kind == "lost":
                cells.append(f"<td>{np.nanmean(values):.2%}</td>")
            else:
                median, high, worst = np.nanpercentile(values, (50, 99, 100))
                cells.append(f"<td>{median:.1e} / {high:.1e} / {worst:.1e}</td>")
        lines.append(f"<tr><td>{method}</td>{''.join(cells)}</tr>")
    caption = (
        "Errors of f32 against the same map in f64 with the same inputs, the normal in random "
        "directions. Each pixel "
        f"is the worst of {data['samples']} samples. The position is that of the offset where the method "
        "returns "
        "one (ours), else of the unit direction, which small caps are too small for; the inverse is our "
        "own in f32, for the "
        "published method the exact one. Lost: NaN, or farther than a hundredth of the cap's radius "
        "outside of what is to be "
        "seen. Grey: none is left to measure. To the left of the first white line is case 3, between "
        "them case 2, "
        "to the right case 1."
    )
    return Section(
        "errors",
        "Errors in single precision",
        figure(draw(data), "error-maps", caption, maps)
        + f"<p>Median, 99th percentile and worst of the pixels; of lost samples the mean:</p>"
        f"<table><tr><th></th>{heads}</tr>{''.join(lines)}</table>",
    )
