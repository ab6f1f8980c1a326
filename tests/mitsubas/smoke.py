"""Every Mitsuba that the plugin can be built for, each in its environment, which `make test-mitsubas` makes.

They render with the plugin that `pip install --no-build-isolation .` built there; it refuses the others.
"""

import json
import math
import os
import re
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

REPOSITORY = Path(__file__).resolve().parents[2]
CMAKE_LISTS = (REPOSITORY / "mitsuba_plugin/CMakeLists.txt").read_text(encoding="utf-8")
NEWEST, *OLDER = re.search(r"^set\(mitsubas (.*)\)$", CMAKE_LISTS, re.MULTILINE)[1].split()
UNSUPPORTED = "3.6.4"  # calls other functions of a plugin

# The folder of each Mitsuba's programs, and that of the package which was built for it.
PROGRAMS = {NEWEST: Path(sys.executable).parent}
PLUGINS = {NEWEST: REPOSITORY / "mitsuba_plugin/spherecap"}
for version in (*OLDER, UNSUPPORTED):
    PROGRAMS[version] = REPOSITORY / f".venv-mitsuba-{version}/bin"
for version in OLDER:
    (PLUGINS[version],) = PROGRAMS[version].parent.glob("lib/python*/site-packages/spherecap")

VARIANTS = [(version, variant) for version in PLUGINS for variant in ("scalar_rgb", "llvm_ad_rgb")]
STRANGERS = [(plugin, mitsuba) for plugin in PLUGINS for mitsuba in PROGRAMS if plugin != mitsuba]
SCENE = """<scene version="3.0.0">
    <integrator type="direct"/>
    <sensor type="perspective"/>
    <shape type="sphere"><emitter type="spherecap"/></shape>
</scene>
"""


def run(*command: object, path: Path | None = None) -> tuple[int, str]:
    """Run a command, outside of the repository, and return its exit status and what it printed."""
    environment = {k: v for k, v in os.environ.items() if k != "PYTHONPATH"}
    if path:
        environment["PYTHONPATH"] = str(path)
    words = [str(word) for word in command]
    streams = {"stdout": subprocess.PIPE, "stderr": subprocess.STDOUT, "text": True}
    done = subprocess.run(words, env=environment, cwd="/", timeout=600, check=False, **streams)
    return done.returncode, done.stdout


@pytest.fixture(scope="module", params=VARIANTS, ids="-".join)
def rendered(request: pytest.FixtureRequest) -> dict:
    """What `renders.py` found with one Mitsuba, in one variant."""
    version, variant = request.param
    program = Path(__file__).parent / "renders.py"
    code, text = run(PROGRAMS[version] / "python", program, variant, path=PLUGINS[version].parent)
    assert code == 0, text
    found = json.loads(text.splitlines()[-1])
    assert found["mitsuba"] == found["built for"] == version
    return found


def test_same_light_less_noise(rendered: dict) -> None:
    """Both emitters light the floor alike, where the light was and where it is moved to."""
    for place in ("in place", "moved"):
        area, spherecap = rendered["area"][place], rendered["spherecap"][place]
        print(f"{place}: area {area}, spherecap {spherecap}")
        # The seeds are fixed. By chance one comparison in a thousand would fail (Student's t, 15 degrees).
        error = math.hypot(area["error"], spherecap["error"])
        assert abs(area["mean"] - spherecap["mean"]) < 4 * error
        assert 0 < spherecap["noise"] < 0.5 * area["noise"]
    # The light rises above the floor.
    assert rendered["spherecap"]["moved"]["mean"] > 2 * rendered["spherecap"]["in place"]["mean"]


def test_decisions(rendered: dict) -> None:
    """The emitter sees smooth meshes, and into the groups of instances."""
    mesh, instance = rendered["decisions"]
    assert "hemispheres = front (auto)" in mesh
    assert "defensive = 0.125 (auto)" in mesh
    assert "hemispheres = both (auto)" in instance
    assert "defensive = 0 (auto)" in instance


def test_gradients(rendered: dict) -> None:
    """Brightness is proportional to radiance, which is 1: derivatives by its channels add up to it."""
    light = rendered["spherecap"]["in place"]
    error = light["error"] * math.sqrt(rendered["seeds"])  # of one render
    assert len(rendered["gradients"]) == ("_ad_" in rendered["variant"])
    for gradient in rendered["gradients"]:
        assert sum(gradient) == pytest.approx(light["mean"], abs=4 * error)


@pytest.mark.parametrize("version", OLDER)
def test_dependency(version: str) -> None:
    """The installed package wants the Mitsuba that it was built for."""
    program = "import importlib.metadata as m; print(m.requires('spherecap'))"
    assert f"'mitsuba=={version}'" in run(PROGRAMS[version] / "python", "-c", program)[1]


def sentence(plugin: str, mitsuba: str) -> str:
    """How a plugin refuses a Mitsuba."""
    return f"The spherecap plugin was built for Mitsuba {plugin}, but this is Mitsuba {mitsuba}: install"


@pytest.mark.parametrize(("plugin", "mitsuba"), STRANGERS)
def test_refused_by_the_command(plugin: str, mitsuba: str, tmp_path: Path) -> None:
    """`mitsuba -a` says so and fails, by itself."""
    scene = tmp_path / "scene.xml"
    scene.write_text(SCENE)
    words = ("-m", "scalar_rgb", "-a", PLUGINS[plugin], "-o", tmp_path / "out.exr", scene)
    code, text = run(PROGRAMS[mitsuba] / "mitsuba", *words)
    assert sentence(plugin, mitsuba) in text
    assert code == 255  # what it returns after an exception; a signal gives 256 less its number


@pytest.mark.parametrize(("plugin", "mitsuba"), STRANGERS)
def test_refused_by_python(plugin: str, mitsuba: str, tmp_path: Path) -> None:
    """The import fails with the same sentence; and so does the emitter, without the import."""
    python = PROGRAMS[mitsuba] / "python"
    shutil.copytree(PLUGINS[plugin], tmp_path / "spherecap")  # where no other Mitsuba is beside it
    code, text = run(python, "-c", "import spherecap", path=tmp_path)
    assert code == 1
    assert f"ImportError: {sentence(plugin, mitsuba)}" in text

    program = f"""
import mitsuba as mi
mi.set_variant("scalar_rgb")
resolver = mi.file_resolver() if hasattr(mi, "file_resolver") else mi.Thread.thread().file_resolver()
resolver.append({str(PLUGINS[plugin])!r})
mi.load_dict({{"type": "sphere", "emitter": {{"type": "spherecap"}}}})
"""
    code, text = run(python, "-c", program)
    assert code == 1
    assert "RuntimeError: " in text
    assert sentence(plugin, mitsuba) in text


def test_no_build_for_others(tmp_path: Path) -> None:
    """Another Mitsuba is refused before anything is compiled."""
    pip = (PROGRAMS[UNSUPPORTED] / "python", "-m", "pip", "wheel", "--no-build-isolation", "--no-deps")
    code, text = run(*pip, "--no-index", "--wheel-dir", tmp_path, REPOSITORY)
    assert code == 1
    flowed = re.sub(r"\s+", " ", text)
    assert f"can be built for one of Mitsuba {', '.join(PLUGINS)}, not for {UNSUPPORTED}: run" in flowed
