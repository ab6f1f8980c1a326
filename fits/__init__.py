"""Every fitted constant of the library, and the scripts that make it: see README.md."""

import os

# One thread, set before numpy loads: sums are then always made in the same order. The matrices are small
# anyway.
os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")
