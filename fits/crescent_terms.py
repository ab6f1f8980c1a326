"""Choose the terms of the crescent's marginal (crescent.py) from all that might serve: a search of minutes.

`python -m fits.crescent_terms COUNT` prints a choice of COUNT terms. The choice for 36 is kept in
crescent.py. Another machine's rounding may lead the search to another choice of about the same error: any
choice is correct that passes the tests.
"""

import sys

import numpy as np

from fits.crescent import crescents, refined
from fits.lawson import Lawson

# Powers V^j of the correction, and the largest total power of rho and y. One power of V fewer leaves 8e-6
# whatever the terms; one more would cost time in each sample.
POWERS, DEGREE = 5, 5
# Reweighting steps of a fit while terms are being dropped, and where two choices are compared: the errors are
# then within 10 % and 2 % of their limits.
STEPS, FINAL_STEPS = 10, 40
# So many of the cheapest terms are tried in turn, once the choice is within so many terms of its final size.
TRIED, NEARLY = 4, 10
# The search ends when dropping so many terms and choosing as many others brings no 0.5 %.
EXCHANGED, IMPROVEMENT = 20, 0.995


def candidates():
    """All terms (j, a, b)."""
    exponents = range(DEGREE + 1)
    return [(j, a, b) for j in range(POWERS) for a in exponents for b in exponents if a + b <= DEGREE]


def eliminated(problem, chosen, weights, count):
    """Drop terms from those chosen, one by one and the cheapest first, until `count` are left."""
    uniform = problem.uniform()
    chosen = np.array(chosen)
    while True:
        _, _, cost, weights = problem.fit(chosen, weights, STEPS)
        if len(chosen) == count:
            return chosen, weights
        weights = (weights + uniform) / 2
        cheapest = np.argsort(cost)[:TRIED]
        if len(chosen) > count + NEARLY:
            drop = cheapest[0]
        else:
            drop = min(cheapest, key=lambda i: problem.fit(np.delete(chosen, i), weights, STEPS)[1])
        chosen = np.delete(chosen, drop)


def extended(problem, chosen, weights, count):
    """Add `count` terms to those chosen, each the one that takes most off the weighted sum of squares."""
    frame = problem.frame(weights)
    columns, right = frame @ problem.columns, frame @ problem.right
    for _ in range(count):
        q, _ = np.linalg.qr(columns[:, chosen])
        others = np.setdiff1d(np.arange(columns.shape[1]), chosen)
        free = columns[:, others] - q @ (q.T @ columns[:, others])
        gain = (free.T @ right) ** 2 / (free**2).sum(axis=0)
        chosen = np.append(chosen, others[np.argmax(gain)])
    return chosen


def choose(count):
    """Choose `count` terms: eliminate all others, then exchange more and more at a time while that helps."""
    terms = candidates()
    grid = crescents()
    problem = Lawson(*grid.linearised(grid.columns(terms), refined(grid, terms)))
    chosen, weights = eliminated(problem, np.arange(len(terms)), problem.uniform(), count)
    _, error, _, weights = problem.fit(chosen, weights, FINAL_STEPS)
    print(f"{count} terms after elimination: {error:.2e}", file=sys.stderr)
    exchanged = 1
    while exchanged <= EXCHANGED:
        tried = extended(problem, chosen, weights, exchanged)
        tried, tried_weights = eliminated(problem, tried, (weights + problem.uniform()) / 2, count)
        _, tried_error, _, tried_weights = problem.fit(tried, tried_weights, FINAL_STEPS)
        if tried_error < IMPROVEMENT * error:
            print(f"exchanged {exchanged}: {tried_error:.2e}", file=sys.stderr)
            chosen, error, weights, exchanged = tried, tried_error, tried_weights, 1
        else:
            exchanged += 1
    return sorted(terms[i] for i in chosen)


def main():
    """Print a choice in the form that crescent.py keeps."""
    terms = choose(int(sys.argv[1]))
    for power in range(POWERS):
        print(f'    "{" ".join(f"{a}{b}" for j, a, b in terms if j == power)}",')


if __name__ == "__main__":
    main()
