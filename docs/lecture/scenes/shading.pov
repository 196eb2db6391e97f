// SPDX-License-Identifier: Apache-2.0
// The shading models by name, from left to right: ambient alone, Lambert's diffuse, Phong's and
// Blinn's highlights, and both kinds of texture, from a formula and layered. All cast shadows.
#version 3.7;
global_settings { assumed_gamma 1 }

camera { location <0, 3.2, -9> look_at <0, 0.7, 0> right x*image_width/image_height angle 66 }
light_source { <-5, 8, -7> rgb 1 }
background { rgb <0.75, 0.83, 0.92> }
plane { y, 0 pigment { rgb 0.8 } finish { ambient 0.15 diffuse 0.75 } }

#declare Red = pigment { rgb <0.80, 0.25, 0.20> };
#macro Ball(Place, Look) sphere { <Place, 0.75, 0>, 0.75 texture { Look } } #end
Ball(-4.25, texture { pigment { Red } finish { ambient 0.6 diffuse 0 } })
Ball(-2.55, texture { pigment { Red } finish { ambient 0.1 diffuse 0.8 } })
Ball(-0.85, texture { pigment { Red } finish { ambient 0.1 diffuse 0.7 phong 0.8 phong_size 30 } })
Ball(0.85, texture { pigment { Red } finish { ambient 0.1 diffuse 0.7 specular 0.8 roughness 0.03 } })
Ball(2.55, texture {
  pigment { marble turbulence 0.8 color_map { [0 rgb <0.9, 0.88, 0.8>] [0.7 rgb <0.7, 0.6, 0.5>] [1 rgb <0.2, 0.15, 0.2>] } }
  finish { ambient 0.1 diffuse 0.75 phong 0.5 } })
Ball(4.25, texture {
  pigment { rgb <0.25, 0.45, 0.70> } normal { bumps 0.6 scale 0.15 } finish { ambient 0.1 diffuse 0.7 specular 0.4 } })
