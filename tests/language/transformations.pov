// SPDX-License-Identifier: Apache-2.0
// Transformations of objects.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location <4,3,-5> right 6*x up 4.5*y look_at 0 }
light_source { <3,5,-10> rgb 1 }
light_source { <-5,2,-3> rgb <0,.3,.6> shadowless }
#default { pigment { rgb <1,.8,.4> } finish { ambient .2 } }
#declare T = transform { rotate 30*z translate .5*x }
#declare Part = box { -1, 1 }
// -- translate
box { -1, 1 translate <1,.5,0> }
// -- rotate
box { -1, 1 rotate <10,20,30> rotate 40*y }
// -- scale
box { -1, 1 scale <1,.5,2> scale .8 }
// -- scale by zero
box { -1, 1 scale <1,0,2> }
// -- scale by a negative number
cone { 0, 1, y, 0 scale <1,-1,1> }
// -- matrix
box { -1, 1 matrix <1,.5,0, 0,1,0, .2,0,1, .3,-.2,0> }
// -- transform
box { -1, 1 transform T } box { -.5, .5 transform { T } translate -2*x }
// -- transform in place
box { -1, 1 transform { rotate 45*y scale .5 translate y } }
// -- inverse
object { Part transform { T inverse } } box { -.3, .3 transform { rotate 30*y inverse translate 2*y } }
// -- transforms of transforms
#declare U = transform { T scale .7 T } object { Part transform U } object { Part transform { U inverse } scale .4 translate -2*y }
// -- rotate by a number
box { -1, 1 rotate 30 }
// -- promotion
box { -1, 1 scale 1.2 translate .2 }
// -- object within object
object { object { Part rotate 45*y } scale .6 translate x }
// -- of unions
union { box { -1, 1 } sphere { 1, .5 } rotate <30,0,20> scale <.7,.9,.7> }
// -- matrix of zeros (parses)
box { -1, 1 matrix <0,0,0, 0,0,0, 0,0,0, 0,0,0> }
// -- matrix that is too short (fails)
box { -1, 1 matrix <1,0,0, 0,1,0, 0,0,1> }
// -- inverse in the middle
box { -.8, .8 transform { rotate 30*y inverse translate y } } box { -.3, .3 transform { translate y inverse rotate 30*z inverse translate <.5,.5,0> } }
