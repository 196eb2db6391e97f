# SPDX-License-Identifier: Apache-2.0
"""Isosurfaces are the solids that their functions say, whatever is said about gradients."""

import unittest

from program import ProgramTest, images

HEADER = """#version 3.7; global_settings { assumed_gamma 1 }
#include "functions.inc"
camera { location <1, 1.5, -3> look_at 0 angle 50 } light_source { <-3, 5, -5> rgb 1 }
plane { y, -1.3 pigment { rgb 0.8 } }
#default { pigment { rgb <1, .5, .2> } finish { phong 0.3 } }
"""
BALL = "isosurface { function { f_sphere(x, y, z, 0.9) } contained_by { box { -1, 1 } } %s }"
WAVES = ("isosurface { function { y + 0.3*sin(5*x)*cos(4*z) - 0.1*x } max_gradient 3 "
         "contained_by { box { -1, 1 } } %s }")
# Pairs that show the same.
SAME = {
    "sphere": (BALL % "", "sphere { 0, 0.9 }"),
    "torus": ("isosurface { function { f_torus(x, y, z, 0.7, 0.25) } rotate 40*x }",
              "torus { 0.7, 0.25 rotate 40*x }"),
    "cut off by its container": ("isosurface { function { x - 2 } contained_by { sphere { 0, 1 } } }",
                                 "sphere { 0, 1 }"),
    "open": ("isosurface { function { sqrt(x*x + z*z) - 0.6 } open rotate 30*x }",
             "cylinder { -y, y, 0.6 open rotate 30*x }"),
    "threshold": ("isosurface { function { x*x + y*y + z*z } threshold 0.64 }", "sphere { 0, 0.8 }"),
    "difference from it": ("difference { %s box { <0, -2, -2>, 2 } }" % BALL % "",
                           "difference { sphere { 0, 0.9 } box { <0, -2, -2>, 2 } }"),
    "difference by it": ("difference { box { -0.8, 0.8 } %s }" % BALL % "",
                         "difference { box { -0.8, 0.8 } sphere { 0, 0.9 } }"),
    "merge": ("merge { %s box { 0, 1.1 } pigment { rgbt <1, 0.9, 0.8, 0.5> } }" % BALL % "",
              "merge { sphere { 0, 0.9 } box { 0, 1.1 } pigment { rgbt <1, 0.9, 0.8, 0.5> } }"),
    "inverse": ("intersection { box { -0.8, 0.8 } object { %s inverse } }" % BALL % "",
                "intersection { box { -0.8, 0.8 } sphere { 0, 0.9 inverse } }"),
    "mirrored": (WAVES % "scale <-1, 1, 1>",
                 "isosurface { function { y + 0.3*sin(-5*x)*cos(4*z) + 0.1*x } }"),
    "noise": ("isosurface { function { sqrt(x*x+y*y+z*z) - 0.6 - 0.3*f_noise3d(4*x, 4*y, 4*z) } }",
              "isosurface { function { f_sphere(x, y, z, 0.6) - 0.3*f_noise3d(4*x, 4*y, 4*z) } "
              "max_gradient 5 accuracy 0.0001 }"),
}
# What must not show where the function's bounds are known.
NO_MATTER = ("max_gradient 0.001", "max_gradient 1000", "evaluate 0.01, 1, 0.9", "all_intersections",
             "max_trace 3")


class Isosurfaces(ProgramTest):
    def picture(self, objects):
        self.write("a.pov", HEADER + objects)
        self.render("a.pov", "a.ppm", "-A")
        return images.read_ppm(self.folder / "a.ppm")

    def test_what_is_the_same_looks_the_same(self):
        for name, (iso, other) in SAME.items():
            with self.subTest(name):
                a, b = self.picture(iso).rgb, self.picture(other).rgb
                differ = sum(max(abs(p - q) for p, q in zip(a[i : i + 3], b[i : i + 3])) > 4
                             for i in range(0, len(a), 3))
                self.assertLess(differ, 0.02 * len(a) / 3)

    def test_a_wrong_gradient_makes_no_holes(self):
        picture = self.picture(WAVES % "").rgb
        for words in NO_MATTER:
            with self.subTest(words):
                self.assertEqual(self.picture(WAVES % words).rgb, picture)

    def test_a_dumped_scene_gives_the_same_picture(self):
        scene = self.write("a.pov", HEADER + WAVES % "open rotate 20*y" + BALL % "translate x")
        outcome = self.dioptre("dump", scene)
        self.assertEqual(outcome.status, 0, outcome.output)
        self.write("a.json", outcome.output)
        self.assertEqual(self.render("a.json", "b.ppm"), self.render("a.pov", "a.ppm"))

    def test_trace_and_inside_see_it(self):
        self.write("a.pov", HEADER + f"""#declare Iso = {BALL % "accuracy 1e-6"}
#declare N = 0; #declare P = trace(Iso, <0.3, 5, 0.2>, -3*y, N);
#if (abs(vlength(P) - 0.9) > 1e-5 | vdot(N, vnormalize(P)) < 0.99) #error "trace" #end
#if (!inside(Iso, 0.5*y) | inside(Iso, 0.95*y) | inside(Iso, 2*y)) #error "inside" #end""")
        self.render("a.pov", "a.ppm")


if __name__ == "__main__":
    unittest.main()
