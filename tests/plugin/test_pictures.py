"""What the command's pictures show: all of an image, whatever its contrast."""

import numpy as np
import pytest
from spherecap_command.pictures import exposure, signed, to_srgb


def grey(values: np.ndarray) -> np.ndarray:
    """Return an image of one row."""
    return np.broadcast_to(np.asarray(values, dtype=float)[None, :, None], (1, len(values), 3))


def test_low_contrast_is_shown_as_it_is() -> None:
    """Brightness in proportion, and only what is brighter than nearly all is clipped."""
    image = grey(np.linspace(0.5, 1.5, 101))
    exposed = exposure(image)
    linear = exposed(image)
    np.testing.assert_allclose(linear, image * 0.8 / np.percentile(image, 95), rtol=1e-12)
    assert exposed(grey([100]))[0, 0, 0] == 1


def test_high_contrast_shows_both_ends() -> None:
    """A dim room and a bright window: neither is black, and the window has shades."""
    image = grey([0.01] * 60 + [0.02] * 20 + list(np.linspace(10, 20, 20)))
    shown = to_srgb(image, exposure(image))[0, :, 0]
    assert 0.3 < shown[0] < shown[70] < 0.75
    assert shown[70] + 0.15 < shown[80] < shown[90] < 1


@pytest.mark.parametrize("lit", [1, 3])
def test_few_lit_pixels_are_not_all_white(lit: int) -> None:
    """Under a spot in the dark, nor is the dark taken for the image."""
    image = grey([0.0] * 97 + [1.0, 2.0, 3.0][:lit] + [0.0] * (3 - lit))
    shown = to_srgb(image, exposure(image))[0, :, 0]
    assert shown[0] == 0
    assert 0.5 < shown[97] <= 1
    assert list(shown[97 : 97 + lit]) == sorted(shown[97 : 97 + lit])


def test_a_black_image_is_black() -> None:
    """Without a warning."""
    image = grey([0.0, 0.0])
    np.testing.assert_array_equal(to_srgb(image, exposure(image)), 0)


def test_errors_have_colours() -> None:
    """White is none; too dark is blue, too bright red, and what is beyond the ends is as the ends."""
    colours = signed(np.array([0, -1, -5, 1, 5, 0.1]))
    np.testing.assert_array_equal(colours[0], 1)
    np.testing.assert_array_equal(colours[1], colours[2])
    np.testing.assert_array_equal(colours[3], colours[4])
    assert colours[1, 2] > colours[1, 0]
    assert colours[3, 0] > colours[3, 2]
    assert np.all(colours[5] > 0.9)
