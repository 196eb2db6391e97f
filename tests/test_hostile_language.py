# SPDX-License-Identifier: Apache-2.0
"""Scenes made to break a reader. Each is refused with file, line and column, or accepted, within
2 seconds and 512 MiB."""

import random
import unittest

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
    "mesh2 index out of range":
        "mesh2 { vertex_vectors { 3, 0, x, y } face_indices { 1, <0, 1, 7> } }",
    "cylinder without length": "cylinder { 0, 0, 1 }",
    "plane without normal": "plane { 0, 1 }",
    "poly of order 36": "poly { 36, <1, 2, 3> }",
    "mesh2 without faces": "mesh2 { vertex_vectors { 3, 0, x, y } }",
    "number beyond every range": "#declare A = 1e999;",
    "character -1": "#declare A = chr(-1);",
    "#for with step 0": "#for (I, 0, 1, 0) #end",
    "macro that calls itself": "#macro M() M() #end M()",
    "macros that call each other": "#macro M() N() #end #macro N() M() #end M()",
    "text of a million letters": '#declare A = "0123456789012345"; #for (I, 1, 18) '
                                 '#declare A = concat(A, A); #end text { ttf "timrom.ttf" A 1, 0 }',
    "array of 2^80": "#declare A = array[65536][65536][65536][65536][65536];",
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
    "loop whose condition stays": "#while (1) #declare A = 1; #end",
    "10^9 times nothing": "#for (I, 1, 1000000000) #end",
    "10^9 spheres": "#for (I, 1, 1000000000) sphere { 0, 1 } #end",
    "10^9 files": '#for (I, 1, 1000000000) #fopen F "f.txt" write #fclose F #end',
    "10^9 lines": '#fopen F "f.txt" write #for (I, 1, 1000000000) #write (F, I, "\\n") #end',
    "10^9 pictures": "#for (I, 1, 1000000000) "
                     "#declare P = pigment { image_map { function 2, 2 { x } } } #end",
    "10^9 messages": '#for (I, 1, 1000000000) #debug "" #end',
    "10^9 questions": "#declare B = sphere { 0, 1 } "
                      "#for (I, 1, 1000000000) #declare P = trace(B, -z*5, z); #end",
    "10^9 points of a prism": "prism { 0, 1, 1000000000 #for (I, 1, 1000000000) <0, 0> #end }",
    "10^9 triangles": "mesh { #for (I, 1, 1000000000) triangle { x, y, z + I } #end }",
    "10^9 colours": "sphere { 0, 1 pigment { gradient x color_map { "
                    "#for (I, 1, 1000000000) [I rgb 1] #end } } }",
    "10^9 points of a spline, the last first": "#declare S = spline { natural_spline "
                                               "#for (I, 1, 1000000000) -I, <I, 0, 0> #end }",
    "copies of an array": "#declare A = array[1000000]; #declare B = array[1000000]; "
                          "#for (I, 0, 999999) #declare B[I] = A; #declare A[0] = I; #end",
    "macro that calls itself twice": "#macro F(n) #if (n < 2) 1 #else (F(n-1) + F(n-2)) #end #end "
                                     "#declare A = F(100);",
    "picture from a slow function":
        "#declare F = function { sum(i, 1, 100000, sin(i*x)) } "
        "sphere { 0, 1 pigment { image_map { function 4096, 4096 { F(x, y, z) } } } }",
}

BUDGETS = [
    ("max-steps", "100", "#for (I, 1, 100) #declare A = I; #end"),
    ("max-objects", "100", "#for (I, 1, 20000) sphere { 0, 1 } #end"),
    ("max-nesting", "20", "union { " * 30 + "sphere { 0, 1 }" + " }" * 30),
    ("max-string-bytes", "100", '#declare A = "0123456789"; #declare B = concat('
                                + ", ".join(["A"] * 20) + ");"),
    ("max-array-elements", "100", "#declare A = array[200];"),
    ("max-written-bytes", "100", '#debug "0123456789"'),
    ("max-scene-bytes", "20000000", "#declare A = array[2000000];"),
]

