// SPDX-License-Identifier: Apache-2.0
#version 3.7;
global_settings { assumed_gamma 1 }

// Glass of merges and intersections that hold others, air bubbles, fading, total reflection.
camera { location <0, 3, -8> look_at <0, 0.2, 0> angle 40 }
light_source { <-8, 12, -10> rgb 1 }
#declare Glass = texture { pigment { rgbf <0.95, 1, 0.97, 0.9> } finish { specular 0.6 roughness 0.003 reflection { 0.02, 0.6 fresnel } conserve_energy } }
#declare In = interior { ior 1.5 fade_distance 2 fade_power 1001 fade_color <0.4, 0.8, 0.6> }
difference { merge { sphere { 0, 1 } box { <-0.6, -1, -0.6>, <0.6, 1.4, 0.6> } } sphere { <0.2, 0.2, 0>, 0.45 } texture { Glass } interior { In } translate -1.8*x }
union { sphere { 0, 1 texture { Glass } interior { In } } sphere { 0, 0.5 texture { Glass } interior { ior 1.1 } } translate 0.6*x }
intersection { cylinder { -y, y, 0.8 } box { -0.7, 0.7 rotate 45*y } plane { <0.5, 1, -0.5>, 0.5 } texture { Glass } interior { In } translate <2.6, 0, 0> }
plane { y, -1.01 pigment { checker rgb 1 rgb <0.2, 0.3, 0.5> scale 0.6 } }
sky_sphere { pigment { gradient y color_map { [0 rgb <0.9,0.9,1>] [1 rgb <0.2,0.4,0.9>] } } }
