"""The demo from end to end, small, and what it says when something is wrong."""

import os
import subprocess
import sys

import pytest
from renderlab.scenes import OUTPUT, REPOSITORY
from spherecap_command.scene import OURS


def run(*command: str) -> subprocess.CompletedProcess:
    """Run Python in the repository; the plugin must be found without help from the environment."""
    environment = {key: value for key, value in os.environ.items() if key != "PYTHONPATH"}
    return subprocess.run(
        [sys.executable, *command],
        cwd=REPOSITORY,
        env=environment,
        capture_output=True,
        text=True,
        timeout=300,
    )


def test_prints_a_table_and_saves_a_picture(request: pytest.FixtureRequest) -> None:
    """A tiny run of the default scene."""
    if request.config.getoption("--candidate", default=OURS) != OURS:
        pytest.skip("checks the tests themselves: the demo needs our emitter")
    picture = OUTPUT / "demo" / "cut_light-1spp-scalar_rgb.png"
    picture.unlink(missing_ok=True)
    done = run("tools/demo.py", "--spp", "1", "--width", "32")
    assert done.returncode == 0, done.stderr
    assert "spherecap" in done.stdout
    assert str(picture) in done.stdout
    assert picture.stat().st_size > 10_000


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        (["--scene", "moon"], ["no scene 'moon'", "open_floor"]),
        (["--variant", "quantum_rgb"], ["no variant 'quantum_rgb'", "scalar_rgb"]),
        (["--spp", "0"], ["--spp must be at least 1"]),
    ],
)
def test_mistakes_are_explained(arguments: list[str], words: list[str]) -> None:
    """No traceback, and the choices that there are."""
    done = run("tools/demo.py", *arguments)
    assert done.returncode != 0
    assert "Traceback" not in done.stderr
    for word in words:
        assert word in done.stderr
