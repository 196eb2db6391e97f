# SPDX-License-Identifier: Apache-2.0
"""Scenes made to break a reader. Each is refused with file, line and column, or accepted, within
2 seconds and 512 MiB."""

import random
import struct
import unittest
import zlib

from program import SCENE, ProgramTest

REFUSED = {
    "cut inside an object": "sphere { 0,",
    "cut inside a string": '#declare A = "abc',
    "comment without end": "/* and so on",
    "one brace too many": "sphere { 0, 1 } }",
    "missing brace": "union { sphere { 0, 1 }",
    "unknown word": "sphere { 0, 1 frobnicate }",
    "string for a vector": 'sphere { "a", 1 }',
    "vector for a number": "sphere { 0, <1, 2, 3> }",
    "missing argument": "sphere { 0 }",
    "unknown name in an expression": "#declare A = B + 1;",
    "#end without #if": "#end",
    "version 99": "#version 99.0;",
    "square root of -1": "#declare A = sqrt(-1);",
    "logarithm of 0": "#declare A = ln(0);",
    "mod by 0": "#declare A = mod(1, 0);",
    "mesh2 index out of range":
        "mesh2 { vertex_vectors { 3, 0, x, y } face_indices { 1, <0, 1, 7> } }",
    "cylinder without length": "cylinder { 0, 0, 1 }",
    "plane without normal": "plane { 0, 1 }",
    "poly of order 36": "poly { 36, <1, 2, 3> }",
    "#for with step 0": "#for (I, 0, 1, 0) #end",
    "macro that calls itself": "#macro M() M() #end M()",
    "file that includes itself": '#include "a.pov"',
    "array of 10^9": "#declare A = array[1000000000];",
    "array of -5": "#declare A = array[-5];",
    "index out of range": "#declare A = array[2] { 1, 2 }; #declare B = A[7];",
    "string of 2^40": '#declare A = "a"; #for (I, 1, 40) #declare A = concat(A, A); #end',
    "str of 10^9 characters": "#declare A = str(1, 1000000000, 0);",
    "substr out of range": '#declare A = substr("abc", 10, 5);',
    "10^6 unions deep": "union { " * 10**6,
    "10^6 parentheses deep": "#declare A = " + "(" * 10**6,
    "missing picture": 'sphere { 0, 1 pigment { image_map { png "none.png" } } }',
    "missing include": '#include "none.inc"',
    "reading the password file": '#include "/etc/passwd"',
    "opening the password file": '#fopen F "/etc/passwd" read',
    "writing beside the folder": '#fopen F "../other.txt" write',
    "writing by a roundabout path": '#fopen F "/tmp/../var/tmp/x" write',
    "picture that is the password file":
        'sphere { 0, 1 pigment { image_map { ppm "/etc/passwd" } } }',
}

ENDLESS = {
    "loop without end": "#while (1) #end",
    "10^9 times nothing": "#for (I, 1, 1000000000) #end",
    "10^9 spheres": "#for (I, 1, 1000000000) sphere { 0, 1 } #end",
}

ACCEPTED = {
    "nothing": b"",
    "a comment": b"// nothing\n",
    "CRLF": SCENE.replace("\n", "\r\n").encode(),
    "byte order mark": b"\xef\xbb\xbf" + SCENE.encode(),
    "10^5 words in a line": (SCENE + "#declare A = 0" + " + 1" * 50000 + ";").encode(),
    "division by zero": (SCENE + "#declare A = 1/0;").encode(),
    "ball of radius 0": (SCENE + "sphere { 0, 0 }").encode(),
    "box without volume": (SCENE + "box { 0, <1, 0, 1> }").encode(),
    "flat triangle": (SCENE + "triangle { 0, x, 2*x }").encode(),
    "scale 0": (SCENE + "sphere { 0, 1 scale 0 }").encode(),
    "singular matrix": (SCENE + "sphere { 0, 1 matrix <0,0,0,0,0,0,0,0,0,0,0,0> }").encode(),
    "ior 0": (SCENE + "sphere { 0, 1 pigment { rgbf 1 } interior { ior 0 } }").encode(),
    "unions 1000 deep": (SCENE + "union { " * 1000 + "sphere { 0, 1 }" + " }" * 1000).encode(),
    "endless mirrors": (SCENE + "global_settings { max_trace_level 1000000000 } "
                        "plane { z, 3 finish { reflection 1 } } "
                        "plane { -z, 9 finish { reflection 1 } }").encode(),
}


