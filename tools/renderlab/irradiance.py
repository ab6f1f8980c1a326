"""Irradiance of a spherical light on a plane, without what is below the horizon: closed form, and quadrature.

For radiance 1 the irradiance equals the projected solid angle of the visible part of the light, in [0, pi].
The closed form is the known view factor of a sphere from a plane element (J. M. Snyder, "Area Light Sources
for Real-Time Graphics", 1996; S. Lagarde and C. de Rousiers, "Moving Frostbite to PBR", 2014), written with
s = sine of the light's angular radius and Z = cosine between normal and centre. Double precision. It shares
nothing with the Rust library, on purpose. Near Z = -s it subtracts nearly equal terms: its absolute error
stays at rounding level (a few 2^-53 s), its relative error there does not.
"""

from itertools import pairwise

import numpy as np
from scipy.integrate import quad


def projected_solid_angle(normal: np.ndarray, centre: np.ndarray, radius: float | np.ndarray) -> np.ndarray:
    """Return the projected solid angle of spheres above the tangent planes of points.

    normal: unit vectors, shape (..., 3). centre: sphere's centre minus point, shape (..., 3), in the
    radius' unit of length. Points inside the sphere get 0, as from an emitter that shines outwards only.
    """
    distance = np.linalg.norm(centre, axis=-1)
    sine = np.minimum(radius / distance, 1.0)
    height = np.sum(normal * centre, axis=-1) / distance
    whole = np.pi * sine**2 * height

    # The horizon cuts the light where |height| < sine; elsewhere the arguments are only kept in range.
    cosine = np.sqrt((1.0 - sine) * (1.0 + sine))
    across = np.sqrt(np.maximum((1.0 - height) * (1.0 + height), 1e-300))
    # cos of the azimuth, seen from the centre's direction, at which the light's rim meets the horizon.
    rim = np.clip(-(cosine / sine) * height / across, -1.0, 1.0)
    depth = np.sqrt(np.maximum((sine - height) * (sine + height), 0.0)) / sine  # across * sqrt(1 - rim^2)
    cut = sine**2 * (height * np.arccos(rim) - cosine / sine * depth) + np.arctan2(sine * depth, cosine)

    result = np.where(height >= sine, whole, np.where(height <= -sine, 0.0, cut))
    return np.where(distance <= radius, 0.0, result)


def integrated_solid_angle(height: float, sine: float) -> tuple[float, float]:
    """Integrate the cosine over a cap above the horizon, ring by ring about the normal: slow, and by itself.

    height: cosine between normal and centre. sine: of the cap's angular radius. At zenith angle t the cap
    covers azimuths up to acos((v - Z cos t) / (X sin t)), where v is the cosine of its angular radius, and
    the normal's components towards and across the centre are Z and X. Return the integral and a bound of
    its error.
    """
    across, cosine = np.sqrt((1 - height) * (1 + height)), np.sqrt((1 - sine) * (1 + sine))

    def ring(t: float) -> float:
        reach = cosine - height * np.cos(t)
        side = across * np.sin(t)
        azimuth = np.arccos(np.clip(reach / side, -1, 1)) if side > 0 else np.pi * (reach <= 0)
        return 2 * azimuth * np.cos(t) * np.sin(t)

    zenith, half = np.arccos(height), np.arcsin(sine)
    # The integrand has kinks where a ring begins and ends to meet the cap, and where it is all inside.
    kinks = np.unique(np.clip([0, zenith - half, half - zenith, zenith + half, np.pi / 2], 0, np.pi / 2))
    # Not better than the arc cosine allows: a small cap keeps its argument within sine^2 of 1.
    relative = 1e-12 + 2.0**-50 / sine**2
    parts = [
        quad(ring, a, b, epsabs=relative * sine**2, epsrel=relative, limit=200) for a, b in pairwise(kinks)
    ]
    return sum(value for value, _ in parts), sum(error for _, error in parts)
