"""The functions of a disk segment that are fitted, in closed form and to mpmath's precision.

A segment of the unit disk with half angle a has the height h = 1 - cos a, half the chord sin a, and the area
a - sin a cos a. All of these formulas cancel for small segments, by up to a^5, so the precision must be
ample.
"""

from mpmath import acos, mp, mpf, sqrt

# Decimal digits. The grids reach down to a = 1e-3, and the linear systems have condition numbers up to 1e17:
# together they cost 32 digits, and the best fit is good to 17.
mp.dps = 60

# segment(h) / h^(3/2) for h -> 0, where the circle is a parabola.
PARABOLA = 4 * sqrt(mpf(2)) / 3


def segment(h):
    """Area of the segment of height h: acos(1 - h) - (1 - h) sqrt(h (2 - h)); d/dh = 2 sqrt(h (2 - h))."""
    return acos(1 - h) - (1 - h) * sqrt(h * (2 - h))


def stretched_height(h):
    """Return k(h) = (segment(h) / PARABOLA)^(2/3) = h (1 - h/10 - ...), whose inverse is smooth too."""
    return (segment(h) / PARABOLA) ** (mpf(2) / 3)


def shape(x):
    """H(x) = (a - sin a cos a) / sin^3 a at x = cos a: a segment's area over the cube of half its chord."""
    return segment(1 - x) / sqrt((1 - x) * (1 + x)) ** 3


def shape_moment_slope(x):
    """Return d/dx (x H(x)), from H'(x) (1 - x^2) = 3 x H(x) - 2."""
    return ((1 + 2 * x * x) * shape(x) - 2 * x) / ((1 - x) * (1 + x))