ACCEPTED = {
    "arccosine of 2": (SCENE + "#declare A = acos(2);").encode(),
    "character code of nothing": (SCENE + '#declare A = asc("");').encode(),
    "number from letters": (SCENE + '#declare A = val("abc");').encode(),
    "numbers at the ends of their range":
        (SCENE + "sphere { 0, 1e300 } sphere { 0, 1e-300 } torus { 1e300, 1e300 }").encode(),
    "camera along its sky": (SCENE + "camera { location 5*y look_at 0 }").encode(),
    "camera without a sky": (SCENE + "camera { location -5*z sky 0 look_at 0 }").encode(),
    "finish beyond every range": (SCENE + "sphere { x, 1 finish { phong 1e300 phong_size 1e300 "
                                  "specular 1e300 roughness 0 brilliance -1e300 } }").encode(),
    "patterns beyond every range":
        (SCENE + "sphere { x, 1 pigment { crackle form <1e300, 1, 1> metric 1e300 offset 1e300 "
         "turbulence 1e300 octaves 1000000000 lambda 1e-300 omega 1e300 } normal { bumps 1e300 "
         "scale 1e-90 } } sphere { -x, 1 pigment { mandel 1000000000 scale 1e90 } }").encode(),
    "fog beyond every range": (SCENE + "fog { fog_type 2 distance 1e-300 rgb 1 fog_alt 0 "
                               "fog_offset 1e300 turbulence 1e300 turb_depth 1e300 }").encode(),
    "light beyond every range": (SCENE + "light_source { 0, rgb 1e300 fade_power -1e300 "
                                 "fade_distance 1e300 spotlight point_at 0 }").encode(),
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


# What opens, and the text before it; each is repeated 10^5 times and never closed.
OPENERS = [
    ("#declare A =", "("), ("#declare A =", "-"), ("#declare A =", "<"), ("#declare A = (", "!"),
    ("#declare A = (", "1 ? "), ("#declare A = (", "1 ? 1 : "), ("#declare A =", "sin("),
    ("#declare A =", "vlength("), ("#declare A =", "rgb "), ("#declare A =", "array[1] { "),
    ("#declare A = array[1] { 0 }; #declare B =", "A["), ("#declare A =", "#declare B = "),
    ("#debug ", "concat("), ("#declare F = function {", "("), ("#declare F = function {", "-"),
    ("#declare F = function {", "select("), ("#declare F = function {", "pigment { function { "),
    ("#declare F = function(x) { x } #declare A =", "F("), ("#macro M(a) a #end #declare A =", "M("),
    ("", "union { "), ("", "object { "), ("", "difference { "), ("", "light_group { "),
    ("", "#if (1) "), ("", "#if (0) "), ("", "#while (1) "), ("", "#switch (1) #case (1) "),
    ("", "#macro M() "), ("", "/* "), ("", "#default { texture { average texture_map { [1 "),
    ("sphere { 0, 1 ", "clipped_by { sphere { 0, 1 "), ("sphere { 0, 1 ", "transform { "),
    ("sphere { 0, 1 ", "texture { gradient x texture_map { [0 "),
    ("sphere { 0, 1 normal { ", "gradient x normal_map { [0 "),
    ("sphere { 0, 1 pigment { ", "image_map { function 2, 2 { pigment { "),
    ("sphere { 0, 1 pigment { ", "object { sphere { 0, 1 pigment { "),
    ("", "light_source { 0, 1 projected_through { "), ("global_settings ", "{ "),
]

PICTURE_OF_NOTHING = {
    "camera without direction": "camera { location 0 direction 0 }",
    "camera whose right is its direction": "camera { location 0 direction x right x }",
    "camera without right": "camera { location -z right 0 look_at 0 }",
    "camera without up": "camera { location -z up 0 look_at 0 }",
    "camera that looks at itself": "camera { location x look_at x }",
    "camera angle 0": "camera { location -z angle 0 look_at 0 }",
    "camera angle 180": "camera { location -z angle 180 look_at 0 }",
    "camera angle 360": "camera { location -z angle 360 look_at 0 }",
    "camera angle below every number": "camera { location -z angle 1e-300 look_at 0 }",
    "camera at no place": "camera { location 1e308 * 10 look_at 0 }",
    "camera focused behind itself":
        "camera { location -z look_at 0 aperture 1 focal_point -2*z blur_samples 4 }",
    "radius that is infinite": "sphere { 0, 1e308 * 10 }",
    "centre that is no number": "#declare A = 0 / 0; sphere { A - A, 1 }",
    "corner that is no number": "box { -1, <1, 1, 1e308*10 - 1e308*10> }",
    "move to infinity": "sphere { 0, 1 translate 1e308 * 10 }",
    "scale beyond every number": "sphere { 0, 1 scale 1e200 scale 1e200 }",
    "scale below every number": "sphere { 0, 1 scale 1e-200 scale 1e-200 }",
    "scale below every number, in two objects":
        "union { sphere { 0, 1 scale 1e-60 } scale 1e-60 }",
    "flat matrix": "sphere { 0, 1 matrix <1, 1, 1, 1, 1, 1, 1, 1, 1, 0, 0, 0> }",
}

ENCODINGS = {
    "UTF-16, small end first": b"\xff\xfe" + SCENE.encode("utf-16-le"),
    "UTF-16, large end first": b"\xfe\xff" + SCENE.encode("utf-16-be"),
    "zero byte": SCENE.encode() + b"sphere { 0, 1 \0 }",
    "zero byte in a file name": SCENE.encode() + b'#include "a\0b.inc"',
    "letter of another alphabet": SCENE.encode() + "#declare \u00c4 = 1;".encode(),
    "broken UTF-8": SCENE.encode() + b"sphere { 0, \xc3\x28 }",
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
        self.assertEqual(outcome.output.count("error: "), 1, outcome.output[-500:])
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

    def test_brackets_that_never_close_are_refused(self):
        for before, opener in OPENERS:
            with self.subTest(opener=opener, before=before):
                self.assert_refused(self.attempt(SCENE + before + opener * 100000))

    def test_pictures_of_nothing_are_refused(self):
        for name, text in PICTURE_OF_NOTHING.items():
            with self.subTest(case=name):
                self.assert_refused(self.attempt(SCENE + text))

    def test_texts_in_other_encodings_are_refused(self):
        for name, content in ENCODINGS.items():
            with self.subTest(case=name):
                self.assert_refused(self.attempt(content))

    def test_line_ends_of_every_kind_count(self):
        for end in ("\n", "\r\n", "\r"):
            with self.subTest(end=end):
                text = "#version 3.7;\n// a comment\n/* two\nlines */\nsphere { 0, }\n"
                outcome = self.attempt(text.replace("\n", end).encode())
                self.assert_refused(outcome)
                self.assertIn("a.pov:5:13: error:", outcome.output)

    def test_each_budget_names_its_option(self):
        for option, least, text in BUDGETS:
            with self.subTest(option=option):
                outcome = self.attempt(SCENE + text, f"--{option}", least)
                self.assert_refused(outcome)
                self.assertIn(f"raise the limit with --{option}", outcome.output)
                self.assertEqual(self.attempt(SCENE + text).status, 0)

    def test_messages_have_no_commands_for_the_terminal(self):
        outcome = self.attempt(SCENE + '#warning "\\u001b[2J" #include "\x1b]0;x\x07.inc"')
        self.assert_refused(outcome)
        self.assertNotIn("\x1b", outcome.output)

    def test_an_old_language_version_can_be_asked_for(self):
        for version in ("3.1", "3.5", "3.7"):
            outcome = self.attempt("#debug str(version, 0, 1)\n", f"+MV{version}")
            self.assertEqual(outcome.status, 0)
            self.assertIn(version, outcome.output)
            self.assertNotIn("warning", outcome.output)

    def test_an_included_header_is_read_first(self):
        self.write("first.inc", "#version 3.7; #declare Size = 1;\n")
        outcome = self.attempt("sphere { 0, Size }\n", "+HIfirst.inc")
        self.assertEqual(outcome.status, 0, outcome.output)


if __name__ == "__main__":
    unittest.main()
