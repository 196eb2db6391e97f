// SPDX-License-Identifier: Apache-2.0
// Shapes.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <1.1,2.3,-5> look_at <0,.1,0> angle 45 }
light_source { <3,5,-10> rgb 1 }
light_source { <-5,2,-3> rgb <0,.3,.6> shadowless }
#default { pigment { rgb <1,.8,.4> } finish { ambient .2 } }
// -- sphere
sphere { <.2,0,0>, 1.2 }
// -- box
box { <-1,-.5,-1>, <1,.7,1> } box { <2,1,1>, <1.5,0,.4> }
// -- cylinder
cylinder { -y, y, .7 } cylinder { <1,-1,0>, <2,1,1>, .3 open }
// -- cone
cone { -y, 1, y, .3 } cone { <1.5,-1,0>, .5, <1.5,.5,0>, 0 open rotate 20*z }
// -- torus
torus { 1, .35 rotate 20*x }
// -- plane
plane { y, -1 } plane { <1,0,1>, 3 pigment { rgb x } }
// -- plane of an unscaled normal
plane { 2*y, -1 }
// -- disc
disc { 0, y+z*-.5, 1.5 } disc { <0,.5,0>, y-z, 1, .5 pigment { rgb x } }
// -- triangle
triangle { <-1,-1,0>, <1,-1,0>, <0,1,.5> } triangle { <1,0,0>, <2,0,0>, <1.5,1,0> }
// -- smooth_triangle
smooth_triangle { <-1,-1,0>, <-1,0,-1>, <1,-1,0>, <1,0,-1>, <0,1,.5>, <0,1,-1> }
// -- polygon
polygon { 5, <-1,-1>, <1,-1>, <1,1>, <-1,1>, <-1,-1> } polygon { 8, <0,0,-1>, <.5,0,-1>, <.5,.5,-1>, <0,0,-1>, <.1,.1,-1>, <.3,.1,-1>, <.3,.2,-1>, <.1,.1,-1> pigment { rgb x } }
// -- quadric
quadric { <1,.5,1>, <0,.1,0>, <.2,0,0>, -1 }
// -- cubic
cubic { < 1,0,0,0, 0,0,0,0,0,0, 1,0,0,0, 0,0, 1,0, 0, -1 > bounded_by { sphere { 0, 2 } } clipped_by { bounded_by } }
// -- quartic
quartic { <1,0,0,0,2,0,0,2,0,-2.5, 0,0,0,0,0,0,0,0,0,0, 1,0,0,2,0,1.5,0,0,0,0, 1,0,-2.5,0,.5625> sturm bounded_by { sphere { 0, 2 } } }
// -- poly
poly { 2, <1,0,0,0,2,0,0,1,0,-1> } poly { 3, <1,0,0,0, 0,0,0,0,0,0, 1,0,0,0, 0,0, 1,0, 0, -1> translate 2*x sturm clipped_by { box { -1, 2.5 } } }
// -- polynomial
polynomial { 2, xyz(2,0,0): 1, xyz(0,2,0): 2, xyz(0,0,2): 1, xyz(0,0,0): -1 }
// -- superellipsoid
superellipsoid { <.4,.6> }
// -- superellipsoids of other exponents
superellipsoid { <1.5,.3> scale .7 translate -x } superellipsoid { <.2,2> scale .7 translate x }
// -- blob
blob { threshold .5 sphere { <-.5,0,0>, 1.2, 1 } sphere { <.7,.2,0>, 1, strength 1.2 } cylinder { <0,-1,0>, <0,1,0>, .6, .8 } hierarchy off sturm }
// -- blob of textures
blob { threshold .5 sphere { <-.5,0,0>, 1.2, 1 pigment { rgb x } } sphere { <.7,.2,0>, 1, 1.2 pigment { rgb y } scale <1,1.3,1> } component .8, 1, <0,-1,0> }
// -- lathe
lathe { linear_spline 5, <0,-1>, <1,-1>, <.5,0>, <.9,.8>, <0,1> }
// -- lathe of a quadratic spline
lathe { quadratic_spline 6, <0,-1.4>, <.5,-1>, <1,-.5>, <.5,0>, <.9,.8>, <.2,1> }
// -- lathe of a cubic spline
lathe { cubic_spline 7, <0,-1.4>, <.5,-1>, <1,-.5>, <.5,0>, <.9,.8>, <.2,1>, <0,1.2> sturm }
// -- lathe of a bezier spline
lathe { bezier_spline 4, <.2,-1>, <1.5,-.7>, <.2,.5>, <.8,1> }
// -- sor
sor { 6, <0,-1.3>, <.5,-1>, <1,-.5>, <.5,.2>, <.8,.8>, <.2,1.2> }
// -- open sor
sor { 6, <0,-1.3>, <.5,-1>, <1,-.5>, <.5,.2>, <.8,.8>, <.2,1.2> open sturm }
// -- prism
prism { -.5, .5, 5, <-1,-1>, <1,-1>, <.7,1>, <-.5,.8>, <-1,-1> }
// -- prism of two curves
prism { linear_sweep linear_spline -.5, .5, 8, <-1,-1>, <1,-1>, <0,1>, <-1,-1>, <-.3,-.6>, <.3,-.6>, <0,.2>, <-.3,-.6> open }
// -- prism swept to a point
prism { conic_sweep linear_spline 0, 1, 5, <-1,-1>, <1,-1>, <1,1>, <-1,1>, <-1,-1> scale <1,-1.5,1> translate y }
// -- prism of a quadratic spline
prism { quadratic_spline -.4, .4, 7, <-1,0>, <-1,-1>, <1,-1>, <1.2,0>, <.8,1>, <-.5,.8>, <-1,-1> sturm }
// -- prism of a cubic spline
prism { cubic_spline -.4, .4, 7, <-1,1>, <-1,-1>, <1,-1>, <.8,1>, <-1,1>, <-1,-1>, <1,-1> }
// -- prism of a bezier spline
prism { bezier_spline -.4, .4, 8, <-1,-1>, <-.5,-2>, <.5,0>, <1,-1>, <1,-1>, <1.5,1>, <-1.5,1>, <-1,-1> }
// -- sphere_sweep
sphere_sweep { linear_spline 3, <-1,-1,0>, .3, <0,.5,0>, .5, <1,-.5,-1>, .2 }
// -- sphere_sweep of a b_spline
sphere_sweep { b_spline 5, <-2,-1,0>, .3, <-1,.5,0>, .5, <0,.2,0>, .3, <1,-.5,-1>, .3, <2,2,0>, .4 tolerance 1e-4 }
// -- sphere_sweep of a cubic spline
sphere_sweep { cubic_spline 5, <-2,-1,0>, .3, <-1,.5,0>, .5, <0,.2,0>, .3, <1,-.5,-1>, .3, <2,2,0>, .4 }
// -- bicubic_patch
bicubic_patch { type 1 flatness .01 u_steps 4 v_steps 4 <-1,0,-1>, <-.3,.7,-1>, <.3,0,-1>, <1,.3,-1>, <-1,.3,-.3>, <-.3,1,-.3>, <.3,0,-.3>, <1,0,-.3>, <-1,0,.3>, <-.3,0,.3>, <.3,.8,.3>, <1,0,.3>, <-1,.5,1>, <-.3,0,1>, <.3,0,1>, <1,.6,1> }
// -- bicubic_patch of type 0
bicubic_patch { type 0 flatness 0 u_steps 3 v_steps 3 <-1,0,-1>, <-.3,.7,-1>, <.3,0,-1>, <1,.3,-1>, <-1,.3,-.3>, <-.3,1,-.3>, <.3,0,-.3>, <1,0,-.3>, <-1,0,.3>, <-.3,0,.3>, <.3,.8,.3>, <1,0,.3>, <-1,.5,1>, <-.3,0,1>, <.3,0,1>, <1,.6,1> }
// -- mesh
mesh { triangle { <-1,-1,0>, <1,-1,0>, <0,1,0> } smooth_triangle { <1,-1,0>, <0,0,-1>, <2,0,0>, <1,0,-1>, <0,1,0>, <0,1,-1> } inside_vector z }
// -- mesh of textures
#declare R = texture { pigment { rgb x } } #declare G = texture { pigment { rgb y } }
mesh { triangle { <-1,-1,0>, <1,-1,0>, <0,1,0> texture { R } } triangle { <1,-1,0>, <2,0,0>, <0,1,0> texture_list { R G R } } hierarchy off }
// -- mesh2
mesh2 { vertex_vectors { 4, <-1,-1,0>, <1,-1,0>, <1,1,.5>, <-1,1,0> } face_indices { 2, <0,1,2>, <0,2,3> } }
// -- mesh2 of normals, textures and mapping
mesh2 { vertex_vectors { 4, <-1,-1,0>, <1,-1,0>, <1,1,.5>, <-1,1,0> } normal_vectors { 4, <-1,0,-1>, <1,0,-1>, <1,1,-1>, <-1,1,-1> } uv_vectors { 4, <0,0>, <1,0>, <1,1>, <0,1> }
texture_list { 2, texture { uv_mapping pigment { checker rgb 1 rgb x scale .25 } } texture { pigment { rgb y } } } face_indices { 2, <0,1,2>, 0, <0,2,3>, 1, 0, 0 } normal_indices { 2, <0,1,2>, <0,2,3> } uv_indices { 2, <0,1,2>, <0,2,3> } inside_vector z }
// -- height_field of a function
height_field { function 20, 20 { pattern { bumps scale .2 } } translate <-.5,0,-.5> scale <3,1,3> }
// -- smooth height_field
height_field { function 16, 16 { x*x*.5 + y*.3 } smooth water_level .1 translate -.5 scale <3,1,3> }
// -- isosurface
isosurface { function { x*x + y*y*2 + z*z - 1 } contained_by { box { -1.5, 1.5 } } max_gradient 6 accuracy .0001 threshold 0 open }
// -- isosurface in a sphere
isosurface { function { sqrt(x*x + y*y + z*z) - .9 + .1*sin(9*x) } contained_by { sphere { 0, 1.2 } } max_gradient 2.5 all_intersections }
// -- evaluated isosurface
isosurface { function { x*x + y*y + z*z*z*z - 1 } contained_by { box { -1.5, 1.5 } } evaluate 1, 1.2, .99 max_trace 3 }
// -- parametric
parametric { function { sin(u)*cos(v) }, function { sin(u)*sin(v) }, function { cos(u) } <0,0>, <pi,2*pi> contained_by { box { -1.1, 1.1 } } max_gradient 1.5 accuracy .001 precompute 8 x, y, z }
// -- julia_fractal
julia_fractal { <-.083,0,-.83,-.025> quaternion sqr max_iteration 6 precision 20 }
// -- hypercomplex julia_fractal (parses)
julia_fractal { <-.6,.2,.1,0> hypercomplex exp max_iteration 4 precision 20 slice <0,0,0,1>, .1 }
// -- ovus
ovus { 1, .6 } ovus { .6, .9 translate 1.7*x }
// -- text (parses)
text { ttf "timrom.ttf" "Ab" .3, .1*x }
// -- inside_vector and intersection
intersection { mesh { triangle { <-1,-1,-1>, <1,-1,-1>, <0,1,0> } triangle { <-1,-1,-1>, <0,-1,1>, <0,1,0> } triangle { <1,-1,-1>, <0,-1,1>, <0,1,0> } triangle { <-1,-1,-1>, <1,-1,-1>, <0,-1,1> } inside_vector <.1,1,.2> } sphere { 0, .9 } }
