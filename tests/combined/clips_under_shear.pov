// SPDX-License-Identifier: Apache-2.0
#version 3.7;
global_settings { assumed_gamma 1 }

// Clips within clips, each moved and sheared with what it clips.
camera { location <2, 4, -10> look_at 0 angle 40 }
light_source { <-8, 15, -12> rgb 1 }
#declare Piece = union {
  sphere { 0, 1 clipped_by { box { <-2, -0.5, -2>, <2, 2, 2> rotate 20*z } } }
  torus { 1.2, 0.25 rotate 30*x clipped_by { plane { x, 0.4 inverse } } }
  clipped_by { cylinder { -2*z, 2*z, 1.3 } }
  texture { pigment { gradient x color_map { [0 rgb <1,0.4,0.2>] [1 rgb <0.2,0.3,1>] } scale 0.5 } finish { specular 0.5 } }
}
#declare Shear = transform { matrix <1, 0.3, 0, 0, 1, 0.4, 0.2, 0, 1, 0, 0, 0> }
object { Piece transform { Shear } translate -2*x }
object { Piece scale <0.8, 1.4, 1> transform { Shear } rotate 60*y translate 2*x
  clipped_by { sphere { 2.2*x, 1.4 scale <1, 0.8, 1> } } }
object { Piece matrix <1, 0, 0, 0.5, 1, 0, 0, -0.5, -1, 0, 1.5, 1> }
plane { y, -2 pigment { rgb <0.7, 0.8, 0.7> } }
