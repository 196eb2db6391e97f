// SPDX-License-Identifier: Apache-2.0
#version 3.7;
global_settings { assumed_gamma 1 }

// A sky of several layers, turned, behind a mirror ball and through a window.
camera { location <0, 1, -6> look_at <0, 1, 0> angle 70 }
light_source { <-6, 9, -8> rgb 1 }
sky_sphere {
  pigment { gradient y color_map { [0 rgb <0.9,0.7,0.5>] [0.5 rgb <0.3,0.5,0.9>] [1 rgb <0.1,0.1,0.4>] } }
  pigment { bozo turbulence 0.6 octaves 4 color_map { [0.4 rgbt 1] [0.7 rgbt <1,1,1,0.2>] } scale <0.4, 0.15, 0.4> }
  pigment { spherical color_map { [0 rgbt 1] [0.2 rgbt <1,1,0.8,0.4>] [1 rgb 1] } scale 0.5 translate <0.3, 0.5, 1> }
  rotate 15*z
  emission <1, 0.9, 0.8>
}
sphere { <0, 1, 1>, 1.2 pigment { rgb 0 } finish { reflection { 0.3, 0.95 falloff 2 } } }
box { <-3, -1, 0>, <-1.6, 3, 0.1> pigment { rgbf <0.8, 1, 0.8, 0.8> } }
plane { y, -0.6 pigment { rgb <0.5,0.5,0.4> } finish { reflection { 0.1 metallic exponent 0.8 } } }
