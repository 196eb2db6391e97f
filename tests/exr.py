# SPDX-License-Identifier: Apache-2.0
"""Reads OpenEXR files of scan lines, ZIP compressed, as "Technical Introduction to OpenEXR" and
"OpenEXR File Layout" have it; the standard library only."""

import struct
import zlib
from itertools import accumulate

_SIZES = {1: 2, 2: 4}  # half, float
_FORMATS = {1: "e", 2: "f"}
_LINES = {2: 1, 3: 16}  # of a block: ZIPS, ZIP


def _text(data, at):
    end = data.index(b"\0", at)
    return data[at:end].decode(), end + 1


def _attributes(data):
    at, attributes = 8, {}
    while data[at]:
        name, at = _text(data, at)
        _, at = _text(data, at)
        (size,) = struct.unpack_from("<i", data, at)
        attributes[name] = data[at + 4 : at + 4 + size]
        at += 4 + size
    return attributes, at + 1


def _channels(data):
    at, channels = 0, []
    while data[at]:
        name, at = _text(data, at)
        channels.append((name, struct.unpack_from("<i", data, at)[0]))
        at += 16
    return channels


def _unzip(data, size):
    if len(data) == size:
        return data
    changes = zlib.decompress(data)
    halves = bytes(accumulate(changes, lambda a, b: (a + b - 128) & 255))
    out, middle = bytearray(size), (size + 1) // 2
    out[0::2], out[1::2] = halves[:middle], halves[middle:]
    return bytes(out)


def read(path):
    """The width, the height, and a list of values for each channel by name, row by row."""
    data = path.read_bytes()
    if struct.unpack_from("<I", data)[0] != 20000630:
        raise ValueError(f"{path}: not OpenEXR")
    attributes, at = _attributes(data)
    x0, y0, x1, y1 = struct.unpack("<4i", attributes["dataWindow"])
    width, height = x1 - x0 + 1, y1 - y0 + 1
    channels = _channels(attributes["channels"])
    lines = _LINES[attributes["compression"][0]]
    row = width * sum(_SIZES[kind] for _, kind in channels)
    values = {name: [] for name, _ in channels}
    for (place,) in struct.iter_unpack("<Q", data[at : at + 8 * -(-height // lines)]):
        y, size = struct.unpack_from("<2i", data, place)
        count = min(lines, height - (y - y0))
        block, here = _unzip(data[place + 8 : place + 8 + size], row * count), 0
        for _ in range(count):
            for name, kind in channels:
                values[name] += struct.unpack_from(f"<{width}{_FORMATS[kind]}", block, here)
                here += width * _SIZES[kind]
    return width, height, values
