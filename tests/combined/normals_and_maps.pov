// SPDX-License-Identifier: Apache-2.0
#version 3.7;
global_settings { assumed_gamma 1 }

// Normals of normals: maps, averages, slope maps, layers and finishes that change across a surface.
camera { location <0, 3, -8> look_at 0 angle 45 }
light_source { <-6, 9, -8> rgb 1 }
sphere { -2.2*x, 1 pigment { rgb <0.9,0.6,0.3> } normal { gradient y normal_map { [0 bumps 0.8 scale 0.1] [0.5 dents 1 scale 0.3] [1 ripples 1 scale 0.2] } } finish { phong 0.7 } }
sphere { 0, 1 pigment { rgb <0.5,0.7,0.9> } normal { average normal_map { [1 wrinkles 0.9 scale 0.4] [2 gradient x 0.9 slope_map { [0 <0,1>] [0.5 <1,0>] [1 <0,-1>] } scale 0.3] } } finish { specular 0.5 } }
box { <1.2,-1,-1>, <3,0.8,0.8> texture { gradient y texture_map { [0.3 pigment { rgb 1 } finish { phong 1 }] [0.7 pigment { granite color_map { [0 rgb 0] [1 rgb <1,0.9,0.7>] } } finish { reflection 0.3 }] } scale 1.9 translate -1*y } rotate 20*y }
plane { y, -1 texture { pigment { bozo color_map { [0 rgb <0.3,0.6,0.3>] [1 rgb <0.7,0.8,0.5>] } } normal { quilted 0.6 control0 0.3 control1 0.8 scale 0.7 } }
  texture { pigment { leopard color_map { [0.6 rgbt 1] [0.7 rgbt <0.2,0.1,0,0.3>] } scale 0.3 } } }
