"""`make valgrind` where valgrind is not installed."""

import shutil
import subprocess
from pathlib import Path

REPOSITORY = Path(__file__).resolve().parents[2]


def test_without_valgrind_it_says_what_is_missing(tmp_path: Path) -> None:
    """With a path on which there is a shell alone."""
    (tmp_path / "sh").symlink_to(shutil.which("sh"))
    script = [str(tmp_path / "sh"), str(REPOSITORY / "tests/c/valgrind.sh")]
    done = subprocess.run(script, env={"PATH": str(tmp_path)}, capture_output=True, text=True, check=False)
    assert done.returncode == 1
    assert "needs valgrind, which is not installed" in done.stderr
