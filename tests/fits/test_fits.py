"""The constants of src/fits.rs are those that fits/ makes, and they are as good as the file says.

The errors are measured here from the definitions, in multiple precision, and share no formula with the fits.
"""

import re
import sys
from itertools import pairwise, product
from pathlib import Path

import numpy as np
import pytest
from mpmath import acos, atan, cos, mp, mpf, pi, quad, sin, sqrt

sys.path.insert(0, str(Path(__file__).resolve().parents[2]))

from fits import rust
from fits.__main__ import differences

TEXT = rust.PATH.read_text()
PARABOLA = 4 * sqrt(mpf(2)) / 3


@pytest.fixture(autouse=True)
def _precision():
    """50 digits: the formulas below lose up to 30 of them, and the errors in question are down to 1e-16."""
    with mp.workdps(50):
        yield


def polynomial(name):
    """The coefficients of one of the file's polynomials: the numbers that the decimals mean."""
    number = np.float32 if name.startswith("SINGLE") else np.float64
    return [mpf(float(number(decimal))) for decimal in rust.numbers(TEXT, name)]


def horner(coefficients, x):
    """Value and derivative."""
    value = slope = mpf(0)
    for c in reversed(coefficients):
        slope = slope * x + value
        value = value * x + c
    return value, slope


def segment(h):
    """Area of the segment of height h of the unit disk."""
    a = acos(1 - h)
    return a - sin(a) * cos(a)


def shape(x):
    """H."""
    return segment(1 - x) / sqrt(1 - x * x) ** 3


def between(count):
    """Points in (0, 1), denser towards the ends; no end itself, where the formulas are 0/0."""
    return [(1 - cos(pi * (i + mpf(1) / 2) / count)) / 2 for i in range(count)]


def assert_stated(worst, name):
    """The measured error is at most the stated one, but not much less, or the statement is out of date."""
    stated = rust.stated_error(TEXT, name)
    # The stated error has two digits, rounded up: by 10 % at most. The grid here may miss the worst point.
    assert 0.8 * stated <= worst <= stated


# reproducibility -------------------------------------------------------------------------------------------


@pytest.fixture(scope="module")
def made():
    """What `python -m fits` would write."""
    return rust.source()


def test_file_is_what_the_scripts_make(made):
    """If this fails, run `python -m fits`, or find out who edited the generated file."""
    assert list(differences(made, TEXT)) == []


@pytest.mark.parametrize("name", ["SINGLE.shape", "SINGLE.height", "DOUBLE.area"])
def test_a_changed_polynomial_is_noticed(made, name):
    """In its last digit."""
    number = rust.numbers(made, name)[2]
    assert made.count(number) == 1
    changed = number[:-1] + ("1" if number[-1] != "1" else "2")
    assert list(differences(made, made.replace(number, changed)))


def test_a_changed_crescent_is_noticed(made):
    """In the sixth decimal, or by a term that appears or vanishes."""
    table, _ = rust.crescent_table(made)
    for term in ((0, 0, 0), max(table)):
        number = repr(table[term])
        for changed in (repr(table[term] + 1e-6), "0.0"):
            assert list(differences(made, made.replace(number, changed)))


@pytest.mark.parametrize("name", ["shape", "area", "height", "root"])
def test_single_precision_coefficients_are_single_precision_numbers(name):
    """Read as f64 and converted, or read as f32: the same."""
    for decimal in rust.numbers(TEXT, f"SINGLE.{name}"):
        assert decimal == str(np.float32(decimal)) == str(np.float32(float(decimal)))


# segments --------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("precision", ["SINGLE", "DOUBLE"])
def test_shape(precision):
    """H itself, and N = H(t) + e H[t,e] with the divided difference: a cut cap's projected solid angle."""
    name = f"{precision}.shape"
    coefficients = polynomial(name)
    points = between(120)
    exact = [shape(x) for x in points]
    found = [horner(coefficients, x - mpf(1) / 2)[0] for x in points]
    of_shape = max(abs(p / h - 1) for p, h in zip(found, exact, strict=True))
    assert of_shape <= rust.stated_error(TEXT, name)

    def total(values, i, k):
        return values[i] + points[k] * (values[i] - values[k]) / (points[i] - points[k])

    pairs = [(i, k) for i, k in product(range(len(points)), repeat=2) if k < i]
    of_total = max(abs(total(found, *pair) / total(exact, *pair) - 1) for pair in pairs)
    assert_stated(of_total, name)


@pytest.mark.parametrize("precision", ["SINGLE", "DOUBLE"])
def test_area(precision):
    """The relative error of h A(h)."""
    name = f"{precision}.area"
    coefficients = polynomial(name)
    assert_stated(
        max(
            abs(h * horner(coefficients, h)[0] / (segment(h) / PARABOLA) ** (mpf(2) / 3) - 1)
            for h in between(500)
        ),
        name,
    )


@pytest.mark.parametrize("precision", ["SINGLE", "DOUBLE"])
def test_height(precision):
    """The density of heights k P(k) with a uniform k^(3/2) against 2 sqrt(h (2 - h)), and the heights."""
    name = f"{precision}.height"
    coefficients = polynomial(name)
    of_density = of_height = 0
    for h in between(500):
        k = (segment(h) / PARABOLA) ** (mpf(2) / 3)
        value, slope = horner(coefficients, k)
        sampled, sampled_slope = k * value, value + k * slope
        # The area is PARABOLA k^(3/2): its derivative by k in two ways.
        density = 2 * sqrt(sampled * (2 - sampled)) * sampled_slope / (PARABOLA * mpf(3) / 2 * sqrt(k))
        of_density = max(of_density, abs(density - 1))
        of_height = max(of_height, abs(sampled / h - 1))
    assert_stated(of_density, name)
    # An error of the area is one of the height times area / (h darea/dh), at most pi/4 (at h = 1).
    assert of_height <= rust.stated_error(TEXT, name) * pi / 4


