"""`import spherecap` makes the emitter known, in any order with `set_variant`, and copies nothing."""

import os
import shutil
import subprocess
import sys
from pathlib import Path

import mitsuba as mi
import pytest
import spherecap

VERSION = mi.__version__
PACKAGE = Path(spherecap.__file__).resolve().parent
SPHERE = "{'type': 'sphere', 'emitter': {'type': 'spherecap'}}"
SCENE = """<scene version="3.0.0">
    <integrator type="direct"/>
    <sensor type="perspective">
        <film type="hdrfilm"><integer name="width" value="8"/><integer name="height" value="8"/></film>
    </sensor>
    <shape type="sphere">
        <point name="center" x="0" y="0" z="4"/>
        <emitter type="spherecap">
            <rgb name="radiance" value="2.0"/>
            <string name="technique" value="projected_bounded"/>
            <string name="hemispheres" value="both"/>
            <float name="defensive" value="0.25"/>
        </emitter>
    </shape>
</scene>
"""


def python(program, *, path=PACKAGE.parent):
    """Runs a program in a fresh interpreter, in another folder."""
    environment = {**os.environ, "PYTHONPATH": str(path)}
    return subprocess.run(
        [sys.executable, "-c", program],
        env=environment,
        cwd="/",
        capture_output=True,
        text=True,
        timeout=120,
        check=False,
    )


ORDERS = {
    "import first": f"""
import spherecap, mitsuba as mi
mi.set_variant('scalar_rgb'); mi.load_dict({SPHERE})
mi.set_variant('scalar_spectral'); mi.load_dict({SPHERE})
""",
    "variant first": f"""
import mitsuba as mi
mi.set_variant('scalar_rgb')
import spherecap
mi.load_dict({SPHERE})
mi.set_variant('scalar_spectral_polarized'); mi.load_dict({SPHERE})
""",
    "another thread": f"""
import threading, mitsuba as mi, spherecap
mi.set_variant('scalar_rgb')
loaded = []
def load():
    mi.set_variant('scalar_rgb')
    loaded.append(mi.load_dict({SPHERE}))
thread = threading.Thread(target=load)
thread.start(); thread.join()
assert loaded
""",
    "imported by another thread": f"""
import threading, mitsuba as mi
def load():
    import spherecap
thread = threading.Thread(target=load)
thread.start(); thread.join()
mi.set_variant('scalar_rgb'); mi.load_dict({SPHERE})
""",
    "another file resolver": f"""
import mitsuba as mi, spherecap
mi.set_variant('scalar_rgb')
old = list(mi.file_resolver())
new = mi.FileResolver()
for folder in old[:-1]:
    new.append(folder)
mi.set_file_resolver(new)
spherecap.register(); spherecap.register()
assert len(mi.file_resolver()) == len(old) + 1, mi.file_resolver()
mi.load_dict({SPHERE})
""",
}


@pytest.mark.parametrize("order", ORDERS)
def test_import(order):
    """The plugin is found whichever comes first."""
    done = python(ORDERS[order])
    assert done.returncode == 0, done.stderr


def test_import_twice():
    """The search path has the folder once."""
    program = (
        "import importlib, mitsuba as mi, spherecap; importlib.reload(spherecap)\nprint(*mi.file_resolver())"
    )
    assert python(program).stdout.split().count(str(PACKAGE)) == 1


def test_xml(variant, tmp_path):
    """Parameters in XML arrive."""
    file = tmp_path / "scene.xml"
    file.write_text(SCENE)
    scene = mi.load_file(str(file))
    text = str(scene.emitters()[0])
    for line in ("technique = projected_bounded", "hemispheres = both,", "defensive = 0.25,"):
        assert line in text


