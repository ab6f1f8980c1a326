"""Tests of the same light in several renderers. One that is missing fails them, with what to do."""

import sys
from pathlib import Path

REPOSITORY = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(REPOSITORY / "tools"))

import renderlab  # noqa: E402, F401 (registers the plugin, or says how to build it)
