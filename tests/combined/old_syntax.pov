// SPDX-License-Identifier: Apache-2.0
#version 3.1;
// A file of the last century: its own gamma, refraction in the finish, colours by name.
#include "colors.inc"
#include "textures.inc"
camera { location <0, 3, -8> direction <0, 0, 1.8> look_at <0, 0.5, 0> }
light_source { <-6, 9, -8> color White }
#declare Half = 0.5;
sphere { <-2, 0.5, 0>, 1 texture { pigment { color Red } finish { phong 1 reflection 0.2 } } }
sphere { <0.2, 0.5, 0>, 1 pigment { color rgbf <0.9, 1, 0.9, 0.8> } finish { refraction 1 ior 1.3 phong 0.5 } }
box { <1.6, -0.5, -0.8>, <3.2, 1.2, 0.8> texture { DMFWood1 } rotate Half*40*y }
cone { <-3.4, -0.5, -2.5>, 0.7, <-3.4, 1, -2.5>, 0 texture { Chrome_Metal } }
plane { y, -0.5 pigment { checker color Gray80 color NavyBlue } }
