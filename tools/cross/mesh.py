"""The shapes as triangles, for renderers that know nothing else."""

import math

from cross.scene import Ball, Box, Rectangle, Scene, Shape, Vector

Mesh = tuple[list[Vector], list[tuple[int, int, int]]]


def ball_mesh(centre: Vector, radius: float) -> Mesh:
    """Return vertices and triangles of a sphere.

    128 x 256 facets: the radius is at most 1e-4 too small, the shadow's area by 1.5e-4 of itself.
    """
    rings, sectors = 128, 256
    vertices = []
    for i in range(rings + 1):
        z, r = math.cos(math.pi * i / rings), math.sin(math.pi * i / rings)
        for j in range(sectors):
            angle = 2 * math.pi * j / sectors
            offset = (r * math.cos(angle), r * math.sin(angle), z)
            vertices.append(tuple(c + radius * o for c, o in zip(centre, offset, strict=True)))
    triangles = []
    for i in range(rings):
        for j in range(sectors):
            a, b = i * sectors + j, i * sectors + (j + 1) % sectors
            c, d = a + sectors, b + sectors
            if i > 0:
                triangles.append((a, c, b))
            if i < rings - 1:
                triangles.append((b, c, d))
    return vertices, triangles


def mesh(shape: Shape) -> Mesh:
    """Return vertices and triangles of a shape."""
    match shape:
        case Ball(centre, radius, _):
            return ball_mesh(centre, radius)
        case Rectangle(centre, u, v):
            corners = [(-1, -1), (1, -1), (1, 1), (-1, 1)]
            points = [tuple(centre[i] + a * u[i] + b * v[i] for i in range(3)) for a, b in corners]
            return points, [(0, 1, 2), (0, 2, 3)]
        case Box(low, high, _):
            ends = (low, high)
            points = [(ends[i][0], ends[j][1], ends[k][2]) for i in (0, 1) for j in (0, 1) for k in (0, 1)]
            quads = [(0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3)]
            return points, [t for a, b, c, d in quads for t in ((a, b, c), (a, c, d))]


def lamp_bodies(scene: Scene) -> list[Ball]:
    """Return the lamps' bodies, for renderers whose lamps are nothing but light.

    Slightly smaller, so that rays to the lamp's surface end before them.
    """
    return [
        Ball(light.centre, 0.999 * light.radius, 0.0) for light in scene.lights if scene.lamps_block_light
    ]
