// SPDX-License-Identifier: Apache-2.0
#version 3.7;
global_settings { assumed_gamma 1 }

#include "transforms.inc"
#include "shapes.inc"
// Objects of the standard include files, aligned, sheared and reflected, with matrices undone.
camera { location <0, 4, -10> look_at <0, 0.6, 0> angle 42 }
light_source { <-8, 12, -10> rgb 1 }
#declare A = <1, 2, 0.5>;
#declare Stick = union { cylinder { 0, 2*y, 0.15 } cone { 2*y, 0.35, 2.6*y, 0 } }
object { Stick Reorient_Trans(y, A) pigment { rgb <1,0.4,0.3> } translate -3*x }
object { Stick Axis_Rotate_Trans(A, 70) pigment { rgb <0.4,1,0.3> } translate -1*x }
object { Round_Box_Union(<-0.6,-0.6,-0.6>, <0.6,0.6,0.6>, 0.2) Shear_Trans(<1,0.2,0>, <0,1,0.3>, <0.4,0,1>) pigment { rgb <0.4,0.5,1> } translate <1, 0, 0> }
#declare T = transform { Reorient_Trans(x, A) scale <1, -1, 1> }
object { Stick transform { T } pigment { rgb <1,0.9,0.3> } translate 3*x }
object { object { Stick transform { T } } transform { T inverse } scale 0.6 pigment { rgb 1 } translate <3, -0.8, -2> }
object { Round_Cylinder_Merge(<-2.5, 0, -2>, <-1.5, 0.4, -2>, 0.5, 0.15) pigment { rgb 0.8 } }
plane { y, -0.8 pigment { checker rgb 0.9 rgb 0.7 } }
