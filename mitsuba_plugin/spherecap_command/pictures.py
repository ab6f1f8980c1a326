"""From linear radiance to what a screen shows, and to files."""

from dataclasses import dataclass
from pathlib import Path

import mitsuba as mi
import numpy as np

# Where the middle of an image of high contrast shall lie: the mid-grey of photography.
MIDDLE = 0.18


@dataclass(frozen=True)
class Exposure:
    """How linear radiance becomes brightness between 0 and 1: times `factor`, and `white` is then white.

    If white is 1, that is all; if it is more, bright parts are pressed together (extended Reinhard curve).
    """

    factor: float
    white: float

    def __call__(self, image: np.ndarray) -> np.ndarray:
        """Return linear values in [0, 1]."""
        scaled = np.maximum(image * self.factor, 0)
        return np.minimum(scaled * (1 + scaled / self.white**2) / (1 + scaled), 1)


def exposure(reference: np.ndarray) -> Exposure:
    """Return the exposure that suits an image, whose brightest twentieth of lit pixels is white.

    Where contrast is so high that the middle of the image would be black, that is made mid-grey.
    """
    luminance = reference.mean(axis=-1)
    lit = luminance[luminance > 0]
    if lit.size == 0:
        return Exposure(1, 1)
    bright, middle = np.percentile(lit, [95, 50])
    factor = max(0.8 / bright, MIDDLE / middle)
    return Exposure(factor, factor * bright / 0.8)


def to_srgb(image: np.ndarray, exposed: Exposure) -> np.ndarray:
    """Expose linear radiance, and encode it for a screen: values in [0, 1]."""
    linear = exposed(image)
    return np.where(linear <= 0.0031308, 12.92 * linear, 1.055 * linear ** (1 / 2.4) - 0.055)


def signed(error: np.ndarray) -> np.ndarray:
    """Return colours (..., 3) in [0, 1] for errors: -1 and less is blue, 0 white, 1 and more red."""
    strength = np.minimum(np.abs(error), 1)[..., None]
    end = np.where(error[..., None] > 0, [0.70, 0.05, 0.10], [0.05, 0.25, 0.65])
    return 1 + strength * (end - 1)


def densest_crop(error: np.ndarray, side: int) -> tuple[slice, slice]:
    """Return the square of side x side pixels with the largest sum of errors: where to look."""
    sums = np.pad(error.cumsum(axis=0).cumsum(axis=1), ((1, 0), (1, 0)))
    totals = sums[side:, side:] - sums[:-side, side:] - sums[side:, :-side] + sums[:-side, :-side]
    row, column = np.unravel_index(np.argmax(totals), totals.shape)
    return slice(row, row + side), slice(column, column + side)


def save_exr(path: Path, image: np.ndarray) -> None:
    """Write linear values in single precision."""
    mi.Bitmap(np.ascontiguousarray(image, dtype=np.float32)).write(str(path))


def save_png(path: Path, encoded: np.ndarray) -> None:
    """Write what a screen shows: values in [0, 1]."""
    mi.Bitmap(np.ascontiguousarray(np.rint(255 * encoded).astype(np.uint8))).write(str(path))
