// SPDX-License-Identifier: Apache-2.0
#version 3.7;
global_settings { assumed_gamma 1 }

// Letters cut from a prism, a lathe with a text through it, textures in layers.
camera { location <0, 2.5, -8> look_at <0, 0.7, 0> angle 45 }
light_source { <-10, 14, -10> rgb 1 }
#declare Layered =
  texture { pigment { marble turbulence 0.6 color_map { [0 rgb <0.8,0.7,0.5>] [1 rgb <0.4,0.3,0.2>] } } finish { specular 0.4 } }
  texture { pigment { bozo color_map { [0 rgbt <1,1,1,0.2>] [0.5 rgbt <1,1,1,1>] [1 rgbt <0.2,0.4,0.2,0.4>] } scale 0.4 } }
difference {
  prism { linear_spline -0.5, 0.5, 5, <-3,-1>, <-2.5,1.4>, <2.2,1.6>, <2.6,-1.3>, <-3,-1> rotate -90*x translate <0,0.8,0> }
  text { ttf "timrom.ttf" "Ray" 2, 0.05*x scale 1.8 translate <-1.4, 0.3, -1> }
  texture { Layered }
}
intersection {
  lathe { quadratic_spline 6, <0,0>, <0.6,0>, <0.9,0.5>, <0.4,1.2>, <0.7,1.8>, <0,2> }
  text { ttf "cyrvetic.ttf" "#" 4, 0 scale 2.2 translate <-0.6, 0.2, -2> }
  texture { pigment { rgb <0.3, 0.6, 0.9> } finish { reflection 0.2 } }
  translate <2, -0.9, -2>
}
plane { y, -1 pigment { hexagon rgb 0.9, rgb <0.6,0.7,0.9>, rgb <0.9,0.8,0.6> } }
