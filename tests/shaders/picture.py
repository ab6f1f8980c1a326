"""The example examples/direct_light.comp as docs/source.png: `python picture.py FILE` writes it."""

import pathlib
import struct
import sys
import tempfile
import zlib

import numpy as np
from devices import Vulkan, compiled

ROOT = pathlib.Path(__file__).parents[2]
WIDTH, HEIGHT = 480, 270


def rendered(device, folder):
    """Give the picture as bytes, in sRGB."""
    source = (ROOT / "examples/direct_light.comp").read_text()
    spirv = compiled(source, [f"-I{ROOT / 'shaders'}"], folder, "direct_light")
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
        pathlib.Path(sys.argv[1]).write_bytes(png(rendered(Vulkan(), pathlib.Path(folder))))
