"""Noise of each method over all caps."""

import matplotlib.pyplot as plt
import numpy as np
from matplotlib.colors import LogNorm

from report.bound import map_axes
from report.page import Section, figure

METHODS = ("solid_angle", "published", "projected_bounded", "projected")


def draw(maps: dict) -> plt.Figure:
    """Draw a panel for each method."""
    data = maps["deviation_maps"]
    drawing, axes = plt.subplots(2, 2, figsize=(12, 8), sharex=True, sharey=True, layout="constrained")
    for place, method in zip(axes.flat, METHODS, strict=True):
        values = np.array(data[method], dtype=float)
        mesh = place.pcolormesh(
            data["elevation"], data["radius"], values, cmap="magma", norm=LogNorm(1e-8, 10), rasterized=True
        )
        map_axes(place)
        place.set_title(method, fontsize=10)
        place.label_outer()
    drawing.colorbar(mesh, ax=axes, extend="max", label="relative standard deviation of cosine / density")
    return drawing


def section(maps: dict) -> Section:
    """Return the figure."""
    data = maps["deviation_maps"]
    values = {method: np.array(data[method], dtype=float) for method in METHODS}
    seen = np.isfinite(values["projected"])
    missing = {method: np.mean(~np.isfinite(values[method][seen])) for method in METHODS}
    parts = [
        f"<code>{method}</code>: median {np.nanmedian(values[method]):.2g}, largest "
        f"{np.nanmax(values[method]):.2g}" + (f", none in {missing[method]:.1%}" if missing[method] else "")
        for method in METHODS
    ]
    caption = (
        "Noise of one sample of a diffuse surface that sees the light unoccluded, in f32 as it runs (for "
        "<code>solid_angle</code> its integral): the relative standard deviation of cosine over density. "
        f"{'; '.join(parts)}. Around 1e-8 to 1e-7 is what rounding leaves."
    )
    return Section("noise", "Noise over all caps", figure(draw(maps), "deviation-maps", caption, maps))
