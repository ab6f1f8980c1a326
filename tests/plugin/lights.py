"""What the plugin's tests build: sphere lights, and points that they illuminate."""

import drjit as dr
import mitsuba as mi
import numpy as np

# Every emitter of Mitsuba refers to its shape without owning it: keep the shapes.
_alive = []


def light(emitter="spherecap", center=(0, 0, 3), radius=1.0, radiance=1.0, **parameters):
    """A sphere that emits; the emitter is its `.emitter()`."""
    sphere = mi.load_dict(
        {
            "type": "sphere",
            "center": list(center),
            "radius": radius,
            "emitter": {"type": emitter, "radiance": radiance, **parameters},
        }
    )
    _alive.append(sphere)
    return sphere


def point(position=(0, 0, 0), normal=(0, 0, 1), time=0.0):
    """A point of a surface with a geometric normal; (0, 0, 0) for one in a medium."""
    it = dr.zeros(mi.SurfaceInteraction3f)
    it.p = [float(x) for x in position]
    it.n = [float(x) for x in normal]
    it.time = time
    if mi.is_spectral:
        it.wavelengths = [450.0, 520.0, 590.0, 660.0]
    return it


def array(value):
    """Any Dr.Jit value as a numpy array."""
    return np.array(value, dtype=np.float64)


def rotation(seed):
    """A random rotation matrix, the same for the same seed."""
    q, r = np.linalg.qr(np.random.default_rng(seed).standard_normal((3, 3)))
    q *= np.sign(np.diag(r))
    return q if np.linalg.det(q) > 0 else -q
