"""What images should be: the analytic answer for an open floor, from the library in double precision.

The library is asked through `irradiance.rs`, beside this file. Two independent answers are in
`renderlab/irradiance.py`; `tests/cross/test_analytic.py` holds them against this one.
"""

import subprocess
from functools import cache

import numpy as np
from renderlab.floor_reference import FloorScene, jittered_image, reference_image, trusted_pixels
from renderlab.scenes import REPOSITORY
from spherecap_command.errors import UserError

from cross.scene import Scene

PROGRAM = REPOSITORY / "build" / "irradiance"


def floor_of(scene: Scene, width: int, height: int) -> FloorScene:
    """Return an open floor in the form that analytic images are made from."""
    light, camera = scene.lights[0], scene.camera
    forward, right, up = (np.array(axis) for axis in camera.axes())
    half = np.tan(np.radians(camera.fov) / 2)
    right, up = half * right, half * height / width * up
    return FloorScene(
        centre=np.array(light.centre, dtype=float),
        radius=light.radius,
        radiance=np.array([light.radiance]),
        reflectance=np.array([scene.shapes[0].albedo]),
        camera=np.array(camera.eye, dtype=float),
        corner=forward - right + up,
        right=2 * right,
        down=-2 * up,
        width=width,
        height=height,
    )


def library_irradiance(centre: np.ndarray, radius: float) -> np.ndarray:
    """Ask the library in double precision; see `renderlab.floor_reference.Irradiance`."""
    if not PROGRAM.exists():
        raise UserError(f"{PROGRAM} is not built: run `make {PROGRAM.relative_to(REPOSITORY)}`")
    records = np.empty((*centre.shape[:-1], 4), dtype="<f8")
    records[..., :3], records[..., 3] = centre, radius
    done = subprocess.run([PROGRAM], input=records.tobytes(), stdout=subprocess.PIPE, check=True)
    return np.frombuffer(done.stdout, dtype="<f8").reshape(centre.shape[:-1])


@cache
def analytic_image(scene: Scene, width: int, height: int) -> np.ndarray:
    """Return the image of an open floor, shape (height, width)."""
    return reference_image(floor_of(scene, width, height), irradiance_at=library_irradiance)[..., 0]


def lit_pixels(scene: Scene, width: int, height: int) -> np.ndarray:
    """Return a mask of the pixels of an open floor that are wholly outside the light.

    (Inside, Cycles lights the floor, too.)
    """
    floor = floor_of(scene, width, height)
    inside = jittered_image(floor, seed=0)[..., 0] == 0
    return trusted_pixels(floor) & ~inside


def jittered_images(scene: Scene, width: int, height: int, seeds: range) -> np.ndarray:
    """Return exact values at one random position per pixel, an image per seed: one sample's least noise."""
    floor = floor_of(scene, width, height)
    return np.stack([jittered_image(floor, seed)[..., 0] for seed in seeds])
