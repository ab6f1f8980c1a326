"""Best polynomials in the maximum norm, and their rounding to a floating-point format.

A fit is a linear problem on a grid of points i: find the coefficients c_j for which the largest of the errors
|sum_j c_j columns[j][i] - target[i]| is least. The norm is in the columns: a relative error, say, has the
columns x^j / f(x) and the target 1.
"""

from itertools import product

import numpy as np
from mpmath import cos, lu_solve, matrix, mpf, pi

# Grid points for each extremum of the error. Near an extremum the error is a parabola, and like a cosine in
# the angle in which Chebyshev points are equally spaced: a grid misses at most 1 - cos(pi/2/40) = 8e-4 of the
# maximum.
POINTS_PER_EXTREMUM = 40


def chebyshev_points(count):
    """The zeros of the Chebyshev polynomial of degree `count`, moved to (0, 1), from high to low."""
    return [(1 + cos(pi * (2 * i + 1) / (2 * count))) / 2 for i in range(count)]


def grid(degree):
    """A grid for polynomials of this degree: their error has degree + 2 extrema."""
    return chebyshev_points(POINTS_PER_EXTREMUM * (degree + 2))


def errors(columns, target, coefficients):
    """sum_j c_j columns[j][i] - target[i] for each point i."""
    rows = zip(*columns, strict=True)
    return [
        sum(c * value for c, value in zip(coefficients, row, strict=True)) - f
        for row, f in zip(rows, target, strict=True)
    ]


def minimax(columns, target):
    """The best coefficients, by Remez's exchange. The columns must be a Chebyshev system on an ordered grid.

    The error of the best polynomial takes its maximum with alternating signs at one point more than there are
    coefficients. So: demand that at some reference points, find where the error is in fact largest, repeat.
    """
    unknowns = len(columns)
    # The extrema of a Chebyshev polynomial are equally spaced on our grids.
    reference = [round((len(target) - 1) * i / unknowns) for i in range(unknowns + 1)]
    while True:
        system, right = matrix(unknowns + 1, unknowns + 1), matrix(unknowns + 1, 1)
        for row, i in enumerate(reference):
            for j in range(unknowns):
                system[row, j] = columns[j][i]
            system[row, unknowns] = (-1) ** row
            right[row] = target[i]
        *coefficients, level = lu_solve(system, right)
        found = errors(columns, target, coefficients)
        # The level is a lower bound of the best polynomial's error, the maximum an upper bound.
        if max(map(abs, found)) <= abs(level) * (1 + mpf("1e-6")):
            return coefficients
        reference = _alternation(found, unknowns + 1)


def _alternation(found, count):
    """`count` successive extrema of alternating signs, the largest among them included."""
    extrema = [0]
    for i in range(1, len(found)):
        if (found[i] > 0) != (found[extrema[-1]] > 0):
            extrema.append(i)
        elif abs(found[i]) > abs(found[extrema[-1]]):
            extrema[-1] = i
    while len(extrema) > count:
        extrema.pop(0 if abs(found[extrema[0]]) < abs(found[extrema[-1]]) else -1)
    assert len(extrema) == count, "the error has too few extrema: the columns are no Chebyshev system"
    return extrema


def rounded_to_single(columns, target, coefficients):
    """Each coefficient rounded to binary32, up or down, in that of all 2^n ways which leaves the least error.

    Rounding each to nearest can cost much more than the fit itself: for H, errors of 4.8e-8 become 2.3e-7.
    """
    neighbours = [_single_neighbours(c) for c in coefficients]
    found = np.array(errors(columns, target, coefficients), dtype=float)
    # The change of the errors by each rounding; exact differences first, so that binary64 holds them well.
    changes = [
        [np.array([float((n - c) * value) for value in column]) for n in pair]
        for c, pair, column in zip(coefficients, neighbours, columns, strict=True)
    ]

    def worst(ways):
        return np.abs(found + sum(change[way] for change, way in zip(changes, ways, strict=True))).max()

    best = min(product((0, 1), repeat=len(coefficients)), key=worst)
    return [float(pair[way]) for pair, way in zip(neighbours, best, strict=True)]


def _single_neighbours(value):
    """The two binary32 numbers around a real number, as exact multiple-precision numbers."""
    nearest = np.float32(float(value))
    other = np.nextafter(nearest, np.float32(np.inf if mpf(float(nearest)) < value else -np.inf))
    return mpf(float(nearest)), mpf(float(other))
