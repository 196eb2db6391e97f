// SPDX-License-Identifier: Apache-2.0
#version 3.7;
global_settings { assumed_gamma 1 }

// What is hidden from the eye, from mirrors or from lights; light on both sides; open and inverse.
camera { location <0, 4, -9> look_at <0, 0.6, 0> angle 45 }
light_source { <-6, 9, -8> rgb 1 }
light_source { <0, 0.6, 2> rgb 0.5 }
sphere { <-3, 0.5, 0>, 0.8 pigment { rgb <1,0.3,0.3> } no_shadow }
sphere { <-1, 0.5, 0>, 0.8 pigment { rgb <0.3,1,0.3> } no_image }
sphere { <1, 0.5, 0>, 0.8 pigment { rgb <0.3,0.3,1> } no_reflection }
cylinder { <3, -0.4, 0>, <3, 1.4, 0>, 0.8 open pigment { rgb <0.9,0.8,0.3> } interior_texture { pigment { rgb <0.2,0.9,0.9> } finish { ambient 0.4 } } double_illuminate }
difference { box { <-4, -0.3, -3>, <-2.4, 0.6, -2> } sphere { <-3.2, 0.6, -2.6>, 0.5 inverse } pigment { rgb 0.8 } }
intersection { sphere { <2, 0, -3>, 0.7 } sphere { <2, 0.5, -3>, 0.4 inverse } plane { -y, 0.4 } pigment { rgb <0.8,0.6,0.9> } }
box { <-5, -0.5, 3>, <5, 4, 3.1> pigment { rgb 0.1 } finish { reflection 0.8 } }
plane { y, -0.5 pigment { checker rgb 0.9 rgb 0.6 } }
