"""Noise-free references for a diffuse floor under one sphere light and nothing else.

A pixel's value is reflectance / pi * radiance * irradiance, averaged over the pixel. The average is a
Gauss-Legendre rule of 16 x 16 points: its error is below 3e-7 of the mean image where the irradiance is
smooth, but some percent of the step in the few pixels that the sphere's own rim on the floor crosses (the
floor inside a light gets nothing). `trusted_pixels` tells these apart. Camera, floor and light are read
from the scene file.
"""

from collections.abc import Callable
from dataclasses import dataclass

import mitsuba as mi
import numpy as np
from spherecap_command.scene import BUILT_IN

from renderlab.irradiance import projected_solid_angle
from renderlab.scenes import load_scene

FLOOR_SCENES = ("open_floor", "cut_light", "sunken_light", "tiny_far_light", "touching_light")
NODES_PER_SIDE = 16

# Irradiance of the floor for radiance 1: the light's centre minus points, shape (..., 3), and its radius.
Irradiance = Callable[[np.ndarray, float], np.ndarray]


def closed_form(centre: np.ndarray, radius: float) -> np.ndarray:
    """Return what `irradiance.py` gives."""
    return projected_solid_angle(np.array([0.0, 0.0, 1.0]), centre, radius)


@dataclass(frozen=True)
class FloorScene:
    """A floor z = 0 under one sphere light, as read from a scene file. Lengths in scene units."""

    centre: np.ndarray
    radius: float
    radiance: np.ndarray
    reflectance: np.ndarray
    camera: np.ndarray
    # Direction through film position (x, y) in [0, 1]^2 is corner + x * right + y * down, not normalised.
    corner: np.ndarray
    right: np.ndarray
    down: np.ndarray
    width: int
    height: int


def read_floor_scene(name: str, **parameters: object) -> FloorScene:
    """Read the numbers of a floor scene from its XML file (with Mitsuba's current variant)."""
    scene = load_scene(name, BUILT_IN, **parameters)
    values = mi.traverse(scene)
    light = np.array(values["light.to_world"].matrix, dtype=np.float64).reshape(4, 4)
    sensor = scene.sensors()[0]
    width, height = (int(n) for n in sensor.film().size())

    def direction(x: float, y: float) -> np.ndarray:
        ray, _ = sensor.sample_ray(0.0, 0.5, mi.Point2f(x, y), mi.Point2f(0.5, 0.5))
        return np.array(ray.d, dtype=np.float64).reshape(3)

    # A pinhole camera maps the film affinely to a plane; scale three rays so that they end on one.
    axis = direction(0.5, 0.5)
    corner, right, down = (d / (d @ axis) for d in (direction(0, 0), direction(1, 0), direction(0, 1)))
    eye = np.array(sensor.world_transform().matrix, dtype=np.float64).reshape(4, 4)[:3, 3]
    return FloorScene(
        centre=light[:3, 3],
        radius=float(np.linalg.norm(light[:3, 0])),
        radiance=np.array(values["light.emitter.radiance.value"], dtype=np.float64).reshape(-1),
        reflectance=np.array(values["floor.bsdf.reflectance.value"], dtype=np.float64).reshape(-1),
        camera=eye,
        corner=corner,
        right=right - corner,
        down=down - corner,
        width=width,
        height=height,
    )


def floor_points(scene: FloorScene, film_x: np.ndarray, film_y: np.ndarray) -> np.ndarray:
    """Return where the rays through film positions in [0, 1]^2 meet the floor z = 0."""
    directions = scene.corner + film_x[..., None] * scene.right + film_y[..., None] * scene.down
    if np.any(directions[..., 2] >= 0):
        raise ValueError("a ray of the camera misses the floor: this reference needs a frame full of floor")
    return scene.camera - directions * (scene.camera[2] / directions[..., 2:])


def reference_image(
    scene: FloorScene, nodes: int = NODES_PER_SIDE, irradiance_at: Irradiance = closed_form
) -> np.ndarray:
    """Return the image, each pixel averaged over nodes x nodes Gauss-Legendre points."""
    abscissae, weights = np.polynomial.legendre.leggauss(nodes)
    abscissae, weights = (abscissae + 1) / 2, weights / 2
    film_x = (np.arange(scene.width)[:, None] + abscissae) / scene.width
    rows = []
    for row in range(scene.height):  # Row by row, to keep memory small.
        film_y = (row + abscissae) / scene.height
        points = floor_points(scene, film_x[None], film_y[:, None, None])
        irradiance = irradiance_at(scene.centre - points, scene.radius)
        rows.append(np.einsum("yxi,y,i->x", irradiance, weights, weights))
    return np.array(rows)[..., None] * scene.reflectance * scene.radiance / np.pi


def jittered_image(scene: FloorScene, seed: int) -> np.ndarray:
    """Return exact values at one random position per pixel: the least noise that one sample can have."""
    random = np.random.default_rng(seed)
    film_x = (np.arange(scene.width) + random.random((scene.height, scene.width))) / scene.width
    film_y = (np.arange(scene.height)[:, None] + random.random((scene.height, scene.width))) / scene.height
    points = floor_points(scene, film_x, film_y)
    irradiance = closed_form(scene.centre - points, scene.radius)
    return irradiance[..., None] * scene.reflectance * scene.radiance / np.pi


def trusted_pixels(scene: FloorScene) -> np.ndarray:
    """Return a mask of the pixels that the rim of the light on the floor does not cross."""
    edges_x = np.linspace(0, 1, scene.width * NODES_PER_SIDE + 1)
    edges_y = np.linspace(0, 1, scene.height * NODES_PER_SIDE + 1)
    mask = np.empty((scene.height, scene.width), dtype=bool)
    for row in range(scene.height):
        span = slice(row * NODES_PER_SIDE, (row + 1) * NODES_PER_SIDE + 1)
        points = floor_points(scene, edges_x[None], edges_y[span, None])
        inside = np.linalg.norm(points - scene.centre, axis=-1) <= scene.radius
        columns = [inside[:, x : x + NODES_PER_SIDE + 1] for x in range(0, len(edges_x) - 1, NODES_PER_SIDE)]
        mask[row] = [np.all(c) or not np.any(c) for c in columns]
    return mask
