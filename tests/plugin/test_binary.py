"""The plugin as a file: small, closed, and without traces of the machine that built it."""

import re
import subprocess
from pathlib import Path

import pytest
import spherecap

EMITTER = spherecap.PLUGIN.with_name("spherecap_emitter.so")
REPOSITORY = Path(__file__).resolve().parents[2]


def tool(*command):
    """Runs a tool of the compiler's."""
    return subprocess.run(command, capture_output=True, text=True, check=True).stdout


@pytest.mark.parametrize(
    ("file", "names"),
    [(spherecap.PLUGIN, {"init_plugin", "plugin_name", "plugin_descr"}), (EMITTER, {"init_plugin"})],
)
def test_exports(file, names):
    """Only what Mitsuba calls (the last two before 3.7): else it could clash with another plugin's."""
    lines = tool("nm", "--dynamic", "--defined-only", str(file)).splitlines()
    assert {line.split()[-1] for line in lines} == names


@pytest.mark.parametrize(
    ("file", "mitsuba"),
    [(spherecap.PLUGIN, set()), (EMITTER, {"libmitsuba.so", "libdrjit-core.so", "libdrjit-extra.so"})],
)
def test_needs_only_mitsuba_and_the_system(file, mitsuba):
    """Libraries are found by name, not by a path; and what any Mitsuba loads needs nothing of Mitsuba's."""
    dynamic = tool("readelf", "--dynamic", "--wide", str(file))
    needed = set(re.findall(r"NEEDED.*\[(.*)\]", dynamic))
    system = {
        "libc.so.6",
        "libdl.so.2",
        "libm.so.6",
        "libstdc++.so.6",
        "libgcc_s.so.1",
        "ld-linux-x86-64.so.2",
    }
    assert mitsuba <= needed <= mitsuba | system
    assert "RPATH" not in dynamic
    assert "RUNPATH" not in dynamic


def test_size():
    """Below 1.5 MiB, most of it the 13 variants."""
    size = EMITTER.stat().st_size
    print(f"{size / 1024:.0f} KiB")
    assert size < 3 << 19


@pytest.mark.parametrize("file", [spherecap.PLUGIN, EMITTER])
def test_no_paths_of_this_machine(file):
    """A plugin may be handed on."""
    content = file.read_bytes()
    assert str(REPOSITORY).encode() not in content
    assert str(Path.home()).encode() + b"/" not in content
