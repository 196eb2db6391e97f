// SPDX-License-Identifier: Apache-2.0
// Finishes.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <1.1,2.3,-5> look_at <0,.1,0> angle 45 }
light_source { <3,5,-10> rgb 1 }
light_source { <-5,2,-3> rgb <0,.3,.6> shadowless }
#declare S = sphere { 0, 1.2 }
#default { pigment { rgb <1,.6,.3> } }
plane { y, -1.2 pigment { checker rgb 1 rgb .3 } }
// -- ambient .3
object { S finish { ambient .3 } }
// -- ambient rgb <.1,.2,.5>
object { S finish { ambient rgb <.1,.2,.5> } }
// -- emission .4
object { S finish { emission .4 } }
// -- emission rgb <.1,.4,0>
object { S finish { emission rgb <.1,.4,0> } }
// -- diffuse .3
object { S finish { diffuse .3 } }
// -- diffuse .6, .3
object { S finish { diffuse .6, .3 } }
// -- diffuse albedo .6
object { S finish { diffuse albedo .6 } }
// -- brilliance 3
object { S finish { brilliance 3 } }
// -- phong 1
object { S finish { phong 1 } }
// -- phong .8 phong_size 10
object { S finish { phong .8 phong_size 10 } }
// -- phong albedo .5 phong_size 20
object { S finish { phong albedo .5 phong_size 20 } }
// -- specular .8
object { S finish { specular .8 } }
// -- specular .8 roughness .01
object { S finish { specular .8 roughness .01 } }
// -- specular albedo .5 roughness .05
object { S finish { specular albedo .5 roughness .05 } }
// -- specular 1 metallic
object { S finish { specular 1 metallic } }
// -- phong 1 metallic .5
object { S finish { phong 1 metallic .5 } }
// -- specular .5 roughness 0
object { S finish { specular .5 roughness 0 } }
// -- reflection .5
object { S finish { reflection .5 } }
// -- reflection rgb <.7,.5,.2>
object { S finish { reflection rgb <.7,.5,.2> } }
// -- reflection { .1, .8 }
object { S finish { reflection { .1, .8 } } }
// -- reflection { rgb <.1,.2,.1>, rgb 1 falloff 3 }
object { S finish { reflection { rgb <.1,.2,.1>, rgb 1 falloff 3 } } }
// -- reflection { .1, .9 fresnel on }
object { S finish { reflection { .1, .9 fresnel on } } interior { ior 1.4 } }
// -- reflection { .6 exponent .5 }
object { S finish { reflection { .6 exponent .5 } } }
// -- reflection { .6 metallic }
object { S finish { reflection { .6 metallic } } }
// -- reflection { 0, .6 metallic .5 } conserve_energy
object { S finish { reflection { 0, .6 metallic .5 } conserve_energy } }
// -- reflection .4 reflection_exponent 2
object { S finish { reflection .4 reflection_exponent 2 } }
// -- conserve_energy reflection .5
object { S finish { conserve_energy reflection .5 } }
// -- use_alpha (fails)
object { S finish { use_alpha on } }
// -- ambient 0 diffuse 0
object { S finish { ambient 0 diffuse 0 } }
// -- crand 0
object { S finish { crand 0 } }
// -- diffuse 1 ambient 0 brilliance .5
object { S finish { diffuse 1 ambient 0 brilliance .5 } }
// -- specular 2 diffuse 1.5
object { S finish { specular 2 diffuse 1.5 } }
// -- irid (parses)
object { S finish { irid { .35 thickness .5 turbulence .3 } } }
// -- subsurface (parses)
object { S finish { subsurface { translucency <.3,.2,.1> } } }
// -- finish of an identifier
#declare F = finish { phong 1 diffuse .5 } object { S finish { F ambient .4 } }
// -- default finish
object { S }
// -- crand (parses)
object { S finish { crand .2 } }
// -- finish with a reserved word that is none (fails)
object { S finish { shininess 3 } }
