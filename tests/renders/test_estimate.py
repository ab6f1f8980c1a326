"""The statistics on made-up images, where the truth is known."""

import numpy as np
from renderlab.estimate import ROUNDING, Estimate, p_values, sidak
from scipy import stats
from spherecap_command.measure import relative_rmse


def noisy_stack(seed: int, mean: float = 1.0, deviation: float = 0.1, renders: int = 32) -> np.ndarray:
    """Return made-up renders with normal noise."""
    return np.random.default_rng(seed).normal(mean, deviation, (renders, 48, 64, 3))


def test_p_values_are_uniform_when_means_are_equal() -> None:
    """Kolmogorov-Smirnov over 9216 values at fixed seeds; unequal variances, as between techniques."""
    a, b = noisy_stack(1, deviation=0.3), noisy_stack(2, deviation=0.1)
    p = p_values(Estimate.from_stack(a), Estimate.from_stack(b))
    assert stats.kstest(p.ravel(), "uniform").pvalue > 0.01


def test_sidak_of_many_equal_means_is_unremarkable_and_of_one_outlier_is_not() -> None:
    """The correction for the number of values: neither too lax nor too strict."""
    a, b = Estimate.from_stack(noisy_stack(3)), Estimate.from_stack(noisy_stack(4))
    assert sidak(p_values(a, b)) > 0.01
    b.mean[5, 7, 1] += 0.5  # 14 standard deviations of the difference
    assert sidak(p_values(a, b)) < 1e-6


def test_noise_free_images_may_differ_by_rounding_only() -> None:
    """Just inside and just outside the allowance."""
    exact = Estimate.exact(np.full((4, 4, 3), 2.0))
    assert sidak(p_values(exact, exact)) == 1
    assert sidak(p_values(exact, exact.dimmed(0.9 * ROUNDING))) == 1
    assert sidak(p_values(exact, exact.dimmed(1.1 * ROUNDING))) == 0


def test_relative_rmse_of_known_noise() -> None:
    """Relative deviation 5 %, over 294912 values: five standard deviations of the estimate are 0.65 %."""
    reference = np.full((48, 64, 3), 2.0)
    stack = noisy_stack(5, mean=2.0, deviation=0.1)
    assert abs(relative_rmse(stack, reference, dark=0) / 0.05 - 1) < 0.0065
