"""Tests of the Mitsuba plugin. They need it built (`make build`), and fail, never skip, without it."""

import sys
from pathlib import Path

import pytest

REPOSITORY = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(REPOSITORY / "mitsuba_plugin"))

# Before Mitsuba: it says where LLVM is. And how to build the plugin if it is missing.
import spherecap  # noqa: E402, F401

import mitsuba as mi  # noqa: E402  # isort: skip

SCALAR_VARIANTS = [variant for variant in mi.variants() if variant.startswith("scalar_")]
assert len(SCALAR_VARIANTS) == 3, f"the wheel has other scalar variants than expected: {SCALAR_VARIANTS}"


@pytest.fixture(params=SCALAR_VARIANTS)
def variant(request):
    """Runs a test once in every scalar variant."""
    mi.set_variant(request.param)
    return request.param


@pytest.fixture
def scalar_rgb():
    """Runs a test in one variant: for what does not depend on colours."""
    mi.set_variant("scalar_rgb")
