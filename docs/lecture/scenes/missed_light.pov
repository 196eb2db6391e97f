// SPDX-License-Identifier: Apache-2.0
// A mirror throws light on a wall that the lamp itself does not reach, and a red wall stands beside
// a white one. Light that comes by way of another surface is not in Whitted's model: the spot under
// the mirror is missing, and the white wall shows nothing of the red.
#version 3.7;
global_settings { assumed_gamma 1 }

camera { location <0, 2.2, -7> look_at <0, 1.2, 0> right x*image_width/image_height angle 48 }
light_source { <0, 4.5, -3.5> rgb 1.1 spotlight point_at <0, 0.05, -0.4> radius 12 falloff 16 }
#default { finish { ambient 0.12 diffuse 0.8 } }
plane { y, 0 pigment { rgb 0.8 } }
box { <-2.6, 0, 2>, <2.6, 3.6, 2.1> pigment { rgb 0.85 } }
box { <-2.7, 0, -3>, <-2.6, 3.6, 2> pigment { rgb <0.85, 0.15, 0.10> } }
box { <-0.8, 0.02, -1.1>, <0.8, 0.06, 0.4> pigment { rgb 0 } finish { ambient 0 diffuse 0 reflection 0.95 } }
