"""What sampling costs on a GPU that need not be there: Mesa's RADV compiles for AMD's Navi 21, and counts.

`make shader-cost` prints the table of docs/source.md.
"""

import os
import pathlib
import re
import subprocess
import sys
import tempfile

from devices import INSTALL, Vulkan, compiled
from mains import FOLDER, GLSL

HERE = pathlib.Path(__file__).parent
DRIVERS = pathlib.Path("/usr/share/vulkan/icd.d")
FUSED = "#define SPHERECAP_FUSED_FMA"
# What is counted: a name, a file, what its names begin with, and a line of the preprocessor.
SHADERS = [
    ("plain solid angle", HERE / "solid_angle.glsl", "solid_angle_", ""),
    ("the published method", HERE / "published.glsl", "published_", ""),
    ("`SPHERECAP_FUSED_FMA`", FOLDER / "spherecap.glsl", "spherecap_surface_", FUSED),
    ("without", FOLDER / "spherecap.glsl", "spherecap_surface_", ""),
]
COUNTED = ("Instructions", "VGPRs", "Latency")
ONCE = """
    uint i = 9u * gl_GlobalInvocationID.x, o = 4u * gl_GlobalInvocationID.x;
    vec3 normal = vec3(records[i], records[i + 1u], records[i + 2u]);
    vec3 centre = vec3(records[i + 3u], records[i + 4u], records[i + 5u]);
    {of} light = {prefix}sample_once(normal, centre, records[i + 6u], records[i + 7u], records[i + 8u]);
    results[o] = light.direction.x;
    results[o + 1u] = light.direction.y;
    results[o + 2u] = light.direction.z;
    results[o + 3u] = light.pdf;
"""


def once(file, prefix, define, folder):
    """Give the SPIR-V of a shader that takes one sample, and keeps its direction and density."""
    text = file.read_text()
    of = re.search(rf"^(\w+) {prefix}sample_once\(", text, re.MULTILINE).group(1)
    source = GLSL.format(file=text, define=define, body=ONCE.format(of=of, prefix=prefix))
    return compiled(source, [], folder, "once")


def costs():
    """Give instructions, registers and estimated latency of each shader.

    In a child each: RADV writes to its standard error.
    """
    drivers = sorted(DRIVERS.glob("radeon_icd*.json"))
    if not drivers:
        sys.exit(f"RADV is not there, which counts instructions: {INSTALL}")
    environment = os.environ | {
        "RADV_FORCE_FAMILY": "navi21",
        "RADV_DEBUG": "shaderstats,nocache",
        "VK_ICD_FILENAMES": str(drivers[0]),
    }
    found = {}
    with tempfile.TemporaryDirectory() as folder:
        for name, file, prefix, define in SHADERS:
            spirv = pathlib.Path(folder) / "counted.spv"
            spirv.write_bytes(once(file, prefix, define, pathlib.Path(folder)))
            done = subprocess.run(
                [sys.executable, __file__, str(spirv)],
                env=environment,
                capture_output=True,
                text=True,
                check=True,
            )
            found[name] = [int(re.search(rf"^{word}: (\d+)", done.stderr, re.M).group(1)) for word in COUNTED]
    return found


if __name__ == "__main__":
    if len(sys.argv) > 1:
        Vulkan().pipeline(pathlib.Path(sys.argv[1]).read_bytes())
    else:
        print("| GLSL | instructions | registers | latency |\n|---|---|---|---|")
        for name, numbers in costs().items():
            print(f"| {name} | {' | '.join(map(str, numbers))} |")
