"""The analytic reference itself: against 25-digit values and against quadrature. No library code."""

import csv
from pathlib import Path

import numpy as np
import pytest
from renderlab.irradiance import integrated_solid_angle, projected_solid_angle

CAPS = Path(__file__).resolve().parents[1] / "data" / "caps.csv"
UP = np.array([0.0, 0.0, 1.0])
EPSILON = 2.0**-53


def test_agrees_with_25_digit_values() -> None:
    """All rows of caps.csv.

    Tolerance: the closed form subtracts terms of size s (the sine of the angular radius), each rounded a few
    times: 4 EPSILON s. And 1 - s is formed from a rounded distance, which at s = 1 - 1e-7 keeps 9 digits of a
    term that counts for sqrt(1 - s^2) = 4e-4 of the whole: 1e-12 s^2.
    """
    with CAPS.open() as file:
        rows = list(csv.DictReader(file))
    assert len(rows) == 400
    for row in rows:
        normal = np.array([float.fromhex(row[key]) for key in ("nx", "ny", "nz")])
        centre = np.array([float.fromhex(row[key]) for key in ("cx", "cy", "cz")])
        radius = float.fromhex(row["r"])
        if row["case"] == "inside":
            assert projected_solid_angle(normal, centre, radius) == 0, f"row {row['id']} is inside the light"
            continue
        sine = radius / np.linalg.norm(centre)
        error = abs(projected_solid_angle(normal, centre, radius) - float(row["projected_solid_angle"]))
        assert error <= 1e-12 * sine**2 + 4 * EPSILON * sine, f"row {row['id']}"


@pytest.mark.parametrize("sine", [0.05, 0.5, 0.95])
@pytest.mark.parametrize("height", [1.0, 0.97, 0.5, 0.2, 0.02, 0.0, -0.02, -0.2, -0.9])
def test_agrees_with_quadrature(sine: float, height: float) -> None:
    """Tolerance: what the quadrature claims, plus 1e-12 for rounding in the closed form."""
    expected, claimed = integrated_solid_angle(height, sine)
    got = projected_solid_angle(UP, np.array([np.sqrt(1 - height**2), 0, height]), sine)
    assert abs(got - expected) <= claimed + 1e-12
