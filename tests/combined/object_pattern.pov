// SPDX-License-Identifier: Apache-2.0
#version 3.7;
global_settings { assumed_gamma 1 }

// A solid as a pattern, in pigments and in normals, beside functions of patterns.
camera { location <0, 3, -7> look_at 0 angle 45 }
light_source { <-6, 10, -8> rgb 1 }
#declare Star = union { box { -0.4, 0.4 } box { -0.4, 0.4 rotate 45*z } torus { 0.7, 0.15 rotate 90*x } }
#declare F = function { pattern { wood turbulence 0.3 scale 0.4 } }
#declare G = function(x, y, z) { F(x, y, z)*0.6 + 0.4*sin(6*x)*sin(6*z) }
plane { y, -1 pigment { object { object { Star rotate 90*x scale 0.9 } rgb <0.9,0.9,0.7>, rgb <0.6,0.2,0.2> } warp { repeat 2*x } warp { repeat 2*z } } }
sphere { <-1.4, 0, 0>, 1 pigment { function { G(x, y, z) } color_map { [0 rgb <0,0,0.5>] [0.5 rgb <0.9,0.9,0.2>] [1 rgb 1] } } normal { function { G(x,y,z) } 0.4 } }
box { <0.5, -1, -0.8>, <2.2, 0.7, 0.8> pigment { pigment_pattern { cells scale 0.3 } pigment_map { [0 rgb <1,0,0>] [0.5 checker rgb 1 rgb 0.2 scale 0.23] [1 gradient y] } } rotate 25*y }
