"""Small inputs of the report, as the Rust programs write them, with numbers that are easy to find again."""

import json
from itertools import product
from pathlib import Path

ABOUT = {
    "machine": "a machine <&>",
    "commit": "0123abcd",
    "compiler": "rustc",
    "command": "make bench",
    "seed": "1",
    "date": "2026-01-01T00:00:00Z",
}
SETS = ("case 1", "case 2", "case 3", "mix")
METHODS = ("solid_angle", "published", "projected_bounded", "projected")
TIMED = ("solid_angle", "published", "published, cube root", "projected_bounded", "projected")
TASKS = ("prepare + 1 sample", "prepare + 16 samples")
ELEVATIONS = [-60.0, -30.0, 30.0, 60.0]
RADII = [0.25, 0.75]
MAP = [[None, 0.5, 1e-3, 1e-7], [0.2, 0.3, 2e-3, 2e-7]]


def ways() -> list[tuple[str, str, str, str]]:
    """Return (set, lane, method, task) of all that is timed and counted."""
    scalars = [("f32", task) for task in TASKS]
    packets = [(lane, TASKS[0]) for lane in ("AVX2", "AVX-512")]
    return [
        (name, lane, method, task)
        for name, method, (lane, task) in product(SETS, TIMED, scalars + packets)
        if lane == "f32" or not method.startswith("published")
    ]


def rows(column: str, first: float, step: float) -> list[dict]:
    """Return a row with a number of its own for each way."""
    keys = ("set", "lane", "method", "task")
    return [
        dict(zip(keys, way, strict=True)) | {"nanoseconds": 10.0 + i, column: first + i * step}
        for i, way in enumerate(ways())
    ]


def write_inputs(folder: Path) -> None:
    """Write all inputs."""
    folder.mkdir(parents=True, exist_ok=True)
    found = list(product(SETS, METHODS))
    kinds = ("area", "density", "position", "inverse", "lost")
    maps = {
        "inverse": [{"set": s, "method": m, "rms": 1e-6, "worst": 1e-5, "finite": 1} for s, m in found],
        "deviation": [{"set": s, "method": m, "deviation": 0.25, "finite": 1} for s, m in found],
        "bound_curve": {"inverse_radius": [1.001, 1.5, 2.0, 3.0], "bound": [14.0, 1.7, 1.4142, 1.4142]},
        "deviation_maps": {"elevation": ELEVATIONS, "radius": RADII}
        | dict.fromkeys(METHODS, MAP)
        | {"bound": [[None, 1.5, 1, 1], [1.9, 1.8, 1, 1]], "spread": [[None, 1.2, 1, 1], [1.71, 1.7, 1, 1]]},
        "error_maps": {
            "column": [-0.5, 0.25, 0.75, 1.5],
            "radius": RADII,
            "radius_complement": [0.75, 0.25],
            "samples": 128,
        }
        | {method: dict.fromkeys(kinds, MAP) for method in METHODS[1:]},
    }
    maps["error_maps"]["published"] = maps["error_maps"]["published"] | {"area": [[None] * 4] * 2}
    inputs = {
        "bench": {"rows": rows("ratio", 1.001, 0.01)},
        "instructions": {"rows": rows("instructions", 101.0, 1.0)},
        "maps": maps,
    }
    for name, values in inputs.items():
        (folder / f"{name}.json").write_text(json.dumps(ABOUT | values))
