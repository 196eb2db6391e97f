// SPDX-License-Identifier: Apache-2.0
// Constructive solid geometry and what every object may have.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <1.1,2.3,-5> look_at <0,.1,0> angle 45 }
light_source { <3,5,-10> rgb 1 }
light_source { <-5,2,-3> rgb <0,.3,.6> shadowless }
#default { pigment { rgb <1,.8,.4> } finish { ambient .2 } }
#declare A = box { -1, .5 pigment { rgb <1,.3,.3> } }
#declare B = sphere { .3, .9 pigment { rgb <.3,1,.3> } }
// -- union
union { object { A } object { B } }
// -- merge
merge { object { A } object { B } pigment { rgbt <1,1,1,.5> } }
// -- union that one sees through
union { object { A } object { B } pigment { rgbt <1,1,.5,.5> } }
// -- intersection
intersection { object { A } object { B } }
// -- difference
difference { object { A } object { B } }
// -- difference of several
difference { object { A } object { B } cylinder { -2*z, 2*z, .3 } sphere { <-1,.5,-1>, .5 } }
// -- nested
difference { union { object { A } object { B } } intersection { sphere { 0, 1.1 } plane { y, 0 inverse } } cutaway_textures }
// -- cutaway_textures
difference { object { A } sphere { <.3,.3,-.7>, .9 } cutaway_textures }
// -- inverse
intersection { object { A } object { B inverse } }
// -- split_union
union { object { A } object { B } split_union off }
// -- clipped_by
object { A clipped_by { plane { y, 0 } plane { x, .2 } } } sphere { <1.5,0,0>, .7 clipped_by { box { <1,-1,-1>, <1.6,.4,.3> } } }
// -- bounded_by
object { A bounded_by { sphere { 0, 2 } } } object { B bounded_by { clipped_by } clipped_by { box { 0, 2 } } }
// -- bounds that are too small (parses)
sphere { 0, 1 bounded_by { box { -.5, .5 } } }
// -- no_shadow
plane { y, -1 } object { A no_shadow }
// -- no_image
plane { y, -1 finish { reflection .5 } } object { A no_image }
// -- no_reflection
plane { y, -1 finish { reflection .5 } } object { A no_reflection } object { B }
// -- hollow
object { A hollow } object { B hollow off }
// -- double_illuminate
disc { 0, <0,.3,-1>, 1 double_illuminate } disc { <1.5,0,0>, <.5,.2,1>, .7 double_illuminate pigment { rgb 1 } }
// -- sturm and hierarchy
torus { 1, .3 sturm } blob { threshold .5 sphere { 0, 1, 1 } sturm off hierarchy on }
// -- inside texture
sphere { 0, 1 texture { pigment { rgb x } } interior_texture { pigment { rgb y } } clipped_by { plane { z, 0 inverse } } }
// -- material
sphere { 0, 1 material { texture { pigment { rgbt <1,.5,.5,.6> } } interior { ior 1.3 } } } plane { z, 3 pigment { checker rgb 1 rgb z } }
// -- uv_mapping
sphere { 0, 1 pigment { uv_mapping checker rgb 1 rgb x scale .1 } } box { <1,-1,-1>, <2,0,0> texture { uv_mapping pigment { checker rgb 1 rgb y scale .3 } } }
// -- object within
object { union { object { A } object { B } } rotate 30*y pigment { rgb 1 } }
// -- texture of the whole
union { sphere { 0, .7 } box { <.5,-1,-1>, <1.5,0,0> pigment { rgb z } } texture { pigment { rgb <.5,1,.5> } finish { phong 1 } } }
// -- tiles of unions
#for (I, -2, 2) object { B scale .3 translate I*.6*x } #end
// -- empty union
union { } sphere { 0, 1 }
// -- object of one item within a union
union { sphere { 0, 1 } }
// -- bounded twice
object { A bounded_by { sphere { 0, 3 } } bounded_by { box { -2, 2 } } }
// -- radiosity and photons of objects (parses)
object { A no_radiosity photons { target 1 reflection on refraction off collect off pass_through } }
// -- radiosity importance (parses)
sphere { 0, 1 radiosity { importance .5 } }
