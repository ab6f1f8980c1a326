"""A folder of its own for the kernels that Dr.Jit keeps, for programs that measure compilation.

To be imported before Dr.Jit, which looks only then where it shall keep them.
"""

import os
import tempfile
from pathlib import Path

_FOLDER = tempfile.TemporaryDirectory()
os.environ["DRJIT_CACHE_DIR"] = _FOLDER.name


def forget() -> None:
    """Forget all kernels: the next ones are compiled, whatever was compiled before."""
    import drjit

    drjit.flush_kernel_cache()
    for kernel in Path(_FOLDER.name).iterdir():
        kernel.unlink()
