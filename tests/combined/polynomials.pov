// SPDX-License-Identifier: Apache-2.0
#version 3.7;
global_settings { assumed_gamma 1 }

#include "shapes.inc"
// Quadrics, cubics, quartics and a poly, cut and cutting.
camera { location <0, 5, -11> look_at <0, 0.4, 0> angle 40 }
light_source { <-8, 12, -10> rgb 1 }
intersection { object { Hyperboloid_Y } plane { y, 1.2 } plane { -y, 1 } pigment { rgb <1,0.5,0.3> } scale <0.5,0.8,0.5> translate -3.5*x }
intersection { quartic { <1,0,0,0,2,0,0,2,0,-1.3, 0,0,0,0,0,0,0,0,0,0, 1,0,0,2,0,1.1,0,0,0,0, 1,0,-1.3,0,0.2> } box { -2, <2, 0.3, 2> } rotate -30*x pigment { rgb <0.4,0.9,0.5> } translate <-1, 0.4, 0> }
difference { cubic { <1,0,0,0,0,0,0,0,0,-1, 1,0,0,0,0,0,1,0,0,0> } box { <-3,-3,-3>, <3,3,0> inverse } sphere { 0, 1.6 inverse } pigment { rgb <0.5,0.5,1> } rotate 40*y translate <1.6, 0.4, 0> }
poly { 4, <1,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,1,0,0,0,0,0,0,0,0,0,1,0,0,0,-1> scale 0.8 pigment { rgb <0.9,0.8,0.4> } rotate <20,30,0> translate <3.6, 0.3, 0> }
merge { object { Paraboloid_Y clipped_by { plane { y, 1 } } } sphere { 1.2*y, 0.5 } pigment { rgbt <0.9,0.4,0.7,0.3> } scale 0.7 translate <0, -0.3, -3> }
plane { y, -0.6 pigment { checker rgb 0.9 rgb 0.7 } }
