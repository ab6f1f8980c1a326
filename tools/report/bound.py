"""The paper's Figure 2, from our bound; and how tight the bound is, cap by cap."""

import matplotlib.pyplot as plt
import numpy as np

from report.page import Section, figure

# Limits of 1/s and of the bound: the same curve three times over, as in the paper.
LIMITS = (((1, 3), (1, 4)), ((1, 1.2), (1, 10)), ((1, 1.01), (1, 40)))


def curve(maps: dict) -> plt.Figure:
    """Draw the bound for all caps up to a size."""
    inverse, bound = (np.array(maps["bound_curve"][key]) for key in ("inverse_radius", "bound"))
    drawing, axes = plt.subplots(1, 3, figsize=(12, 3.6), layout="constrained")
    for place, (x, y) in zip(axes, LIMITS, strict=True):
        place.plot(inverse, bound, color="tab:blue")
        place.axhline(np.sqrt(2), color="gray", linestyle=":", linewidth=1)
        place.set(xlim=x, ylim=y, xlabel="distance of the centre over the radius, 1/s")
        place.locator_params(axis="x", nbins=5)
        place.grid(visible=True, alpha=0.3)
    axes[0].set_ylabel("largest over smallest density")
    return drawing


def map_axes(place: plt.Axes) -> None:
    """Label axes of elevation and r/d."""
    place.set(xlabel="elevation of the centre (degrees)", ylabel="s = r/d", xlim=(-90, 90), ylim=(0, 1))
    place.set_xticks(range(-90, 91, 30))
    # Where the cap touches the horizon and where it sets.
    s = np.linspace(0, 1, 200)
    for sign in (-1, 1):
        place.plot(sign * np.degrees(np.arcsin(s)), s, "--", color="gray", linewidth=1)
    place.axvline(0, color="gray", linewidth=0.8)
    place.set_facecolor("#e8e8e8")


def both(maps: dict) -> plt.Figure:
    """Draw the bound and what samples have."""
    data = maps["deviation_maps"]
    drawing, axes = plt.subplots(1, 2, figsize=(12, 4.4), sharey=True, layout="constrained")
    values = {key: np.array(data[key], dtype=float) for key in ("bound", "spread")}
    for place, (key, title) in zip(
        axes, {"bound": "bound, equation (4)", "spread": "of 576 samples"}.items(), strict=True
    ):
        mesh = place.pcolormesh(
            data["elevation"], data["radius"], values[key], cmap="viridis", vmin=1, vmax=3, rasterized=True
        )
        map_axes(place)
        place.set_title(title, fontsize=10)
    drawing.colorbar(mesh, ax=axes, extend="max", label="largest over smallest density")
    return drawing


def section(maps: dict) -> Section:
    """Return the figures."""
    inverse, bound = (np.array(maps["bound_curve"][key]) for key in ("inverse_radius", "bound"))
    below = inverse[bound < 2].min()
    flat = inverse[bound < np.sqrt(2) * (1 + 1e-3)].min()
    data = maps["deviation_maps"]
    ratio = np.array(data["spread"], dtype=float) / np.array(data["bound"], dtype=float)
    first = (
        "The paper's Figure 2, remade: the largest ratio of the densities that "
        "<code>projected_bounded</code> (the paper's "
        "warp) has within any cap up to the size s = r/d. It goes to infinity on the sphere's surface, "
        "is below two "
        f"from 1/s = {below:.3f} on and within a thousandth of its floor of √2 from 1/s = {flat:.2f} on "
        "(the paper: 1.094 and 2). The densities of <code>projected</code> do not vary."
    )
    second = (
        "The same, cap by cap: left the bound, right the ratio in samples of the f64 map. No cap has "
        "more than "
        f"{np.nanmax(ratio):.3f} of its bound; the median of those in case 3 has "
        f"{np.nanmedian(ratio[np.array(data['bound'], dtype=float) > 1]):.3f} of it. Dashed: where the "
        "cap touches the horizon "
        "(right) and sets (left); grey: nothing to be seen."
    )
    return Section(
        "bound",
        "The bound on the density",
        figure(curve(maps), "figure-2", first, maps) + figure(both(maps), "bound-map", second, maps),
    )
