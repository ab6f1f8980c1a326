"""The README's examples run as they stand."""

import re
from pathlib import Path

import mitsuba as mi
import numpy as np
import pytest

README = Path(__file__).parents[2] / "README.md"


def block(language: str) -> str:
    """Return the README's one block of code in this language."""
    blocks = re.findall(rf"```{language}\n(.*?)```", README.read_text(encoding="utf-8"), re.DOTALL)
    assert len(blocks) == 1, f"the README has {len(blocks)} examples in {language}"
    return blocks[0]


@pytest.fixture(scope="module")
def image_from_python() -> np.ndarray:
    """Run the Python example and return the image that it renders."""
    names = {}
    exec(block("python"), names)
    return np.array(names["image"])


def test_the_python_example_renders(image_from_python: np.ndarray) -> None:
    """The example renders a floor that is lit everywhere."""
    assert image_from_python.shape == (48, 64, 3)
    assert np.all(np.isfinite(image_from_python))
    assert np.median(image_from_python) > 0


def test_the_xml_example_is_the_same_scene(image_from_python: np.ndarray) -> None:
    """Both examples show one scene: the same samples give the same image."""
    mi.set_variant("scalar_rgb")
    image = np.array(mi.render(mi.load_string(block("xml")), spp=4))
    # Transformations are composed in another order of roundings.
    np.testing.assert_allclose(image, image_from_python, rtol=1e-3, atol=1e-4)
