"""The analytic answer: the library in double precision against a closed form and against quadrature."""

import numpy as np
import pytest
from cross.reference import floor_of, library_irradiance
from cross.scene import SCENES, Scene
from renderlab.floor_reference import closed_form, floor_points
from renderlab.irradiance import integrated_solid_angle

OPEN_FLOORS = [scene for scene in SCENES if scene.is_open_floor]
EPSILON = 2.0**-53


def by_name(scene: Scene) -> str:
    """Name a test after its scene."""
    return scene.name


def lights_seen(scene: Scene, count: int) -> tuple[np.ndarray, float]:
    """Return the light's centre minus points all over the image, shape (count, 3), and its radius."""
    floor = floor_of(scene, 4, 3)
    film = np.random.default_rng(1).random((2, count))
    return floor.centre - floor_points(floor, *film), floor.radius


def off_by_closed_form(irradiance: np.ndarray, centre: np.ndarray, radius: float) -> bool:
    """Compare with the closed form, within its rounding (see `tests/renders/test_irradiance.py`)."""
    sine = radius / np.linalg.norm(centre, axis=-1)
    return np.any(np.abs(irradiance - closed_form(centre, radius)) > 1e-12 * sine**2 + 4 * EPSILON * sine)


def test_there_are_open_floors() -> None:
    """In all three cases of the cap, and the hard ones."""
    assert [scene.name for scene in OPEN_FLOORS] == ["S1", "S2", "S4", "far", "touching"]


@pytest.mark.parametrize("scene", OPEN_FLOORS, ids=by_name)
def test_library_agrees_with_closed_form(scene: Scene) -> None:
    """At 20000 points of each floor."""
    centre, radius = lights_seen(scene, 20_000)
    irradiance = library_irradiance(centre, radius)
    assert irradiance.max() > 0
    assert not off_by_closed_form(irradiance, centre, radius)
    assert off_by_closed_form(irradiance * (1 + 1e-9), centre, radius), "a billionth more is noticed"


@pytest.mark.parametrize("scene", OPEN_FLOORS, ids=by_name)
def test_library_agrees_with_quadrature(scene: Scene) -> None:
    """At 40 points outside the light. Allowed: what the quadrature claims, and rounding."""
    centre, radius = lights_seen(scene, 60)
    distance = np.linalg.norm(centre, axis=-1)
    outside = np.flatnonzero(distance > radius)[:40]
    assert len(outside) == 40
    irradiance = library_irradiance(centre[outside], radius)
    for got, d, z in zip(irradiance, distance[outside], centre[outside, 2], strict=True):
        sine = radius / d
        expected, claimed = integrated_solid_angle(z / d, sine)
        assert abs(got - expected) <= claimed + 1e-12 * sine**2


def test_bad_records_are_refused() -> None:
    """A radius that is negative is not taken for darkness."""
    with pytest.raises(Exception, match="non-zero exit status"):
        library_irradiance(np.array([[0.0, 0.0, 1.0]]), -1.0)
