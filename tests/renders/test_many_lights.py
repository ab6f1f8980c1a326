"""The table of equal-time ratios for several lights, small, and what it says when something is wrong."""

import os
import subprocess
import sys

import pytest
from renderlab.scenes import REPOSITORY


def run(*arguments: str) -> subprocess.CompletedProcess:
    """Run it as `make lights` does, on tiny images."""
    command = [sys.executable, "tools/many_lights.py", "--width", "12", "--seeds", "4", *arguments]
    environment = {**os.environ, "PYTHONPATH": "mitsuba_plugin"}
    return subprocess.run(
        command, cwd=REPOSITORY, env=environment, capture_output=True, text=True, timeout=300
    )


def rows(printed: str) -> dict[tuple[str, str], list[float]]:
    """Return the numbers of each scene and variant."""
    lines = [(line[:30].strip(), *line[30:].split()) for line in printed.splitlines()[3:]]
    return {(name, variant): [float(cell) for cell in cells] for name, variant, *cells in lines}


def test_prints_a_row_for_each_scene() -> None:
    """With both ratios and both times."""
    done = run("--variants", "scalar_rgb")
    assert done.returncode == 0, done.stderr
    found = rows(done.stdout)
    scenes = [
        "2 lights",
        "several_lights",
        "10 lights",
        "100 lights",
        "several_lights, path with MIS",
        "wall",
    ]
    assert list(found) == [(scene, "scalar_rgb") for scene in scenes]
    for numbers in found.values():
        assert len(numbers) == 4
        assert all(0 < number < float("inf") for number in numbers)
    # A tenth of what is usual: noise in so small images, and a busy machine, leave more than that.
    assert found["10 lights", "scalar_rgb"][1] > 4


def test_compiled_variants_are_measured() -> None:
    """Beside each other, on a scene of one's choice."""
    done = run("--scenes", "2 lights", "--variants", "llvm_ad_rgb", "scalar_rgb")
    assert done.returncode == 0, done.stderr
    assert list(rows(done.stdout)) == [("2 lights", "llvm_ad_rgb"), ("2 lights", "scalar_rgb")]


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        (["--scenes", "moon"], ["invalid choice: 'moon'", "several_lights, path with MIS"]),
        (["--variants", "quantum_rgb"], ["no variant 'quantum_rgb'", "scalar_rgb"]),
        (["--seeds", "1"], ["--seeds at least 2"]),
    ],
)
def test_mistakes_are_explained(arguments: list[str], words: list[str]) -> None:
    """No traceback, and the choices that there are."""
    done = run(*arguments)
    assert done.returncode != 0
    assert "Traceback" not in done.stderr
    for word in words:
        assert word in done.stderr
