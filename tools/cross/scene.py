"""The scenes, once for all renderers. Grey, lit by spheres alone; lengths in scene units, z is up.

Every lamp is a solid black ball that shines: it stops other lamps' light, and the camera looks through it.
Surfaces are Lambertian.
"""

import math
from dataclasses import dataclass

Vector = tuple[float, float, float]


@dataclass(frozen=True)
class Light:
    """A sphere of uniform radiance."""

    centre: Vector
    radius: float
    radiance: float = 1.0


@dataclass(frozen=True)
class Rectangle:
    """A parallelogram: all centre + a * u + b * v with a, b in [-1, 1]. Its normal is along u x v.

    two_sided: the other side reflects, too. (Elsewhere nobody sees it.)
    """

    centre: Vector
    u: Vector
    v: Vector
    albedo: float
    two_sided: bool = False


@dataclass(frozen=True)
class Ball:
    """A sphere."""

    centre: Vector
    radius: float
    albedo: float


@dataclass(frozen=True)
class Box:
    """A cuboid along the axes."""

    low: Vector
    high: Vector
    albedo: float


Shape = Rectangle | Ball | Box


@dataclass(frozen=True)
class Camera:
    """A pinhole camera; the field of view is horizontal, in degrees."""

    eye: Vector
    target: Vector
    fov: float = 50.0

    def axes(self) -> tuple[Vector, Vector, Vector]:
        """Return unit vectors: forward, to the right of the image, and up in it."""
        forward = _unit(tuple(t - e for t, e in zip(self.target, self.eye, strict=True)))
        right = _unit(_cross(forward, (0.0, 0.0, 1.0)))
        return forward, right, _cross(right, forward)


@dataclass(frozen=True)
class Scene:
    """What to render; `about` says which case of the sampler it is there to show.

    bounces: how often light may be reflected before it reaches the surface that the camera sees.
    """

    name: str
    about: str
    lights: tuple[Light, ...]
    shapes: tuple[Shape, ...]
    camera: Camera
    bounces: int = 0

    @property
    def is_open_floor(self) -> bool:
        """Nothing is in the way of one light on one plane: the image has an analytic answer."""
        return len(self.lights) == len(self.shapes) == 1 and self.bounces == 0

    @property
    def lamps_block_light(self) -> bool:
        """Rays other than those sampled towards a lamp may meet it."""
        return len(self.lights) > 1 or self.bounces > 0


def _cross(a: Vector, b: Vector) -> Vector:
    return a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]


def _unit(a: Vector) -> Vector:
    length = math.hypot(*a)
    return a[0] / length, a[1] / length, a[2] / length


FLOOR = Rectangle((0, 0, 0), (50, 0, 0), (0, 50, 0), 0.5)
ABOVE = Camera((1, -3, 6), (0.2, 0.3, 0))


def _room(albedo: float) -> tuple[Rectangle, ...]:
    """Return the six walls of [-1, 1] x [-1, 1] x [0, 2], normals inwards."""
    x, y, z = (1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0)
    return (
        Rectangle((0, 0, 0), x, y, albedo),
        Rectangle((0, 0, 2), y, x, albedo),
        Rectangle((-1, 0, 1), y, z, albedo),
        Rectangle((1, 0, 1), z, y, albedo),
        Rectangle((0, -1, 1), z, x, albedo),
        Rectangle((0, 1, 1), x, z, albedo),
    )


