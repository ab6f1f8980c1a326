"""A build that cannot succeed says what to install or run."""

import os
import re
import subprocess
import sys
from pathlib import Path

import mitsuba as mi
import pytest

PLUGIN = Path(__file__).resolve().parents[2] / "mitsuba_plugin"
TOOLS = Path(sys.executable).parent  # cmake and ninja are in the same environment


def configure(tmp_path, **variables):
    """What CMake prints on one line, for a new build folder."""
    command = ["cmake", "-S", str(PLUGIN), "-B", str(tmp_path / "build"), "-G", "Ninja"]
    variables = {"MitsubaWheel_PYTHON": sys.executable, **variables}
    command += [f"-D{name}={value}" for name, value in variables.items()]
    environment = {**os.environ, "PATH": f"{TOOLS}{os.pathsep}{os.environ['PATH']}"}
    done = subprocess.run(command, env=environment, capture_output=True, text=True, timeout=300, check=False)
    return done.returncode, re.sub(r"\s+", " ", done.stdout + done.stderr)


def test_all_there(tmp_path):
    """The module finds the wheel that this test runs with."""
    library = tmp_path / "libspherecap.a"
    library.touch()
    code, text = configure(tmp_path, SPHERECAP_LIBRARY=library)
    assert code == 0, text
    assert f'found suitable exact version "{mi.__version__}"' in text


def test_no_library(tmp_path):
    """A library that is named must be there."""
    code, text = configure(tmp_path, SPHERECAP_LIBRARY=tmp_path / "nothing.a")
    assert code != 0
    assert "nothing.a': set SPHERECAP_LIBRARY to a libspherecap.a, or leave it empty" in text


@pytest.mark.parametrize(
    ("variables", "message"),
    [
        (
            {"MitsubaWheel_NANOBIND_VERSION": "9.9.9"},
            "needs the headers of nanobind 9.9.9.*pip install nanobind==9.9.9",
        ),
        (
            {"CMAKE_SYSTEM_NAME": "Linux", "CMAKE_SYSTEM_PROCESSOR": "aarch64"},
            "Only Linux on x86-64 is supported, not Linux on aarch64",
        ),
    ],
)
def test_unsuitable(tmp_path, variables, message):
    """Another nanobind, another system."""
    library = tmp_path / "libspherecap.a"
    library.touch()
    code, text = configure(tmp_path, SPHERECAP_LIBRARY=library, **variables)
    assert code != 0
    assert re.search(message, text), text


def test_another_mitsuba(tmp_path):
    """A Mitsuba that nobody has tried: which ones there are, and how to get one."""
    library = tmp_path / "libspherecap.a"
    library.touch()
    other = tmp_path / "python"
    other.write_text('#!/bin/sh\nprintf "3.6.4;/nowhere"\n')
    other.chmod(0o755)
    code, text = configure(tmp_path, SPHERECAP_LIBRARY=library, MitsubaWheel_PYTHON=other)
    assert code != 0
    assert re.search(
        rf"can be built for one of Mitsuba {mi.__version__}, [\d., ]+, not for 3\.6\.4: "
        rf"run .*/python -m pip install mitsuba=={mi.__version__}'",
        text,
    ), text


def test_no_mitsuba(tmp_path):
    """An interpreter whose environment lacks the wheel."""
    library = tmp_path / "libspherecap.a"
    library.touch()
    bare = tmp_path / "python"
    bare.write_text(f'#!/bin/sh\nexec "{sys.executable}" -S "$@"\n')
    bare.chmod(0o755)
    code, text = configure(tmp_path, SPHERECAP_LIBRARY=library, MitsubaWheel_PYTHON=bare)
    assert code != 0
    assert re.search(rf"has no mitsuba package: run .* -m pip install mitsuba=={mi.__version__}", text), text
