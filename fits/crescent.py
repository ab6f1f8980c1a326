"""The crescent's marginal: the polynomials beta_j in the map from a random number to a great circle.

A cap with the angular radius asin s whose centre has the height Z below the horizon, -s < Z <= 0, leaves a
crescent above it. kappa = |Z| / s; t is the cosine of half the arc that the cap cuts out of the horizon;
e = kappa t. The crescent is sliced by great circles through the middle of that arc, one for each point (c, S)
of the upper unit half circle, at the angle th with tan th = sqrt(1 - kappa^2) S / c to the horizon. With the
uniform distribution of the projected crescent, c has the density proportional to

    D(S) = H(x) / (H(t) (1 + e S)^3),   x = (t + kappa S) / (1 + e S),

H being the shape of a disk segment (segment.py), and from c = 0 to 1 it integrates to

    D0 = N / ((1 + kappa) H(t)),   N = the mean of d/dx (x H) over [e, t].

(x is the cosine of the length of a slice. Between the angles th and th + dth lies the projected solid angle
segment(1 - x) sin th dth / 2. With (1 - x) (1 + e S) = (1 - t) (1 - kappa S), with
(1 + x) (1 + e S) = (1 + t) (1 + kappa S) and with segment(1 - x) = H(x) (1 - x^2)^(3/2) that becomes D dc.)

(In docs/mathematics.md, section 6, V is u_bar, and S is c_bar.)

For kappa = 0, c is uniform. In general, with u uniform in [-1, 1] and V = sqrt(1 - u^2), (c, S) is taken
proportional to (u, V B(V)). The exact B is analytic. Its ends follow from D at S = 0 and S = 1,

    B(0) = B0 = sqrt(D0),   B(1) = B1 = D(1) / D0,

and between them the library uses

    B(V) = B0 + (B1 - B0) V + rho V (1 - V) sum_j beta_j V^j,   rho = B1 / B0 - 1,   y = 1 - B1,
    beta_j = sum_ab k[j,a,b] rho^a y^b,

with the few terms (j, a, b) that are listed here; crescent_terms.py has chosen them. What is fitted is the
density: with n^2 = u^2 + V^2 B^2, c = u / n and S = V B / n, the samples have the density of the uniform
distribution over

    1 + error = D(S)/D0 dc/du = D(S)/D0 B (B + (1 - V^2) V dB/dV) / n^3.

That is a closed form in B, so nothing here needs the exact B.
"""

import numpy as np
from scipy.special import hyp2f1

from fits.lawson import Lawson

# The terms in use, one line for each j: pairs "ab" of exponents of rho^a y^b.
TERMS = [
    "00 01 02 04 10 11 12 20 21 30 31 40",
    "00 01 02 03 10 13 20 30",
    "00 01 02 03 10 12 13 20 21",
    "00 10 20 30",
    "00 10 20",
]
# Reweighting steps of the fit; twice as many gain less than 0.5 %.
STEPS = 60
# Decimals that are kept. The terms' factors are below 1, and their number is small: this costs the density
# less than 1e-7.
DECIMALS = 8
# How far coefficients may move with the order of summation. Rounding, 1e-16, times the condition number of
# the fit, 5e5, times the largest of them, 1e2, is half a unit of the last decimal; six kernels of OpenBLAS
# agree to one unit. This is ten.
REPRODUCIBLE = 1e-7


def shape(x):
    """H(x) = 2/3 2F1(1, 3; 5/2; (1 - x)/2): the solution of (1 - x^2) H' = 3 x H - 2 that is regular at 1."""
    return 2 / 3 * hyp2f1(1, 3, 5 / 2, (1 - x) / 2)


def shape_slope(x):
    """Return dH/dx."""
    return -2 / 5 * hyp2f1(2, 4, 7 / 2, (1 - x) / 2)


