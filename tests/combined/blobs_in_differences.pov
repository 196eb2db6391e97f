// SPDX-License-Identifier: Apache-2.0
#version 3.7;
global_settings { assumed_gamma 1 }

// Blobs cut by solids and cutting them, one of them with textures of its own for each part.
camera { location <0, 3, -8> look_at 0 angle 42 }
light_source { <-8, 12, -10> rgb 1 }
#declare B = blob { threshold 0.5
  sphere { <-0.8, 0, 0>, 1.2, 1 pigment { rgb <1, 0.3, 0.2> } }
  cylinder { <0, -0.5, 0>, <1.2, 0.6, 0>, 0.8, 1 pigment { rgb <0.2, 0.8, 0.3> } }
  sphere { <0.4, 0.8, -0.3>, 0.8, -0.7 pigment { rgb <0.2, 0.3, 1> } } }
difference { object { B } box { <-2, -2, -2>, <2, 2, -0.25> pigment { rgb <0.9, 0.9, 0.5> } } translate -1.6*x }
difference { box { -1, 1 pigment { rgb <0.7, 0.7, 0.8> } } object { B scale 0.9 } rotate 30*y translate <1.8, 0, 0> }
intersection { object { B } sphere { 0, 1 pigment { rgb 0.6 } } translate <0, 1.6, 1.5> }
plane { y, -1.2 pigment { checker rgb 0.9 rgb 0.5 } }
