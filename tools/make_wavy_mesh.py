"""Write scenes/meshes/wavy.obj: a coarse wavy sheet with the exact normals of the wave at its vertices.

The grid is coarse on purpose. The wave turns by up to 15 degrees within one triangle, so the interpolated
(shading) normal and the flat (geometric) one disagree strongly, which is what the scene smooth_mesh is for.
Lengths are scene units.
"""

from pathlib import Path

import numpy as np

OUTPUT = Path(__file__).resolve().parent.parent / "scenes" / "meshes" / "wavy.obj"
CELLS = 12
HALF_WIDTH = 1.5
AMPLITUDE = 0.12
WAVELENGTH = 1.5


def wave(x: float, y: float) -> tuple[float, np.ndarray]:
    """Return the height above the mean plane at (x, y), and the unit normal there (upwards)."""
    k = 2 * np.pi / WAVELENGTH
    height = AMPLITUDE * np.cos(k * x) * np.cos(k * y)
    slope_x = -AMPLITUDE * k * np.sin(k * x) * np.cos(k * y)
    slope_y = -AMPLITUDE * k * np.cos(k * x) * np.sin(k * y)
    normal = np.array([-slope_x, -slope_y, 1.0])
    return height, normal / np.linalg.norm(normal)


def main() -> None:
    """Write the mesh; two triangles per cell, vertices shared."""
    ticks = np.linspace(-HALF_WIDTH, HALF_WIDTH, CELLS + 1)
    lines = ["# Written by tools/make_wavy_mesh.py"]
    points, normals = [], []
    for y in ticks:
        for x in ticks:
            height, normal = wave(x, y)
            points.append(f"v {x:g} {y:g} {height:.4f}")
            normals.append("vn {:.4f} {:.4f} {:.4f}".format(*normal))
    lines += points + normals
    row = CELLS + 1
    for j in range(CELLS):
        for i in range(CELLS):
            a = j * row + i + 1  # OBJ counts vertices from one.
            b, c, d = a + 1, a + row + 1, a + row
            lines.append(f"f {a}//{a} {b}//{b} {c}//{c}")
            lines.append(f"f {a}//{a} {c}//{c} {d}//{d}")
    OUTPUT.parent.mkdir(parents=True, exist_ok=True)
    OUTPUT.write_text("\n".join(lines) + "\n")
    print(f"wrote {OUTPUT}: {len(points)} vertices, {2 * CELLS * CELLS} triangles")


if __name__ == "__main__":
    main()
