# SPDX-License-Identifier: Apache-2.0
"""Pictures and fonts of every format, whole, cut and damaged; files that are none; full disks. The
program renders or refuses, within 2 seconds and 512 MiB, and names the place in the scene."""

import os
import random
import struct
import unittest
import zlib
from pathlib import Path

from program import SCENE, ProgramTest

FONT = Path("/usr/share/povray-3.7/include/timrom.ttf")
DAMAGES = 24


def png(width, height, data):
    def chunk(kind, body):
        return struct.pack(">I", len(body)) + kind + body + struct.pack(">I",
                                                                      zlib.crc32(kind + body))

    head = chunk(b"IHDR", struct.pack(">IIBBBBB", width, height, 8, 2, 0, 0, 0))
    return b"\x89PNG\r\n\x1a\n" + head + chunk(b"IDAT", zlib.compress(data)) + chunk(b"IEND", b"")


def gif():
    """2 x 2 pixels of 4 colours."""
    head = b"GIF89a" + struct.pack("<HHBBB", 2, 2, 0x81, 0, 0) + bytes(range(12))
    return head + b"," + struct.pack("<HHHHB", 0, 0, 2, 2, 0) + b"\x02\x03\x44\x34\x05\x00;"


def tiff(width=4, height=4, strip_size=48):
    entries = [(256, 4, width), (257, 4, height), (258, 3, 8), (259, 3, 1), (262, 3, 2),
               (273, 4, 200), (277, 3, 3), (278, 4, height), (279, 4, strip_size)]
    out = b"II*\0" + struct.pack("<IH", 8, len(entries))
    for tag, kind, value in entries:
        out += struct.pack("<HHII", tag, kind, 1, value)
    return (out + bytes(4)).ljust(200, b"\0") + bytes(range(48))


REFUSED = {
    "png of 0 x 0": ("png", png(0, 0, b"")),
    "png that says 100000 x 100000": ("png", png(100000, 100000, bytes(300))),
    "png with a wrong sum": ("png", png(8, 8, bytes(25 * 8))[:50] + b"\xff\xff" +
                             png(8, 8, bytes(25 * 8))[52:]),
    "empty png": ("png", b""),
    "text as png": ("png", b"hello, world\n"),
    "ppm of negative size": ("ppm", b"P6 -5 1000000000 255\n"),
    "ppm of huge size": ("ppm", b"P6 1000000000 1000000000 255\n"),
    "ppm without an end of its numbers": ("ppm", b"P6 " + b"9" * 100000),
    "pgm cut": ("pgm", b"P5 100 100 255\n1234"),
    "hdr cut": ("hdr", b"#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 64 +X 64\n\x02\x02\x00\x40\xff"),
    "hdr of negative size": ("hdr", b"#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y -5 +X 1000000000\n"),
    "hdr without pixels":
        ("hdr", b"#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 1000 +X 1000\n"),
    "exr with garbage": ("exr", b"\x76\x2f\x31\x01" + bytes(range(256))),
    "tiff whose directory is a loop": ("tiff", b"II*\0\x08\0\0\0" + bytes(6) + b"\x08\0\0\0"),
    "tiff of huge size": ("tiff", tiff(width=1000000, height=1000000)),
    "tiff with a huge strip": ("tiff", tiff(height=1 << 20, strip_size=0xffffffff)),
    "tga with the largest fields": ("tga", b"\xff" * 18),
    "tga of 65535 x 65535, compressed and cut":
        ("tga", struct.pack("<BBBHHBHHHHBB", 0, 0, 10, 0, 0, 0, 0, 0, 65535, 65535, 24, 0) + b"\xff"),
    "gif cut": ("gif", b"GIF89a\x10\0\x10\0\x80\0\0"),
    "gif with impossible codes": ("gif", gif()[:-8] + b"\x02\x06\xff\xff\xff\xff\xff\xff\x00;"),
    "jpeg cut": ("jpeg", b"\xff\xd8\xff\xe0\0\x10JFIF\0"),
    "bmp cut": ("sys", b"BM" + b"\xff" * 40),
}


