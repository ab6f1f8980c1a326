"""How the error of pictures falls, with samples and with time."""

import matplotlib.pyplot as plt
import numpy as np
from matplotlib.axis import Axis
from matplotlib.ticker import LogLocator, NullFormatter
from scipy import stats

from report.page import COLOURS, Section, figure
from report.renders import METHODS


def band(squared: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Return RMSE and its 95 % interval over seeds, the last axis: a t-interval of the logarithm.

    Where a picture agrees with the reference to within the reference's noise, the error is not known: NaN.
    """
    with np.errstate(divide="ignore", invalid="ignore"):
        logs = np.log(np.where(squared > 0, squared, np.nan)) / 2
    mean, count = logs.mean(axis=-1), logs.shape[-1]
    half = stats.t.ppf(0.975, count - 1) * logs.std(axis=-1, ddof=1) / np.sqrt(count)
    return np.exp(mean), np.exp(mean - half), np.exp(mean + half)


def spans_little(axis: Axis) -> bool:
    """Tell whether powers of ten alone would leave an axis with hardly a label."""
    low, high = axis.get_view_interval()
    return high < 200 * low


def draw(result: dict) -> plt.Figure:
    """Draw a scene: against samples, and against time."""
    spp = np.array(result["settings"]["spp"])
    drawing, axes = plt.subplots(1, 2, figsize=(11, 3.9), sharey=True, layout="constrained")
    for method in METHODS:
        rmse, low, high = band(np.array(result["methods"][method]["squared"]))
        seconds = np.median(result["methods"][method]["seconds"], axis=-1)
        for place, x in zip(axes, (spp, seconds), strict=True):
            place.loglog(x, rmse, "o-", color=COLOURS[method], markersize=3, linewidth=1, label=method)
            place.fill_between(x, low, high, color=COLOURS[method], alpha=0.25, linewidth=0)
    axes[0].set_xticks(spp, [str(n) for n in spp])
    axes[0].set_xticks([], minor=True)
    axes[0].set(xlabel="samples per pixel", ylabel="relative RMSE")
    axes[1].set_xlabel("seconds per picture (median)")
    for axis in (axes[0].yaxis, axes[1].xaxis):
        axis.set_major_locator(LogLocator(subs=(1, 2, 5) if spans_little(axis) else (1,)))
        axis.set_major_formatter("{x:g}")
        axis.set_minor_formatter(NullFormatter())
    for place in axes:
        place.grid(visible=True, which="major", alpha=0.3)
    drawing.suptitle(result["scene"], fontsize=11)
    drawing.legend(*axes[0].get_legend_handles_labels(), loc="outside right center", frameon=False)
    return drawing


def size(settings: dict) -> str:
    """Return the size of pictures in words."""
    return f"{settings['width']} \N{MULTIPLICATION SIGN} {settings['height']} pixels"


def gains(result: dict) -> dict[str, tuple[float, float]]:
    """Return, for each technique, `area`'s RMSE over its own at the most samples, and likewise MSE x time."""
    found = {}
    for method in METHODS:
        squared = np.mean(result["methods"][method]["squared"][-1])
        found[method] = (max(squared, 0.0), np.median(result["methods"][method]["seconds"][-1]))
    area = found.pop(METHODS[0])
    return {
        method: ((area[0] / squared) ** 0.5, area[0] * area[1] / (squared * seconds))
        for method, (squared, seconds) in found.items()
        if squared > 0
    }


def section(results: list[dict]) -> Section:
    """Return a figure for each scene."""
    parts = []
    for result in results:
        settings = result["settings"]
        texts = [
            f"<code>{method}</code> {ratio:.2f} times ({gain:.2f})"
            for method, (ratio, gain) in gains(result).items()
        ]
        noise = (
            f" with an error of {result['reference_error']:.2g} of its own, which is taken off"
            if result["reference_error"]
            else ""
        )
        caption = (
            f"RMSE relative to the reference ({result['reference']}{noise}), {size(settings)}, "
            f"{settings['variant']}; bands: 95 % of the mean over {settings['seeds']} seeds. At "
            f"{settings['spp'][-1]} samples per pixel the error of <code>area</code> is, over that of: "
            f"{'; '.join(texts)} (in parentheses: how many times less time for the same error)."
        )
        parts.append(figure(draw(result), f"convergence-{result['scene']}", caption, result["about"]))
    return Section("convergence", "Convergence of pictures", "".join(parts))
