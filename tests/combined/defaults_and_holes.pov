// SPDX-License-Identifier: Apache-2.0
#version 3.7;
global_settings { assumed_gamma 1 }
// Defaults that declared finishes begin with, and black holes that repeat and pull hard.
#default { finish { ambient 0.4 diffuse 0.5 } }
#declare Shiny = finish { phong 0.5 };
#default { pigment { rgb <0.7, 0.9, 0.6> } }
camera { location <0, 4, -8> look_at <0, 0.3, 0> angle 45 }
light_source { <-5, 8, -6> rgb 1 }
sphere { <-2, 0.5, 0>, 1 finish { Shiny } }
sphere { <2, 0.5, 0>, 1 texture { pigment { rgb <0.9, 0.5, 0.4> } finish { Shiny } } }
plane { y, -0.5 pigment { gradient x color_map { [0 rgb 1] [0.5 rgb <0.4, 0.2, 0.1>] [1 rgb 1] } scale 0.4
  warp { black_hole <0, 0, 0>, 0.9 falloff 2 strength 1.8 inverse repeat <2, 0, 2> turbulence <0.4, 0, 0.5> }
  warp { black_hole <0, -0.5, -2>, 1.5 falloff 1 strength 2 } } }
