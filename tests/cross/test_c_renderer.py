"""The C renderer: mistakes in command lines and scene files are explained, and lights are chosen well.

By the inline header alone it renders the same.
"""

import subprocess
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from cross.render_c import PROGRAM, read_pfm
from cross.scene import SCENES, Scene, as_text, by_name

SCENE = as_text(by_name("S1"), 8, 6)

INLINE = PROGRAM.with_name("renderer_inline")
WIDTH, HEIGHT, SEEDS = 32, 24, 128


def run(scene: str, *arguments: str, program: Path = PROGRAM) -> subprocess.CompletedProcess:
    """Run it."""
    return subprocess.run([program, *arguments], input=scene.encode(), capture_output=True)


def test_writes_an_image() -> None:
    """Of the size that was asked for, reproducibly."""
    done = run(SCENE, "projected", "independent", "4", "7")
    assert done.returncode == 0, done.stderr
    image = read_pfm(done.stdout)
    assert image.shape == (6, 8)
    assert image.min() > 0
    assert run(SCENE, "projected", "independent", "4", "7").stdout == done.stdout


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        ([], "usage: renderer"),
        (["projected", "independent", "4"], "usage: renderer"),
        (["guessed", "independent", "4", "1"], "no such choice: guessed"),
        (["projected", "guessed", "4", "1"], "no such choice: guessed"),
        (["projected", "independent", "0", "1"], "out of range: 0"),
        (["projected", "independent", "4x", "1"], "not a whole number, or out of range: 4x"),
        (["projected", "independent", "4", "-1"], "out of range: -1"),
    ],
)
def test_bad_arguments_are_explained(arguments: list[str], words: str) -> None:
    """And nothing is written."""
    done = run(SCENE, *arguments)
    assert done.returncode == 1
    assert words in done.stderr.decode()
    assert not done.stdout


@pytest.mark.parametrize(
    ("line", "words"),
    [
        ("cone 0 0 1 1 1", "line 7 of the scene: there is nothing called 'cone'"),
        (
            "light 0 0 1 1",
            "line 7 of the scene: a number is missing. After 'light' come: centre, radius, radiance.",
        ),
        ("light 0 0 1 1 1 1", "line 7 of the scene: there is something else"),
        ("light 0 0 one 1 1", "line 7 of the scene: there is something else"),
        ("light 0 0 nan 1 1", "line 7 of the scene: there is something else"),
        ("light 0 0 1 -1 1", "the radius is not positive"),
        ("ball 0 0 1 0 0.5", "it has no extent"),
        ("ball 0 0 1 1 1.5", "the albedo is not in [0, 1]"),
        ("box 0 0 0 1 1 0 0.5", "it has no extent"),
        ("rectangle 0 0 0 1 0 0 2 0 0 0.5", "it has no extent"),
        ("camera 0 0 5 0 0 0 50", "the view is vertical"),
        ("image 0 5", "the size is not between"),
        ("bounces 2", "this renderer cannot do that"),
        ("light 0 0 1 1 1\n" * 64, "line 70 of the scene: there are too many lights"),
        ("ball 0 0 1 1 0\n" * 64, "line 70 of the scene: there are too many shapes"),
    ],
)
def test_bad_scenes_are_explained(line: str, words: str) -> None:
    """With the number of the line."""
    assert len(SCENE.splitlines()) == 6
    done = run(SCENE + line + "\n", "projected", "independent", "1", "1")
    assert done.returncode == 1
    assert words in done.stderr.decode()
    assert not done.stdout


def test_a_scene_without_a_camera_is_refused() -> None:
    """As is an empty one."""
    done = run("# nothing\n", "projected", "independent", "1", "1")
    assert done.returncode == 1
    assert "no line 'image'" in done.stderr.decode()


@pytest.mark.parametrize("name", [scene.name for scene in SCENES if scene.bounces == 0])
def test_the_inline_header_renders_the_same(name: str) -> None:
    """To the bit, in all scenes that it can render."""
    text, arguments = as_text(by_name(name), WIDTH, HEIGHT), ("projected", "independent", "4", "7")
    by_library, by_header = run(text, *arguments), run(text, *arguments, program=INLINE)
    assert by_library.returncode == by_header.returncode == 0, by_library.stderr + by_header.stderr
    assert read_pfm(by_library.stdout).max() > 0
    assert by_header.stdout == by_library.stdout


def test_the_inline_header_says_which_technique_it_has() -> None:
    """And renders nothing by another."""
    done = run(SCENE, "solid_angle", "independent", "1", "1", program=INLINE)
    assert done.returncode == 1
    assert "say `projected`" in done.stderr.decode()
    assert not done.stdout


def moments(scene: Scene, technique: str) -> tuple[np.ndarray, np.ndarray]:
    """Return each pixel's mean over renders with one sample, and its variance."""
    text = as_text(scene, WIDTH, HEIGHT)
    images = [read_pfm(run(text, technique, "independent", "1", str(seed)).stdout) for seed in range(SEEDS)]
    stack = np.stack(images).astype(np.float64)
    return stack.mean(axis=0), stack.var(axis=0, ddof=1)


# The gain is how many times smaller the variance is, at least: measured were 20 and 53 by projected solid
# angle, 6.6 and 13 by solid angle.
@pytest.mark.parametrize("technique", ["projected", "solid_angle"])
@pytest.mark.parametrize(("name", "gain"), [("two lights", 5), ("ten lights", 10)])
def test_lights_are_chosen_by_what_they_give(name: str, gain: float, technique: str) -> None:
    """The mean is the sum of what the lights give alone, the variance far below that of a uniform choice.

    Alone, the others being black lamps, a light is chosen with certainty. From the images x of the N lights
    follows what a uniform choice gives: the mean sum x, and the variance N sum x^2 - (sum x)^2.
    """
    scene = by_name(name)
    count = len(scene.lights)
    total, second, noise = 0.0, 0.0, 0.0
    for shining in range(count):
        lights = [
            light if k == shining else replace(light, radiance=0.0) for k, light in enumerate(scene.lights)
        ]
        mean, variance = moments(replace(scene, lights=tuple(lights)), technique)
        total, noise = total + mean, noise + variance
        second = second + mean**2 + variance
    uniform = count * second - total**2
    mean, variance = moments(scene, technique)
    error = np.sqrt((variance + noise).sum() / SEEDS)
    assert abs(mean.sum() - total.sum()) < 3 * error
    assert abs(0.99 * mean.sum() - total.sum()) > 3 * error, "too noisy to tell a darker copy"
    assert variance.mean() * gain < uniform.mean()
