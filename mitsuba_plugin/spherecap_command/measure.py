"""Error measures for rendered images: arrays of shape (..., height, width, channels), linear radiance."""

import numpy as np

# Where the reference is darker than a tenth of its mean, errors count relative to that tenth. Otherwise the
# rare bright sample in an almost black penumbra decides everything: one such pixel made three quarters of
# an image's error.
DARK = 0.1


def error_scale(reference: np.ndarray, dark: float = DARK) -> np.ndarray:
    """Return what errors are relative to: the reference, or where it is darker, `dark` times its mean."""
    return np.sqrt(reference**2 + (dark * reference.mean()) ** 2)


def relative_mse(
    image: np.ndarray, reference: np.ndarray, mask: np.ndarray | None = None, dark: float = DARK
) -> np.ndarray:
    """Return the mean squared error relative to the reference, for each image of a stack (..., h, w, c).

    mask: the pixels that count, shape (h, w); all by default. dark: see `error_scale`.
    """
    squared = (image - reference) ** 2 / error_scale(reference, dark) ** 2
    return squared.mean(axis=(-3, -2, -1)) if mask is None else squared[..., mask, :].mean(axis=(-2, -1))


def relative_rmse(
    image: np.ndarray, reference: np.ndarray, mask: np.ndarray | None = None, dark: float = DARK
) -> float:
    """Return the root of the relative mean squared error, for a stack the root of its mean."""
    return float(np.sqrt(np.mean(relative_mse(image, reference, mask, dark))))
