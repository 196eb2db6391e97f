// SPDX-License-Identifier: Apache-2.0
// A light with an extent, and what it leaves behind a ball and a grille.
#version 3.7;
global_settings { assumed_gamma 1 }

camera { location <0, 4.5, -9> look_at <0, 0.4, 0.5> right x*image_width/image_height angle 42 }
light_source { <-3, 7, -3> rgb 1 area_light 2*x, 2*z, 9, 9 }
background { rgb <0.80, 0.86, 0.93> }
plane { y, 0 pigment { rgb 0.85 } finish { ambient 0.1 diffuse 0.85 } }
#default { finish { ambient 0.1 diffuse 0.8 phong 0.3 } }
sphere { <-1.6, 1.2, 0>, 0.8 pigment { rgb <0.85, 0.40, 0.25> } }
union {
  #for (X, 0, 8) cylinder { <0.3*X, 0, 0>, <0.3*X, 2.2, 0>, 0.06 } #end
  pigment { rgb <0.30, 0.45, 0.65> } rotate 25*y translate <0.4, 0, -0.4>
}
