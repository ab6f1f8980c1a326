"""Linear fits of many unknowns in the maximum norm, by Lawson's reweighted least squares."""

import numpy as np


class Lawson:
    """The problem to make the largest |jacobian @ c - right| small, with all or some of the columns.

    The monomials of the crescent's fit are nearly dependent (a condition number of 2e11 for all of them), so
    the work is done in an orthonormal basis of the columns. In it a weighted least-squares fit needs the Gram
    matrix of the rows, which is well conditioned, and a small QR decomposition; the cost per row does not
    depend on the choice.
    """

    def __init__(self, jacobian, right):
        """Prepare for any choice of columns."""
        self.scale = np.linalg.norm(jacobian, axis=0)
        basis, self.columns = np.linalg.qr(jacobian / self.scale)
        self.right = basis.T @ right
        # What no column can reach is one more dimension.
        rest = right - basis @ self.right
        length = np.linalg.norm(rest)
        self.basis = np.column_stack([basis, rest / length])
        self.columns = np.vstack([self.columns, np.zeros(len(self.scale))])
        self.right = np.append(self.right, length)

    def uniform(self):
        """Weights to start from."""
        return np.full(len(self.basis), 1 / len(self.basis))

    def frame(self, weights):
        """A triangular T with |T z| the weighted norm of basis @ z."""
        return np.linalg.cholesky(self.basis.T @ (self.basis * weights[:, None])).T

    def fit(self, chosen, weights, steps):
        """Fit the chosen columns: coefficients, largest error, the cost of losing each one, the weights used.

        Each step fits with weights that are then multiplied by the errors they led to. The cost of losing a
        column is the growth of the weighted sum of squares, which needs no further fit: coefficient^2 /
        variance.
        """
        for _ in range(steps):
            frame = self.frame(weights)
            q, r = np.linalg.qr(frame @ self.columns[:, chosen])
            inverse = np.linalg.inv(r)
            coefficients = inverse @ (q.T @ (frame @ self.right))
            errors = np.abs(self.basis @ (self.columns[:, chosen] @ coefficients - self.right))
            used, worst = weights, errors.max()
            # No row may lose its weight for good because its error happens to be zero once.
            weights = weights * np.maximum(errors / worst, 1e-6)
            weights /= weights.sum()
        cost = coefficients**2 / (inverse**2).sum(axis=1)
        return coefficients / self.scale[chosen], worst, cost, used
