"""The plugin as a file: small, closed, and without traces of the machine that built it."""

import re
import subprocess
from pathlib import Path

import spherecap

REPOSITORY = Path(__file__).resolve().parents[2]


def tool(*command):
    """Runs a tool of the compiler's."""
    return subprocess.run(command, capture_output=True, text=True, check=True).stdout


def test_exports():
    """Mitsuba calls one function; any other export could clash with another plugin's."""
    lines = tool("nm", "--dynamic", "--defined-only", str(spherecap.PLUGIN)).splitlines()
    assert [line.split()[-1] for line in lines] == ["init_plugin"]


def test_needs_only_mitsuba_and_the_system():
    """Libraries are found by name, not by a path."""
    dynamic = tool("readelf", "--dynamic", "--wide", str(spherecap.PLUGIN))
    needed = set(re.findall(r"NEEDED.*\[(.*)\]", dynamic))
    mitsuba = {"libmitsuba.so", "libdrjit-core.so", "libdrjit-extra.so"}
    system = {"libc.so.6", "libm.so.6", "libstdc++.so.6", "libgcc_s.so.1", "ld-linux-x86-64.so.2"}
    assert mitsuba <= needed <= mitsuba | system
    assert "RPATH" not in dynamic
    assert "RUNPATH" not in dynamic


def test_size():
    """Below 1 MiB, most of it the 13 variants."""
    size = spherecap.PLUGIN.stat().st_size
    print(f"{size / 1024:.0f} KiB")
    assert size < 1 << 20


def test_no_paths_of_this_machine():
    """A plugin may be handed on."""
    content = spherecap.PLUGIN.read_bytes()
    assert str(REPOSITORY).encode() not in content
    assert str(Path.home()).encode() + b"/" not in content