SCENES = (
    Scene(
        "S1",
        "an open floor, the light wholly above its horizon (case 1)",
        (Light((0, 0, 1.5), 0.5),),
        (FLOOR,),
        ABOVE,
    ),
    Scene(
        "S2",
        "the horizon cuts the light everywhere, its centre above the floor (case 2)",
        (Light((0, 0, 0.1), 0.5),),
        (FLOOR,),
        ABOVE,
    ),
    Scene(
        "S3",
        "S1 with a black box below the light: soft shadows",
        (Light((0, 0, 1.5), 0.5),),
        (FLOOR, Box((0.3, -0.4, 0.35), (0.9, 0.4, 0.75), 0.0)),
        ABOVE,
    ),
    Scene(
        "S4",
        "only the top of the light is above the floor, its centre below (case 3)",
        (Light((0, 0, -0.2), 0.5),),
        (FLOOR,),
        ABOVE,
    ),
    Scene(
        "far",
        "a tiny far light, a thousandth of its distance: what single precision resolves",
        (Light((30, 0, 40), 0.05, 1e5),),
        (FLOOR,),
        ABOVE,
    ),
    Scene(
        "touching",
        "a light that all but touches the floor: the cap fills the hemisphere",
        (Light((0, 0, 0.501), 0.5),),
        (FLOOR,),
        Camera((0.4, -1.2, 2.4), (0.15, 0.1, 0)),
    ),
    Scene(
        "two lights",
        "above a ball and a box, whose own horizons cut the lights; the lamps shade each other",
        (Light((-0.9, -0.6, 1.2), 0.3, 2.0), Light((1.1, 0.9, 0.5), 0.3, 1.5)),
        (FLOOR, Ball((-0.45, 0.5, 0.35), 0.35, 0.7), Box((0.4, -0.3, 0), (0.8, 0.1, 0.5), 0.5)),
        ABOVE,
    ),
    Scene(
        "ten lights",
        "large and small ones around a wall and a ball: which of them to sample, each point decides",
        (
            Light((-1.6, 1.5, 1.0), 0.35, 2.0),
            Light((-0.3, 1.9, 0.7), 0.12, 12.0),
            Light((0.9, 1.7, 0.4), 0.25, 3.0),
            Light((2.1, 1.2, 1.4), 0.3, 3.0),
            Light((-2.0, 0.2, 0.5), 0.3, 2.0),
            Light((1.9, -0.4, 0.6), 0.1, 15.0),
            Light((-1.2, -1.0, 0.5), 0.05, 40.0),
            Light((0.2, -0.9, 1.1), 0.2, 4.0),
            Light((1.2, -1.3, 0.5), 0.3, 2.0),
            Light((0.1, 0.3, 2.2), 0.15, 8.0),
        ),
        (FLOOR, Box((-1.3, 0.6, 0), (1.3, 0.75, 0.9), 0.5), Ball((0.5, -0.1, 0.3), 0.3, 0.7)),
        ABOVE,
    ),
    Scene(
        "sheet",
        "a sheet seen from its back, the light across its plane: both sides are lit, each by its part",
        (Light((-0.1, -0.2, 1.8), 0.35, 2.0),),
        (FLOOR, Rectangle((0, 0, 0.7), (0, 0.8, 0), (0, 0, 0.7), 0.7, two_sided=True)),
        Camera((-2.6, -2.2, 2.4), (0, 0, 0.5)),
    ),
    Scene(
        "closed box",
        "two bounces in a closed room, the light half in its ceiling: for path tracers",
        (Light((0.2, 0.1, 1.95), 0.3, 4.0),),
        (*_room(0.6), Box((-0.7, 0.1, 0), (-0.2, 0.6, 0.8), 0.6)),
        Camera((0, -0.95, 1.1), (0, 1, 0.7), 80.0),
        bounces=2,
    ),
)


def by_name(name: str) -> Scene:
    """Return a scene, or raise with the names that there are."""
    for scene in SCENES:
        if scene.name == name:
            return scene
    raise ValueError(f"there is no scene '{name}'; choose one of: {', '.join(s.name for s in SCENES)}")


def as_text(scene: Scene, width: int, height: int) -> str:
    """Return the scene as `tests/c/renderer.c` reads it."""
    lines = [f"# {scene.name}: {scene.about}", f"image {width} {height}", f"bounces {scene.bounces}"]

    def line(word: str, *numbers: float | Vector) -> None:
        flat = [x for n in numbers for x in (n if isinstance(n, tuple) else (n,))]
        lines.append(" ".join([word, *(f"{x:.9g}" for x in flat)]))

    line("camera", scene.camera.eye, scene.camera.target, scene.camera.fov)
    for light in scene.lights:
        line("light", light.centre, light.radius, light.radiance)
    for shape in scene.shapes:
        match shape:
            case Rectangle(centre, u, v, albedo):
                line("rectangle", centre, u, v, albedo)
            case Ball(centre, radius, albedo):
                line("ball", centre, radius, albedo)
            case Box(low, high, albedo):
                line("box", low, high, albedo)
    return "\n".join(lines) + "\n"
