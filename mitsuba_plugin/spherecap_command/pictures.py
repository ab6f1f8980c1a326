"""From linear radiance to what a screen shows, and to files."""

from pathlib import Path

import mitsuba as mi
import numpy as np


def exposure(reference: np.ndarray) -> float:
    """Return the factor that keeps all but the brightest twentieth of an image (mostly lamps) below white."""
    bright = np.percentile(reference.mean(axis=-1), 95)
    return 0.8 / max(bright, 1e-12)


def to_srgb(image: np.ndarray, factor: float) -> np.ndarray:
    """Scale linear radiance, clip it to [0, 1] and encode it for a screen."""
    linear = np.clip(image * factor, 0, 1)
    return np.where(linear <= 0.0031308, 12.92 * linear, 1.055 * linear ** (1 / 2.4) - 0.055)


def densest_crop(error: np.ndarray, side: int) -> tuple[slice, slice]:
    """Return the square of side x side pixels with the largest sum of errors: where to look."""
    sums = np.pad(error.cumsum(axis=0).cumsum(axis=1), ((1, 0), (1, 0)))
    totals = sums[side:, side:] - sums[:-side, side:] - sums[side:, :-side] + sums[:-side, :-side]
    row, column = np.unravel_index(np.argmax(totals), totals.shape)
    return slice(row, row + side), slice(column, column + side)


def save_exr(path: Path, image: np.ndarray) -> None:
    """Write linear values in single precision."""
    mi.Bitmap(np.ascontiguousarray(image, dtype=np.float32)).write(str(path))


def save_png(path: Path, image: np.ndarray, factor: float) -> None:
    """Write what a screen shows, with `factor` as exposure."""
    encoded = np.rint(255 * to_srgb(image, factor)).astype(np.uint8)
    mi.Bitmap(np.ascontiguousarray(encoded)).write(str(path))
