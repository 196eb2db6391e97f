# SPDX-License-Identifier: Apache-2.0
"""Shapes, media and lights with parameters at the ends of their ranges and beyond. Each is rendered
or refused with its place, within 5 seconds and 512 MiB."""

import unittest

from program import SCENE, ProgramTest

EXTREMES = (
    "isosurface { function { x*x + y*y + z*z - 1 } contained_by { box { -1.2, 1.2 } } accuracy 0 "
    "max_gradient 1e300 }",
    "isosurface { function { 1/(x - x) } contained_by { box { -1, 1 } } accuracy 1e-300 "
    "max_gradient 0 }",
    "isosurface { function { x } contained_by { sphere { 0, 0 } } max_trace 1000000000 }",
    "isosurface { function { sqrt(-1 - x*x) } contained_by { box { -1, 1 } } open }",
    "isosurface { function { x } contained_by { sphere { 0, 1e300 } } evaluate 0, 0, 0 }",
    "height_field { function 1, 1 { x } }",
    "height_field { function 1000000000, 1000000000 { x } }",
    "height_field { function 8, 8 { 1/(x - x) } smooth water_level 1e300 }",
    "lathe { linear_spline 1, <1, 1> }",
    "lathe { cubic_spline 1000000000, <0, 0> }",
    "lathe { bezier_spline 4, <0/0, 1>, <1e300, 2>, <1e-300, 3>, <0, 4> }",
    "sor { 4, <0, 0>, <1, 0>, <1, 0>, <0, 0> }",
    "sphere_sweep { cubic_spline 4, 0, 0, 0, 0, 0, 0, 0, 0 }",
    "sphere_sweep { b_spline 1000000000, 0, 1 }",
    "sphere_sweep { b_spline 4, 0, 1e300, x*1e300, 1, y, -1, z, 1 tolerance 0 }",
    "bicubic_patch { type 1 flatness 0 u_steps 1000000 v_steps 1000000 0, x, 2*x, 3*x, y, x+y, "
    "2*x+y, 3*x+y, 2*y, x+2*y, 2*x+2*y, 3*x+2*y, 3*y, x+3*y, 2*x+3*y, 3*x+3*y }",
    "bicubic_patch { type 0 flatness 0 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0 }",
    "julia_fractal { <1e300, 0, 0, 0> max_iteration 1000000000 precision 1e9 }",
    "julia_fractal { <0.1, 0.2, 0.3, 0.4> hypercomplex reciprocal slice 0, 0 }",
    "parametric { function { 1/0 } function { v } function { 0 } <0, 0>, <0, 0> "
    "contained_by { sphere { 0, 0 } } }",
    "superellipsoid { <0, 0> }", "superellipsoid { <1e-300, 1e300> }",
    "superellipsoid { <-1, 0/0> }",
    "ovus { 1e300, 0 }", "ovus { 0, 0 }", "ovus { -1, -1 }",
    "torus { 1e300, 1e300 }", "torus { -1, -2 }", "torus { 0, 0 }",
    "cone { 0, -1, y, 1e300 }", "cone { 0, 0, y, 0 }", "cylinder { 0, 1e-300*y, 1 }",
    "box { -1e308, 1e308 }", "sphere { 0, -1 }", "disc { 0, 0, 1 }", "disc { 0, y, -1, 5 }",
    "poly { 35, <1" + ", 1" * 8435 + "> }", "poly { 2, <" + "0, " * 9 + "0> }",
    "quadric { 0, 0, 0, 0 }", "quadric { 1e300, 1e300, 1e300, 1e300 }",
    "blob { threshold 0 sphere { 0, 1, 1 } }", "blob { threshold 1e-300 sphere { 0, 1e300, 1e300 } }",
    "prism { linear_sweep linear_spline 1, 1, 4, <0, 0>, <1, 0>, <0, 1>, <0, 0> }",
    "prism { conic_sweep cubic_spline 0, 1e300, 6, <0, 0>, <0, 0>, <0, 0>, <0, 0>, <0, 0>, <0, 0> }",
    "polygon { 4, 0, 0, 0, 0 }", "polygon { 4, 0, x, 2*x, 0 }",
    "mesh { triangle { 0, 0, 0 } }", "mesh { smooth_triangle { 0, 0, x, 0, y, 0 } }",
    "mesh2 { vertex_vectors { 1000000000, 0 } }",
    'text { ttf "timrom.ttf" "" 1, 0 }', 'text { ttf "timrom.ttf" "A" 0, 1e300*x }',
    "union { }", "difference { }", "intersection { sphere { 0, 1 } sphere { 5, 1 } }",
    "light_source { 0, 1 area_light 0, 0, 4, 4 adaptive 1000000 jitter }",
    "light_source { 0, 1e300 spotlight point_at 0 radius 1e300 falloff -1e300 tightness 1e300 }",
    "light_source { y, 1 cylinder point_at y radius 0 falloff 0 }",
    "media { emission 1e300 absorption -1e300 samples 1000000 density { bozo } }",
    "sphere { 0, 2 pigment { rgbt 1 } hollow interior { media { scattering { 5, 1e300 } "
    "samples 1000 intervals 1000 } } }",
    "rainbow { angle 0 width 0 distance 0 }", "fog { distance 0 rgb 1 }",
    "global_settings { photons { spacing 1e-12 } } sphere { 0, 1 photons { target 1e-9 "
    "reflection on refraction on } }",
    "global_settings { radiosity { count 1000000000 error_bound 1e-300 } }",
)


class HostileShapes(ProgramTest):
    def test_extreme_parameters_do_no_harm(self):
        for text in EXTREMES:
            with self.subTest(scene=text[:100]):
                self.write("a.pov", SCENE + text)
                outcome = self.dioptre("+Ia.pov", "+Oa.ppm", "+W16", "+H12", "+FP", "-D",
                                       "--progress=none", cpu_seconds=10)
                self.assertGreaterEqual(outcome.status, 0, outcome.output[-500:])
                self.assertLess(outcome.cpu_seconds, 5)
                self.assertLess(outcome.peak_bytes, 512 << 20)
                if outcome.status != 0:
                    self.assertRegex(outcome.output, r"a\.pov:\d+:\d+: error: ")
                    self.assertEqual(outcome.output.count("error: "), 1, outcome.output)


if __name__ == "__main__":
    unittest.main()
