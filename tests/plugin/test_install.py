"""`pip install` gives a package that needs neither this repository nor a path to it."""

import os
import subprocess
import sys
import zipfile
from pathlib import Path

import pytest

REPOSITORY = Path(__file__).resolve().parents[2]
TOOLS = Path(sys.executable).parent  # cmake and ninja are in the same environment


def run(*command: object, **variables: str) -> str:
    """Run a command outside of the repository and return what it printed."""
    environment = {k: v for k, v in os.environ.items() if k != "PYTHONPATH"}
    environment |= {"PATH": f"{TOOLS}{os.pathsep}{environment['PATH']}", **variables}
    words = [str(word) for word in command]
    done = subprocess.run(words, env=environment, cwd="/", capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stdout + done.stderr
    return done.stdout


@pytest.fixture(scope="module")
def wheel(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Build the wheel, with the build requirements of this environment (so without a network)."""
    folder = tmp_path_factory.mktemp("a wheel")
    pip = (sys.executable, "-m", "pip", "wheel", "--quiet", "--disable-pip-version-check")
    run(*pip, "--no-deps", "--no-build-isolation", "--no-index", "--wheel-dir", folder, REPOSITORY)
    (path,) = folder.glob("*.whl")
    return path


def test_the_wheel_holds_the_package_and_nothing_else(wheel: Path) -> None:
    """One module, one plugin; for any Python, on Linux."""
    names = zipfile.ZipFile(wheel).namelist()
    ours = sorted(name for name in names if ".dist-info/" not in name)
    assert ours == ["spherecap/__init__.py", "spherecap/plugins/spherecap.so"]
    assert wheel.name.endswith("-py3-none-linux_x86_64.whl")


def test_the_installed_package_registers_the_emitter(wheel: Path, tmp_path: Path) -> None:
    """Installed in a folder with a space, the import is all that a user needs."""
    site = tmp_path / "a site"
    pip = (sys.executable, "-m", "pip", "install", "--quiet", "--disable-pip-version-check")
    run(*pip, "--no-deps", "--no-index", "--target", site, wheel)
    program = """
import mitsuba as mi, spherecap
mi.set_variant("scalar_rgb")
print(spherecap.PLUGIN)
print(mi.load_dict({"type": "sphere", "emitter": {"type": "spherecap"}}).emitter().class_name())
"""
    plugin, name = run(sys.executable, "-c", program, PYTHONPATH=str(site)).split("\n")[:2]
    assert Path(plugin) == site / "spherecap/plugins/spherecap.so"
    assert name == "SphereCap"