class HostileFiles(ProgramTest):
    def attempt(self, content, *options):
        self.write("a.pov", content)
        return self.dioptre("+Ia.pov", "+Oa.ppm", "+W16", "+H12", "+FP", "-D", "--progress=none",
                            *options, cpu_seconds=10)

    def with_picture(self, kind):
        return self.attempt(
            SCENE + f'plane {{ y, -1 pigment {{ image_map {{ {kind} "p.{kind}" }} }} }}')

    def with_font(self):
        return self.attempt(SCENE + 'text { ttf "f.ttf" "Ag" 1, 0 }')

    def assert_modest(self, outcome):
        self.assertGreaterEqual(outcome.status, 0, f"ended by a signal: {outcome.output[-500:]}")
        self.assertLess(outcome.cpu_seconds, 2)
        self.assertLess(outcome.peak_bytes, 512 << 20)

    def assert_refused(self, outcome):
        self.assert_modest(outcome)
        self.assertEqual(outcome.status, 1, outcome.output[-500:])
        self.assertRegex(outcome.output, r"a\.pov:\d+:\d+: error: ")
        self.assertEqual(outcome.output.count("error: "), 1, outcome.output[-500:])

    def assert_handled(self, outcome):
        """Rendered, or refused with its place."""
        if outcome.status == 0:
            self.assert_modest(outcome)
        else:
            self.assert_refused(outcome)

    def whole_pictures(self):
        """One whole file of each format: those the program writes, and the others by hand."""
        self.write("a.pov", SCENE)
        pictures = {"gif": gif(), "tiff": tiff(), "pgm": b"P5 2 2 255\n\0\x40\x80\xff"}
        for kind, letter, end in (("png", "N", "png"), ("jpeg", "J", "jpg"), ("tga", "T", "tga"),
                                  ("ppm", "P", "ppm"), ("exr", "E", "exr"), ("hdr", "H", "hdr"),
                                  ("sys", "B", "bmp")):
            outcome = self.dioptre("+Ia.pov", f"+Op.{end}", f"+F{letter}", "+W16", "+H12", "-D")
            self.assertEqual(outcome.status, 0, outcome.output)
            pictures[kind] = (self.folder / f"p.{end}").read_bytes()
        return pictures

    def damaged(self, data, seed):
        """The file cut at several places, and with some bytes changed."""
        chance = random.Random(seed)
        for share in (0.02, 0.1, 0.5, 0.9, 0.99):
            yield data[:int(share * len(data))]
        for _ in range(DAMAGES):
            changed = bytearray(data)
            for _ in range(chance.choice((1, 1, 4, 32))):
                changed[chance.randrange(min(len(data), chance.choice((64, 1 << 30))))] = \
                    chance.choice((0, 1, 0x7f, 0x80, 0xff, chance.randrange(256)))
            yield bytes(changed)

    def test_whole_pictures_are_read(self):
        for kind, data in self.whole_pictures().items():
            with self.subTest(format=kind):
                self.write(f"p.{kind}", data)
                outcome = self.with_picture(kind)
                self.assert_modest(outcome)
                self.assertEqual(outcome.status, 0, outcome.output)

    def test_damaged_pictures_do_no_harm(self):
        for kind, data in self.whole_pictures().items():
            for index, broken in enumerate(self.damaged(data, kind)):
                with self.subTest(format=kind, damage=index):
                    self.write(f"p.{kind}", broken)
                    self.assert_handled(self.with_picture(kind))

    def test_impossible_pictures_are_refused(self):
        for name, (kind, data) in REFUSED.items():
            with self.subTest(case=name):
                self.write(f"p.{kind}", data)
                self.assert_refused(self.with_picture(kind))

    def test_damaged_fonts_do_no_harm(self):
        for index, broken in enumerate(self.damaged(FONT.read_bytes(), "font")):
            with self.subTest(damage=index):
                self.write("f.ttf", broken)
                self.assert_handled(self.with_font())

    def test_fonts_that_are_none_are_refused(self):
        for name, data in (("text", b"this is no font\n" * 100), ("nothing", b""),
                           ("cut", FONT.read_bytes()[:2048])):
            with self.subTest(case=name):
                self.write("f.ttf", data)
                self.assert_refused(self.with_font())

    def test_folders_and_pipes_are_no_files(self):
        (self.folder / "thing").mkdir()
        os.mkfifo(self.folder / "pipe")
        for name in ("thing", "pipe"):
            for text in ('#include "{}"', '#fopen F "{}" read', '#fopen F "{}" write',
                         '#fopen F "{}" append', 'text {{ ttf "{}" "A" 1, 0 }}',
                         'sphere {{ 0, 1 pigment {{ image_map {{ png "{}" }} }} }}'):
                with self.subTest(name=name, use=text):
                    self.assert_refused(self.attempt(SCENE + text.format(name)))
            outcome = self.dioptre(f"+I{name}", "-D")
            self.assert_modest(outcome)
            self.assertEqual(outcome.status, 1)
            self.assertIn(name, outcome.output)

    def test_a_file_that_may_not_be_read_is_refused(self):
        path = self.write("secret.inc", "// secret")
        path.chmod(0)
        if os.geteuid() == 0:  # root may read it all the same
            self.assertEqual(self.attempt(SCENE + '#include "secret.inc"').status, 0)
        else:
            self.assert_refused(self.attempt(SCENE + '#include "secret.inc"'))

    def test_a_full_disk_is_an_error(self):
        self.write("a.pov", SCENE)
        for options in (("+O/dev/full",), ("+O/dev/full", "+FP"), ("+O/dev/full", "+FE")):
            with self.subTest(options=options):
                outcome = self.dioptre("+Ia.pov", "-D", "+W16", "+H12", *options)
                self.assertEqual(outcome.status, 1)
                self.assertIn("/dev/full", outcome.output)

    def test_a_device_is_written_in_place(self):
        self.write("a.pov", SCENE)
        outcome = self.dioptre("+Ia.pov", "+O/dev/null", "-D", "+W16", "+H12")
        self.assertEqual(outcome.status, 0, outcome.output)
        self.assertFalse(os.path.exists("/dev/null.png"))

    def test_nothing_is_written_outside_the_folders_of_the_scene(self):
        outside = self.folder.parent / f"{self.folder.name}-outside.txt"
        (self.folder / "link").symlink_to(outside)
        for name in ("link", f"../{outside.name}", str(outside)):
            with self.subTest(name=name):
                self.assert_refused(self.attempt(SCENE + f'#fopen F "{name}" write'))
                self.assertFalse(outside.exists())


if __name__ == "__main__":
    unittest.main()
