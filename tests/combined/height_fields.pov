// SPDX-License-Identifier: Apache-2.0
#version 3.7;
global_settings { assumed_gamma 1 }

// Land from functions: smooth, under water level, and in a difference.
camera { location <0, 4, -7> look_at <0, 0, 0> angle 42 }
light_source { <-6, 9, -8> rgb 1 }
#include "functions.inc"
#declare H = height_field { function 60, 60 { 0.5 + 0.25*sin(8*x)*cos(9*y) + 0.2*f_noise3d(5*x, 5*y, 0) } smooth water_level 0.2 translate <-0.5, 0, -0.5> }
object { H scale <3.5, 1, 3.5> pigment { gradient y color_map { [0 rgb <0.2,0.4,0.2>] [0.8 rgb <0.9,0.8,0.6>] } } translate -1.8*x }
difference { object { H scale <3, 1.2, 3> } cylinder { -y, 2*y, 0.7 pigment { rgb <1,0.4,0.3> } } box { <0.6,-1,-2>, <2,2,-0.3> pigment { rgb <0.4,0.4,1> } } pigment { rgb 0.8 } translate 2*x }
plane { y, 0.1 pigment { rgb <0.4,0.6,0.9> } }
