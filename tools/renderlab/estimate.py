"""Tests of equality for rendered images.

All tests work on stacks: independent renders of one scene that differ in their seed, shape (renders, ...).
Their spread gives the variance of their mean without any assumption on the scene.
"""

from dataclasses import dataclass

import numpy as np
from scipy import stats

# Largest relative bias that rounding may cause: single-precision kernels are held to 1e-5, and the film,
# which adds samples in single precision, was measured to be off by 8e-7 at 1024 samples per pixel, 3.2e-6
# at 4096.
ROUNDING = 1.4e-5


@dataclass(frozen=True)
class Estimate:
    """A mean with the variance of that mean; `freedom` degrees of freedom went into the variance."""

    mean: np.ndarray
    variance: np.ndarray
    freedom: int

    @staticmethod
    def from_stack(stack: np.ndarray) -> "Estimate":
        """Estimate from independent renders along the first axis."""
        count = len(stack)
        return Estimate(stack.mean(axis=0), stack.var(axis=0, ddof=1) / count, count - 1)

    @staticmethod
    def exact(values: np.ndarray) -> "Estimate":
        """Wrap values that have no noise."""
        return Estimate(values, np.zeros_like(values), 1)

    def dimmed(self, fraction: float = 0.01) -> "Estimate":
        """Return the estimate of an image that is darker by `fraction` everywhere."""
        keep = 1 - fraction
        return Estimate(keep * self.mean, keep**2 * self.variance, self.freedom)


def p_values(a: Estimate, b: Estimate) -> np.ndarray:
    """Return, per value, the probability of a difference at least this large if both have the same mean.

    Welch's t-test: the variances are estimated and differ between techniques. A difference within `ROUNDING`
    proves nothing, so that much is taken off first; it decides alone where neither side has any noise.
    """
    difference = np.abs(a.mean - b.mean)
    excess = np.maximum(difference - ROUNDING * np.maximum(np.abs(a.mean), np.abs(b.mean)), 0.0)
    variance = a.variance + b.variance
    share = np.divide(a.variance, variance, out=np.full_like(variance, 0.5), where=variance > 0)
    freedom = 1 / (share**2 / a.freedom + (1 - share) ** 2 / b.freedom)
    with np.errstate(divide="ignore", invalid="ignore"):
        score = np.where(excess == 0, 0.0, excess / np.sqrt(variance))
    return 2 * stats.t.sf(score, freedom)


def sidak(p: np.ndarray) -> float:
    """Return the probability that the smallest of that many independent p-values is as small as this one."""
    smallest = float(np.min(p))
    return 1.0 if smallest >= 1 else float(-np.expm1(p.size * np.log1p(-smallest)))
