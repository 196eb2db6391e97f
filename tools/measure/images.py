# SPDX-License-Identifier: Apache-2.0
"""Images as plain bytes: read PPM, write PNG, compare; the standard library only."""

import struct
import zlib
from dataclasses import dataclass


@dataclass
class Image:
    """Rows of 8-bit red, green, blue from the top left."""

    width: int
    height: int
    rgb: bytes


def read_ppm(path):
    """Reads a binary PPM of 8 or 16 bits as 8 bits; raises ValueError for anything else."""
    with open(path, "rb") as file:
        data = file.read()
    if data[:2] != b"P6":
        raise ValueError(f"{path}: not a binary PPM")
    fields, position = [], 2
    while len(fields) < 3:
        while position < len(data) and data[position : position + 1].isspace():
            position += 1
        if data[position : position + 1] == b"#":
            position = data.index(b"\n", position)
            continue
        end = position
        while end < len(data) and data[end : end + 1].isdigit():
            end += 1
        if end == position:
            raise ValueError(f"{path}: broken PPM header")
        fields.append(int(data[position:end]))
        position = end
    width, height, largest = fields
    samples = width * height * 3
    body = data[position + 1 :]
    if largest == 255 and len(body) == samples:
        return Image(width, height, body)
    if largest == 65535 and len(body) == 2 * samples:
        wide = struct.unpack(f">{samples}H", body)
        return Image(width, height, bytes((value * 255 + 32767) // 65535 for value in wide))
    raise ValueError(f"{path}: {len(body)} bytes for {width}x{height} up to {largest}")


def write_png(path, image):
    """Writes an 8-bit RGB PNG."""

    def chunk(kind, data):
        checksum = zlib.crc32(kind + data)
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", checksum)

    stride = 3 * image.width
    rows = b"".join(
        b"\0" + image.rgb[y * stride : (y + 1) * stride] for y in range(image.height)
    )
    header = struct.pack(">IIBBBBB", image.width, image.height, 8, 2, 0, 0, 0)
    with open(path, "wb") as file:
        file.write(b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header))
        file.write(chunk(b"IDAT", zlib.compress(rows, 6)) + chunk(b"IEND", b""))


@dataclass
class Comparison:
    """How alike two images are, with 8-bit channels."""

    same_pixels: float  # share of pixels whose channels are all within the tolerance
    mean_difference: float  # over all channels, in 1/255
    largest_difference: int


def compare(first, second, tolerance=2):
    """Compares two images of one size; raises ValueError if the sizes differ."""
    if (first.width, first.height) != (second.width, second.height):
        raise ValueError(
            f"{first.width}x{first.height} against {second.width}x{second.height}"
        )
    differences = [abs(a - b) for a, b in zip(first.rgb, second.rgb)]
    largest_of_pixel = map(max, differences[0::3], differences[1::3], differences[2::3])
    same = sum(1 for value in largest_of_pixel if value <= tolerance)
    pixels = max(1, first.width * first.height)
    mean = sum(differences) / max(1, len(differences))
    return Comparison(same / pixels, mean, max(differences, default=0))


def same_blocks(first, second, size=8, tolerance=2):
    """The share of blocks of size x size pixels whose mean colours are within the tolerance."""
    same = blocks = 0
    for top in range(0, first.height, size):
        for left in range(0, first.width, size):
            sums, pixels = [0, 0, 0], 0
            for y in range(top, min(top + size, first.height)):
                begin = 3 * (y * first.width + left)
                end = 3 * (y * first.width + min(left + size, first.width))
                pixels += (end - begin) // 3
                for channel in range(3):
                    sums[channel] += (sum(first.rgb[begin + channel : end : 3])
                                      - sum(second.rgb[begin + channel : end : 3]))
            blocks += 1
            same += all(abs(total) <= tolerance * pixels for total in sums)
    return same / max(1, blocks)


def side_by_side(first, second, gain=4):
    """The two images and their difference, made `gain` times stronger, in one."""
    images = [first]
    if second is not None:
        images.append(second)
        if (first.width, first.height) == (second.width, second.height):
            difference = bytes(
                min(255, gain * abs(a - b)) for a, b in zip(first.rgb, second.rgb)
            )
            images.append(Image(first.width, first.height, difference))
    height = max(image.height for image in images)
    rows = []
    for y in range(height):
        for image in images:
            stride = 3 * image.width
            row = image.rgb[y * stride : (y + 1) * stride]
            rows.append(row if y < image.height else b"\0" * stride)
    return Image(sum(image.width for image in images), height, b"".join(rows))
