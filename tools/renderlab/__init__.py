"""What the demo and the render tests share: scenes, reference images, error measures, pictures.

Knowledge points one way: this package knows Mitsuba's Python interface and the scenes of the repository, and
nothing of the Rust library, so that its analytic references are independent of the code under test.
"""

import contextlib
import importlib
import sys
from pathlib import Path

# The package of the emitter tells Dr.Jit where LLVM is, so it comes before Mitsuba. (`register_plugin`
# complains if the emitter is not built.)
sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "mitsuba_plugin"))
with contextlib.suppress(ImportError):
    importlib.import_module("spherecap")