@pytest.mark.parametrize(("precision", "epsilon"), [("SINGLE", 2**-23), ("DOUBLE", 2**-52)])
def test_height_ends_at_one(precision, epsilon):
    """The whole half disk has the height 1 to within rounding, and heights grow all the way."""
    coefficients = polynomial(f"{precision}.height")
    end = (pi / 2 / PARABOLA) ** (mpf(2) / 3)
    assert abs(end * horner(coefficients, end)[0] - 1) <= epsilon
    heights = [k * horner(coefficients, k)[0] for k in (end * i / 1000 for i in range(1001))]
    assert all(low < high for low, high in pairwise(heights))


@pytest.mark.parametrize("precision", ["SINGLE", "DOUBLE"])
def test_root(precision):
    """The relative error of 1 + r R(r), for all residuals that the guess of the cube root leaves."""
    name = f"{precision}.root"
    coefficients = polynomial(name)
    residuals = [(2 * x - 1) * stated_residual() for x in between(500)]
    assert_stated(
        max(abs((1 + r * horner(coefficients, r)[0]) * (1 - r) ** (mpf(1) / 3) - 1) for r in residuals), name
    )


def stated_residual():
    """The largest residual that the file says R is for."""
    return mpf(re.search(r"for \|r\| <= ([\d.]+)", TEXT)[1])


def test_the_guess_of_the_cube_root_leaves_no_larger_residual():
    """By exact arithmetic: x = m 2^e has the exponent and fraction e + m - 1, of which -1/3 is taken."""
    math = (rust.PATH.parent / "math.rs").read_text()
    shift = mpf(re.search(r"4\.0 / 3\.0 \* L::EXPONENT_BIAS as f64 - ([\d.]+)\)", math)[1])
    for third, m in product(range(3), [1 + mpf(i) / 4096 for i in range(4097)]):
        guess = mpf(4) / 3 * 127 - shift - (third + 127 + m - 1) / 3
        exponent = int(guess // 1)
        y = (1 + guess - exponent) * mpf(2) ** (exponent - 127)
        assert abs(1 - m * mpf(2) ** third * y**3) <= stated_residual()


# crescents -------------------------------------------------------------------------------------------------


def crescent(kappa, t):
    """A cap with these parameters: sine s and cosine of its angular radius, and X and Z of its centre.

    kappa = |Z| / s and t = cos / X with X^2 + Z^2 = 1.
    """
    s = sqrt((1 - t) * (1 + t) / ((1 - kappa * t) * (1 + kappa * t)))
    return s, sqrt((1 - s) * (1 + s)), sqrt((1 - kappa * s) * (1 + kappa * s)), -kappa * s


def slice_density(kappa, t):
    """The projected solid angle per angle th of the great circles through the middle of the horizon's arc.

    Those circles are cos a (1, 0, 0) + sin a (0, cos th, sin th), 0 <= a <= b. The solid angle is
    sin a da dth and the cosine sin a sin th, so it is sin th (b - sin b cos b) / 2. The end b is on the cap's
    edge, where X cos b + Z sin th sin b = cos(radius).
    """
    _, cosine, x, z = crescent(kappa, t)

    def density(angle):
        # X cos b + Z sin th sin b is an amplitude times cos(b + tilt).
        tilt = atan(-z * sin(angle) / x)
        end = acos(cosine / sqrt(x * x + (z * sin(angle)) ** 2)) - tilt
        return sin(angle) * (end - sin(end) * cos(end)) / 2

    return density


def test_crescent():
    """The density of slices by the fitted marginal against the projected solid angle of the slices."""
    table, _ = rust.crescent_table(TEXT)
    worst = 0
    near_end = mpf("1e-6")
    for kappa, t in product([near_end, *between(9), 1 - near_end], repeat=2):
        e, tau = kappa * t, sqrt((1 - kappa) * (1 + kappa))
        total = (t * shape(t) - e * shape(e)) / (t - e)
        start = sqrt(total / ((1 + kappa) * shape(t)))
        end = (1 + kappa) * shape((t + kappa) / (1 + e)) / ((1 + e) ** 3 * total)
        rho, y = end / start - 1, 1 - end
        beta = [mpf(0)] * 5
        for (j, a, b), c in table.items():
            beta[j] += c * rho**a * y**b

        density = slice_density(kappa, t)
        half = quad(density, [0, pi / 2])
        for v in between(25):
            u = sqrt(1 - v * v)
            correction, correction_slope = horner([0, *beta], v)
            b = start + (end - start) * v + rho * (1 - v) * correction
            b_slope = end - start + rho * ((1 - v) * correction_slope - correction)
            # tan th = tau q / u with q = V B(V); u is uniform in [0, 1] on this half, and dV/du = -u / V.
            q, q_slope = v * b, -(b + v * b_slope) * u / v
            angle_slope = tau * (q - q_slope * u) / (u * u + (tau * q) ** 2)
            worst = max(worst, abs(density(atan(tau * q / u)) / half * angle_slope - 1))
    assert_stated(worst, "CRESCENT")
