"""What a compute shader like examples/direct_light.comp renders, as a PNG: `python picture.py SHADER FILE`.

`make shader-picture` calls it; docs/source.png is the example's.
"""

import pathlib
import struct
import sys
import tempfile
import zlib

import numpy as np
from devices import Vulkan, compiled

ROOT = pathlib.Path(__file__).parents[2]
WIDTH, HEIGHT = 480, 270


def rendered(shader, device, folder):
    """Give the picture as bytes, in sRGB."""
    spirv = compiled(shader.read_text(), [f"-I{ROOT / 'shaders'}"], folder, "picture")
    unused = np.zeros((WIDTH * HEIGHT, 1), np.float32)
    linear = np.clip(device.run(spirv, unused, 3), 0, 1)
    srgb = np.where(linear <= 0.0031308, 12.92 * linear, 1.055 * linear ** (1 / 2.4) - 0.055)
    return np.round(255 * srgb).astype(np.uint8).reshape(HEIGHT, WIDTH, 3)


def png(pixels):
    """Give a PNG file of a picture."""

    def chunk(kind, data):
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))

    head = struct.pack(">IIBBBBB", pixels.shape[1], pixels.shape[0], 8, 2, 0, 0, 0)
    rows = b"".join(b"\0" + row.tobytes() for row in pixels)
    chunks = chunk(b"IHDR", head) + chunk(b"IDAT", zlib.compress(rows, 9)) + chunk(b"IEND", b"")
    return b"\x89PNG\r\n\x1a\n" + chunks


def pixels_of(file):
    """Give the picture of a file that `png` has made."""
    data = file.read_bytes()
    start = data.index(b"IDAT")
    size = struct.unpack(">I", data[start - 4 : start])[0]
    rows = np.frombuffer(zlib.decompress(data[start + 4 : start + 4 + size]), np.uint8)
    return rows.reshape(HEIGHT, 1 + 3 * WIDTH)[:, 1:].reshape(HEIGHT, WIDTH, 3)


if __name__ == "__main__":
    with tempfile.TemporaryDirectory() as folder:
        shader, file = map(pathlib.Path, sys.argv[1:])
        file.write_bytes(png(rendered(shader, Vulkan(), pathlib.Path(folder))))