def command(folder, tmp_path):
    """Renders the scene with the `mitsuba` command, which takes a plugin's folder by its option `-a`."""
    (tmp_path / "scene.xml").write_text(SCENE)
    mitsuba = [sys.executable, "-m", "mitsuba.python.cli"]
    words = [*mitsuba, "-m", "scalar_rgb", "-a", str(folder), "-o", "out.exr", "scene.xml"]
    done = subprocess.run(words, cwd=tmp_path, capture_output=True, text=True, timeout=120, check=False)
    return done.returncode, done.stdout + done.stderr


def test_command(tmp_path):
    """The command finds the plugin."""
    code, text = command(PACKAGE, tmp_path)
    assert code == 0, text
    assert (tmp_path / "out.exr").exists()


def test_not_built(tmp_path):
    """Without the plugin the import fails, and says what to run."""
    (tmp_path / "spherecap").mkdir()
    shutil.copy(PACKAGE / "__init__.py", tmp_path / "spherecap")
    done = python("import spherecap", path=tmp_path)
    message = done.stderr.splitlines()[-1]
    assert message.startswith("ImportError: The spherecap plugin is not built")
    assert message.endswith("run 'make build'.")


def test_another_mitsuba_at_import():
    """Mitsuba checks no version, so we do."""
    done = python("import mitsuba; mitsuba.__version__ = '3.8.0'\nimport spherecap")
    message = done.stderr.splitlines()[-1]
    assert message.startswith(
        f"ImportError: The spherecap plugin was built for Mitsuba {VERSION}, but this is Mitsuba 3.8.0: "
    )
    assert message.endswith(
        f"install mitsuba=={VERSION}; or, where one of Mitsuba {VERSION}, 3.8.0, 3.7.1 is installed, "
        "spherecap again, by `pip install --no-build-isolation .` in its repository."
    )


@pytest.fixture(scope="module")
def foreign(tmp_path_factory):
    """The folder of a plugin that was built for another Mitsuba; its emitter is not even a library."""
    folder = tmp_path_factory.mktemp("foreign")
    (folder / "plugins").mkdir()
    (folder / "plugins/spherecap_emitter.so").touch()
    definitions = ('-DMITSUBA_WHEEL_VERSION="1.2.3"', '-DSPHERECAP_MITSUBAS="1.2.3, 4.5.6"')
    files = (PACKAGE.parent / "guard.cpp", "-o", folder / "plugins/spherecap.so")
    compiler = os.environ.get("CXX", "c++")
    subprocess.run([compiler, "-std=c++17", "-shared", "-fPIC", *definitions, *files, "-ldl"], check=True)
    return folder


def test_built_for_another_mitsuba_by_the_command(foreign, tmp_path):
    """The `mitsuba` command imports nothing, so the plugin itself refuses."""
    code, text = command(foreign, tmp_path)
    assert code == 255  # Mitsuba's own after an exception; a signal gives another
    assert (
        f"The spherecap plugin was built for Mitsuba 1.2.3, but this is Mitsuba {VERSION}: install "
        "mitsuba==1.2.3; or, where one of Mitsuba 1.2.3, 4.5.6 is installed, spherecap again" in text
    )


def test_built_for_another_mitsuba_by_python(foreign):
    """As an exception, again and again."""
    program = f"""
import mitsuba as mi
mi.set_variant('scalar_rgb')
mi.file_resolver().append({str(foreign)!r})
for _ in range(2):
    try:
        mi.load_dict({SPHERE})
    except RuntimeError as error:
        print(error)
"""
    done = python(program)
    assert done.returncode == 0, done.stderr
    sentence = f"The spherecap plugin was built for Mitsuba 1.2.3, but this is Mitsuba {VERSION}: install "
    assert done.stdout.count(sentence) == 2


def test_no_emitter_beside_the_plugin(tmp_path):
    """A file of the two was lost."""
    (tmp_path / "plugins").mkdir()
    shutil.copy(spherecap.PLUGIN, tmp_path / "plugins")
    code, text = command(tmp_path, tmp_path)
    assert code == 255
    assert "The spherecap emitter cannot be loaded, build it again: " in text
    assert "plugins/spherecap_emitter.so" in text
