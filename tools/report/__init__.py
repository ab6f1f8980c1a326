"""The report of speed against error: `make report`.

`build.py` puts the page together; each other file is one of its sections or what they share.
"""

import renderlab  # noqa: F401 (before Mitsuba: it tells Dr.Jit where LLVM is)