def png(width, height, data):
    def chunk(kind, body):
        return struct.pack(">I", len(body)) + kind + body + struct.pack(">I",
                                                                      zlib.crc32(kind + body))

    head = chunk(b"IHDR", struct.pack(">IIBBBBB", width, height, 8, 2, 0, 0, 0))
    return b"\x89PNG\r\n\x1a\n" + head + chunk(b"IDAT", zlib.compress(data)) + chunk(b"IEND", b"")


PICTURES = {
    "png of 0 x 0": ("png", png(0, 0, b"")),
    "png that says 100000 x 100000": ("png", png(100000, 100000, bytes(300))),
    "png cut in half": ("png", png(8, 8, bytes(25 * 8))[:50]),
    "empty png": ("png", b""),
    "text as png": ("png", b"hello, world\n"),
    "ppm of negative size": ("ppm", b"P6 -5 1000000000 255\n"),
    "hdr cut": ("hdr", b"#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 64 +X 64\n\x02\x02\x00\x40\xff"),
    "exr with garbage": ("exr", b"\x76\x2f\x31\x01" + bytes(range(256))),
    "tiff whose directory is a loop": ("tiff", b"II*\0\x08\0\0\0" + bytes(6) + b"\x08\0\0\0"),
    "tga with the largest fields": ("tga", b"\xff" * 18),
    "gif cut": ("gif", b"GIF89a\x10\0\x10\0\x80\0\0"),
}


class HostileLanguage(ProgramTest):
    def attempt(self, content, *options):
        self.write("a.pov", content)
        return self.dioptre("+Ia.pov", "+Oa.ppm", "+W32", "+H24", "+FP", "-D", "--progress=none",
                            *options, cpu_seconds=30)

    def assert_modest(self, outcome, seconds=2):
        self.assertGreaterEqual(outcome.status, 0, f"ended by a signal: {outcome.output[-500:]}")
        self.assertLess(outcome.cpu_seconds, seconds)
        self.assertLess(outcome.peak_bytes, 512 << 20)

    def assert_refused(self, outcome):
        self.assert_modest(outcome)
        self.assertEqual(outcome.status, 1, outcome.output[-500:])
        self.assertRegex(outcome.output, r"a\.pov:\d+:\d+: error: ")
        self.assertNotIn("root:", outcome.output)

    def test_broken_scenes_are_refused_with_their_place(self):
        for name, text in REFUSED.items():
            with self.subTest(case=name):
                self.assert_refused(self.attempt(SCENE + text))

    def test_scenes_without_end_are_stopped_by_their_budget(self):
        for name, text in ENDLESS.items():
            with self.subTest(case=name):
                self.assert_refused(self.attempt(SCENE + text, "--max-steps", "3000000"))

    def test_odd_scenes_are_accepted(self):
        for name, content in ACCEPTED.items():
            with self.subTest(case=name):
                outcome = self.attempt(content)
                self.assert_modest(outcome)
                self.assertEqual(outcome.status, 0, outcome.output[-500:])

    def test_random_bytes_are_refused(self):
        self.assert_refused(self.attempt(random.Random(7).randbytes(1 << 20)))

    def test_two_files_that_include_each_other_are_refused(self):
        self.write("b.inc", '#include "a.pov"\n')
        outcome = self.attempt('#include "b.inc"\n')
        self.assert_modest(outcome)
        self.assertEqual(outcome.status, 1)

    def test_broken_pictures_are_refused(self):
        for name, (kind, data) in PICTURES.items():
            with self.subTest(case=name):
                self.write(f"p.{kind}", data)
                self.assert_refused(self.attempt(
                    SCENE + f'plane {{ y, -1 pigment {{ image_map {{ {kind} "p.{kind}" }} }} }}'))

    def test_a_font_that_is_none_is_refused(self):
        self.write("f.ttf", "this is no font\n" * 100)
        self.assert_refused(self.attempt(SCENE + 'text { ttf "f.ttf" "A" 1, 0 }'))


if __name__ == "__main__":
    unittest.main()
