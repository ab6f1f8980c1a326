"""What the demo and the render tests share: the repository's scenes, analytic references, tests of equality.

Knowledge points one way: this package knows Mitsuba's Python interface, what the command `spherecap` measures
with, and the scenes of the repository. It knows nothing of the Rust library, so that its analytic references
are independent of the code under test.
"""

import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "mitsuba_plugin"))

# Before Mitsuba: it tells Dr.Jit where LLVM is. And how to build the plugin if it is missing.
import spherecap  # noqa: F401
