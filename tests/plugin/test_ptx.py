"""What NVIDIA's assembler makes of the kernels that Dr.Jit records for CUDA. It needs no GPU."""

import os
import re
import struct
import subprocess
import sys
import sysconfig
from pathlib import Path

import pytest

REPOSITORY = Path(__file__).resolve().parents[2]
PTXAS = Path(sysconfig.get_path("purelib"), "nvidia/cuda_nvcc/bin/ptxas")
RECORD = Path(__file__).with_name("record_ptx.py")


@pytest.fixture(scope="module")
def recorded(tmp_path_factory):
    """The PTX of each kernel, for the oldest GPUs that Dr.Jit supports."""
    folder = tmp_path_factory.mktemp("ptx")
    given = {
        "PYTHON": sys.executable,
        "PYTHONPATH": str(REPOSITORY / "mitsuba_plugin"),
        "DRJIT_CACHE_DIR": str(folder / "cache"),
        "STUB_CAPABILITY": "75",
    }
    command = [REPOSITORY / "tools/cuda/emulator/run", sys.executable, RECORD, folder]
    subprocess.run(list(map(str, command)), env={**os.environ, **given}, check=True)
    return sorted(folder.glob("*.ptx"))


def assemble(ptx, architecture):
    """Registers and instructions; fails where registers do not suffice."""
    cubin = ptx.with_suffix(".cubin")
    command = [PTXAS, "-v", f"-arch={architecture}", "-o", cubin, ptx]
    done = subprocess.run(list(map(str, command)), capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stdout + done.stderr
    # Functions that are called have a frame of their own: here is none.
    frames = re.findall(r"(\d+) bytes stack frame, (\d+) bytes spill stores", done.stderr)
    assert frames == [("0", "0")], done.stderr
    return int(re.search(r"Used (\d+) registers", done.stderr)[1]), instructions(cubin.read_bytes())


def instructions(elf):
    """How many instructions of 16 bytes an object file has: as long as its sections of code are."""
    (start,) = struct.unpack_from("<Q", elf, 40)
    size, count = struct.unpack_from("<HH", elf, 58)
    sections = [struct.unpack_from("<IIQQQQ", elf, start + i * size) for i in range(count)]
    return sum(length for _, _, flags, _, _, length in sections if flags & 4) // 16


@pytest.mark.parametrize("architecture", ["sm_75", "sm_90"])
def test_kernels_assemble(recorded, architecture):
    """All of them, without spilling registers into memory."""
    found = {ptx.stem: assemble(ptx, architecture) for ptx in recorded}
    print(f"\n{architecture}: registers, instructions")
    for name, (registers, count) in found.items():
        print(f"{name:34}{registers:5}{count:6}")
    assert len(found) == 6
    # A budget: with 80 of 65,536 registers, 25 warps of 32 threads are on a multiprocessor.
    assert all(registers <= 80 for registers, _ in found.values())
