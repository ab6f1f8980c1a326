"""`pip install` gives packages and a command that need neither this repository nor a path to it."""

import os
import re
import subprocess
import sys
import sysconfig
import zipfile
from importlib import metadata
from pathlib import Path

import pytest
import tomllib

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


@pytest.fixture(scope="module")
def environment(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A new virtual environment, in a folder with a space, that has what this one has."""
    folder = tmp_path_factory.mktemp("an environment") / "venv"
    run(sys.executable, "-m", "venv", "--without-pip", folder)
    (site,) = folder.glob("lib/python*/site-packages")
    (site / "everything_else.pth").write_text(sysconfig.get_path("purelib") + "\n")
    return folder


def test_the_wheel_holds_the_packages_and_nothing_else(wheel: Path) -> None:
    """Python, the plugin, one CMake module; for any Python, on Linux; of the library's version."""
    names = zipfile.ZipFile(wheel).namelist()
    ours = {name for name in names if ".dist-info/" not in name}
    package = REPOSITORY / "mitsuba_plugin"
    python = {path.relative_to(package).as_posix() for path in package.glob("spherecap*/*.py")}
    assert ours == python | {
        "spherecap/plugins/spherecap.so",
        "spherecap/plugins/spherecap_emitter.so",
        "spherecap/cmake/FindMitsubaWheel.cmake",
    }
    version = tomllib.loads((REPOSITORY / "Cargo.toml").read_text())["package"]["version"]
    assert wheel.name == f"spherecap-{version}-py3-none-linux_x86_64.whl"


def test_the_wheel_depends_on_the_mitsuba_that_it_was_built_for(wheel: Path) -> None:
    """Which is the one that is installed."""
    with zipfile.ZipFile(wheel) as archive:
        (file,) = (name for name in archive.namelist() if name.endswith(".dist-info/METADATA"))
        lines = archive.read(file).decode().splitlines()
    assert f"Requires-Dist: mitsuba=={metadata.version('mitsuba')}" in lines


def test_installed_used_and_uninstalled(wheel: Path, environment: Path, tmp_path: Path) -> None:
    """The import is all that the emitter needs; the command is there; and afterwards all is as before."""
    before = sorted(environment.rglob("*"))
    pip = (sys.executable, "-m", "pip", "--python", environment / "bin/python", "--disable-pip-version-check")
    run(*pip, "install", "--quiet", "--no-deps", "--no-index", wheel)
    program = """
import mitsuba as mi, spherecap
mi.set_variant("scalar_rgb")
print(spherecap.PLUGIN)
print(mi.load_dict({"type": "sphere", "emitter": {"type": "spherecap"}}).emitter().class_name())
"""
    plugin, name = run(environment / "bin/python", "-c", program).split("\n")[:2]
    assert Path(plugin).is_relative_to(environment)
    assert name == "SphereCap"

    command = environment / "bin/spherecap"
    version = wheel.name.split("-")[1]
    assert f"spherecap {version}\n" in run(command, "info")
    scene = REPOSITORY / "scenes/cut_light.xml"
    words = ("-D", "width=16", "-D", "height=12", "--spp", "1", "--reference", "8")
    output = ("--output", tmp_path / "compared")
    printed = run(command, "compare", scene, *words, *output)
    assert re.search(r"^ +1 +spherecap +[\d.]+ +[\d.]+ +[\d.]+x +[\d.]+x$", printed, re.MULTILINE)
    assert (tmp_path / "compared/index.html").is_file()

    run(*pip, "uninstall", "--quiet", "--yes", "spherecap")
    assert sorted(environment.rglob("*")) == before
