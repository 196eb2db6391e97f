// SPDX-License-Identifier: Apache-2.0
#version 3.7;
global_settings { assumed_gamma 1 }

// Surface coordinates of every shape that has them, with textures of all sorts.
camera { location <0, 5, -11> look_at <0, 0.4, 0> angle 42 }
light_source { <-8, 12, -10> rgb 1 }
#declare Grid = texture { uv_mapping pigment { checker rgb <0.9,0.3,0.2> rgb 1 scale <0.125, 0.25, 1> } finish { phong 0.3 } }
#declare Fade = texture { uv_mapping pigment { gradient x color_map { [0 rgb <1,1,0>] [1 rgb <0,0.3,1>] } } normal { gradient y 0.5 scale 0.1 } }
sphere { <-3.2, 0.5, 0>, 1 texture { Grid } }
box { <-1.9, -0.5, -0.8>, <-0.3, 1.1, 0.8> texture { Grid } rotate 0 }
torus { 0.8, 0.3 texture { Grid } rotate -40*x translate <1.2, 0.5, 0> }
lathe { quadratic_spline 5, <0,-1>, <0.8,-0.6>, <0.4,0.4>, <0.7,1>, <0,1.2> texture { Grid } translate <3.4, 0.4, 0> }
sor { 5, <0.3,-0.8>, <0.6,-0.5>, <0.3,0.3>, <0.5,0.9>, <0.2,1.2> texture { Fade } translate <-2.5, 0, -3> }
ovus { 0.6, 0.35 pigment { rgb <0.9,0.8,0.5> } translate <-0.5, 0.2, -3> }
mesh { triangle { <1,-0.5,-3>, <2.6,-0.5,-3.4>, <1.8,1,-2.6> uv_vectors <0,0>, <1,0>, <0.5,1> } texture { Grid } }
plane { y, -0.9 pigment { rgb 0.7 } }