class Crescents:
    """Crescents of all given (kappa, t), at points V of [0, 1]: arrays of the shape (crescents, points)."""

    def __init__(self, kappa, t, v):
        """Take arrays: kappa and t, one of each per crescent, and the points V, which all of them share."""
        self.kappa, self.t, self.v = kappa[:, None], t[:, None], v
        self.e = self.kappa * self.t
        # (x H)' is analytic around [0, 1] with its nearest singularity at -1: 20 Gauss points have an error
        # of (3 + sqrt(8))^-40 = 2e-31 even if [e, t] is all of [0, 1].
        nodes, weights = np.polynomial.legendre.leggauss(20)
        x = self.e + (self.t - self.e) * (1 + nodes) / 2
        mean = (shape(x) + x * shape_slope(x)) @ weights / 2
        self.total = mean[:, None] / ((1 + self.kappa) * shape(self.t))
        self.start = np.sqrt(self.total)
        self.end = self._density(1.0) / self.total
        self.rho, self.y = self.end / self.start - 1, 1 - self.end

    def _density(self, s):
        stretch = 1 + self.e * s
        return shape((self.t + self.kappa * s) / stretch) / (shape(self.t) * stretch**3)

    def _log_density_slope(self, s):
        """d/dS log D(S)."""
        stretch = 1 + self.e * s
        x = (self.t + self.kappa * s) / stretch
        x_slope = self.kappa * (1 - self.t) * (1 + self.t) / stretch**2
        return shape_slope(x) / shape(x) * x_slope - 3 * self.e / stretch

    def columns(self, terms):
        """Values and slopes in V of the terms rho V (1 - V) V^j rho^a y^b: (crescents, points, terms)."""
        j, a, b = (np.array(index) for index in zip(*terms, strict=True))
        factor = (self.rho ** (a + 1) * self.y**b)[:, None, :]
        v = self.v[:, None]
        values = (1 - v) * v ** (j + 1)
        slopes = (j + 1 - (j + 2) * v) * v**j
        return factor * values, factor * slopes

    def marginal(self, columns, coefficients):
        """B(V) and dB/dV."""
        values, slopes = columns
        chord = self.end - self.start
        return self.start + chord * self.v + values @ coefficients, chord + slopes @ coefficients

    def error(self, b, b_slope):
        """Relative error of the density (the module's last formula); its derivatives by B and by dB/dV."""
        v = self.v
        u2 = (1 - v) * (1 + v)
        n2 = u2 + (v * b) ** 2
        s = v * b / np.sqrt(n2)
        stretched = b + u2 * v * b_slope
        ratio = self._density(s) / self.total * b * stretched / n2**1.5
        # dS/dB = V u^2 / n^3
        by_b = self._log_density_slope(s) * v * u2 / n2**1.5 + 1 / b + 1 / stretched - 3 * v**2 * b / n2
        return ratio - 1, ratio * by_b, ratio * u2 * v / stretched

    def linearised(self, columns, coefficients):
        """Jacobian and right side: the error is jacobian @ c - right for coefficients c near those given."""
        values, slopes = columns
        error, by_b, by_slope = self.error(*self.marginal(columns, coefficients))
        jacobian = by_b[..., None] * values + by_slope[..., None] * slopes
        jacobian = jacobian.reshape(-1, len(coefficients))
        return jacobian, jacobian @ coefficients - error.ravel()


def crescents(count=17, points=33):
    """All of 0 <= kappa, t <= 1 and 0 < V < 1, on grids that crowd at the ends like the error's extrema."""
    ends = (1 - np.cos(np.pi * np.arange(count) / (count - 1))) / 2
    kappa, t = (a.ravel() for a in np.meshgrid(ends, ends))
    return Crescents(kappa, t, (1 - np.cos(np.pi * (np.arange(points) + 0.5) / points)) / 2)


def refined(grid, terms):
    """Least-squares coefficients: close enough to better ones for the error's linearisation to hold there."""
    columns, coefficients = grid.columns(terms), np.zeros(len(terms))
    # Gauss-Newton: errors of 3e-2 without any term, then 2e-4, then 1e-5, which is the fit's own.
    for _ in range(3):
        jacobian, right = grid.linearised(columns, coefficients)
        scale = np.linalg.norm(jacobian, axis=0)
        coefficients = np.linalg.lstsq(jacobian / scale, right, rcond=None)[0] / scale
    return coefficients


def terms_in_use():
    """TERMS as a list of (j, a, b)."""
    return [(j, int(a), int(b)) for j, line in enumerate(TERMS) for a, b in line.split()]


def fitted():
    """The coefficients, a dictionary from (j, a, b), and the worst error on a grid denser than the fit's."""
    terms = terms_in_use()
    grid = crescents(count=33, points=49)
    problem = Lawson(*grid.linearised(grid.columns(terms), refined(grid, terms)))
    coefficients, *_ = problem.fit(np.arange(len(terms)), problem.uniform(), STEPS)
    coefficients = coefficients.round(DECIMALS)
    return dict(zip(terms, coefficients.tolist(), strict=True)), worst_error(terms, coefficients)


def worst_error(terms, coefficients):
    """The density's largest error for four times as many crescents as in the fit, at twice the points."""
    grid = crescents(count=65, points=97)
    error, *_ = grid.error(*grid.marginal(grid.columns(terms), coefficients))
    return float(np.abs(error).max())
