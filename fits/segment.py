"""The polynomials of one variable: areas of segments H and A, heights of segments P, and R of the root in P.

Each function below sets up one linear problem (see polynomial.py) for coefficients in ascending order. Its
columns are those of the monomials, so the problem's error is the polynomial's error in the norm that matters
to a sampler.
"""

from dataclasses import dataclass
from functools import cache

from mpmath import mpf, sqrt

from fits import exact, polynomial


@dataclass(frozen=True)
class Fitted:
    """A polynomial, coefficients ascending, with the largest error in its norm after their rounding."""

    coefficients: list[float]
    error: float


def shape_problem(degree):
    """H(x), x in [0, 1], as a polynomial in z = x - 1/2, in the relative error of d/dx (x H).

    The projected solid angle of a cut cap needs N = H(t) + e H[t,e] with the divided difference
    H[t,e] = (H(t) - H(e)) / (t - e), 0 <= e <= t <= 1. That is

        N = (t H(t) - e H(e)) / (t - e),

    the mean of the derivative (x H)' over [e, t]. H(x) is its mean over [0, x]. (x H)' is positive, so a
    bound of its relative error also bounds the relative errors of N and of H. (A fit of H itself has slopes
    that nobody asked for: at the same degree it is fifty times worse in N.)
    """
    points = polynomial.grid(degree)
    weights = [1 / exact.shape_moment_slope(x) for x in points]
    columns = []
    for j in range(degree + 1):
        # d/dx (x z^j) = z^j + j x z^(j-1)
        slopes = [(z := x - mpf(1) / 2) ** j + (j * x * z ** (j - 1) if j else 0) for x in points]
        columns.append([w * slope for w, slope in zip(weights, slopes, strict=True)])
    return columns, [mpf(1)] * len(points)


def area_problem(degree):
    """A(h) = k(h) / h, h in [0, 1], in the relative error; a segment's area is PARABOLA (h A(h))^(3/2)."""
    points = polynomial.grid(degree)
    weights = [h / exact.stretched_height(h) for h in points]
    columns = [[w * h**j for w, h in zip(weights, points, strict=True)] for j in range(degree + 1)]
    return columns, [mpf(1)] * len(points)


def height_problem(degree):
    """P(k) = h / k, the inverse of k = h A(h), for h in [0, 1], in the relative error of samples' density.

    A sample has k^(3/2) uniform and the height h = k P(k). The density of h should be proportional to
    segment'(h) = 2 sqrt(h (2 - h)). With a slightly wrong h + dh it is off by the factor of

        segment'(h + dh) d(h + dh)/dk = segment'(h) dh/dk (1 + error),
        error = segment''/segment' dh + (d dh/dk) / (dh/dk),   segment''/segment' = (1 - h) / (h (2 - h)).

    That is linear in dh = k dP. The integral of the error times the density from 0 to k is segment'(h) dh. It
    nearly vanishes at the end, because the error oscillates: k(1) goes to the height 1 much more accurately
    than the largest error lets one expect.
    """
    points = polynomial.grid(degree)
    columns, target = [[] for _ in range(degree + 1)], []
    for h in points:
        k = exact.stretched_height(h)
        # k^(3/2) = segment / PARABOLA, so (3/2) k'/k = segment'/segment.
        k_slope = mpf(2) / 3 * k * 2 * sqrt(h * (2 - h)) / exact.segment(h)
        ratio = (1 - h) / (h * (2 - h))
        for j, column in enumerate(columns):
            column.append(ratio * k ** (j + 1) + (j + 1) * k**j * k_slope)
        target.append(ratio * h + 1)
    return columns, target


# The residual 1 - x y^3 of the guess y of x^(-1/3) that dividing the exponent and the significand by -3 gives
# (`two_thirds_power` in src/math.rs): at most this, up to its last digit rounded up.
RESIDUAL = mpf("0.1021")


def root_problem(degree):
    """R(r) = ((1 - r)^(-1/3) - 1) / r, |r| <= RESIDUAL, in the relative error of 1 + r R(r).

    The columns are r^j times a weight that is positive on both sides of 0, which is not a point of the grid.
    """
    points = [RESIDUAL * (2 * x - 1) for x in polynomial.grid(degree)]
    weights = [abs(r) * (1 - r) ** (mpf(1) / 3) for r in points]
    columns = [[w * r**j for w, r in zip(weights, points, strict=True)] for j in range(degree + 1)]
    exact = [((1 - r) ** (-mpf(1) / 3) - 1) / r for r in points]
    return columns, [w * f for w, f in zip(weights, exact, strict=True)]


# The single precision degrees are the least with errors near 1e-7, where rounding takes over. (P's error of
# 5e-7 is in the density, that is in the height's derivative.) R's is one more: its 9e-8 would come on top of
# them, and make the median errors of samples up to a quarter larger.
SINGLE = {
    "shape": (shape_problem, 11),
    "area": (area_problem, 5),
    "height": (height_problem, 8),
    "root": (root_problem, 4),
}
# The double precision degrees are the least with errors below 2^-53 = 1.1e-16, and for P, whose convergence
# is the slowest and whose coefficients grow with the degree (up to 5 here), the least below 1e-15. R's is the
# least that a step of Newton's method, which squares the error, takes below 2^-53.
DOUBLE = {
    "shape": (shape_problem, 23),
    "area": (area_problem, 16),
    "height": (height_problem, 22),
    "root": (root_problem, 4),
}


@cache
def single(name):
    """One of the polynomials for binary32."""
    problem, degree = SINGLE[name]
    columns, target = problem(degree)
    best = polynomial.minimax(columns, target)
    return _fitted(columns, target, polynomial.rounded_to_single(columns, target, best))


@cache
def double(name):
    """One of the polynomials for binary64."""
    problem, degree = DOUBLE[name]
    columns, target = problem(degree)
    return _fitted(columns, target, [float(c) for c in polynomial.minimax(columns, target)])


def _fitted(columns, target, coefficients):
    return Fitted(coefficients, float(max(map(abs, polynomial.errors(columns, target, coefficients)))))
