// SPDX-License-Identifier: Apache-2.0
// Light sources.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0,4,-7> look_at <0,.3,0> angle 45 }
#default { finish { ambient .05 } }
plane { y, -1 pigment { rgb <.9,.9,.9> } }
sphere { <-1.2,0,0>, 1 pigment { rgb <1,.5,.3> } }
box { <.5,-1,-.5>, <1.5,.5,.5> pigment { rgb <.3,.5,1> } }
#declare L = <-3,5,-4>;
// -- point
light_source { L color rgb <1,.9,.8> }
// -- without the keyword
light_source { L, 1 } light_source { <5,5,-5> <.1,.2,.3> }
// -- shadowless
light_source { L rgb 1 shadowless }
// -- spotlight
light_source { L rgb 1 spotlight radius 10 falloff 20 tightness 2 point_at <-1,0,0> }
// -- spotlight by default
light_source { L rgb 1 spotlight point_at 0 }
// -- spotlight with falloff alone
light_source { L rgb 1 spotlight falloff 25 point_at 0 }
// -- spotlight with radius alone
light_source { L rgb 1 spotlight radius 15 point_at 0 }
// -- cylinder
light_source { L rgb 1 cylinder radius 1 falloff 2 tightness 1 point_at 0 }
// -- parallel
light_source { L rgb 1 parallel point_at <0,0,0> }
// -- parallel spotlight
light_source { L rgb 1 spotlight parallel radius 15 falloff 25 point_at 0 }
// -- area_light
light_source { L rgb 1 area_light 2*x, 2*y, 3, 3 }
// -- area_light of one lamp
light_source { L rgb 1 area_light 2*x, 2*y, 1, 1 }
// -- area_light circular and orient (parses)
light_source { L rgb 1 area_light 2*x, 2*y, 5, 5 circular orient }
// -- area_light adaptive
light_source { L rgb 1 area_light 2*x, 2*y, 5, 5 adaptive 1 }
// -- area_illumination (parses)
light_source { L rgb 1 area_light 4*x, 4*y, 4, 4 area_illumination on }
// -- jitter (parses)
light_source { L rgb 1 area_light 2*x, 2*y, 3, 3 jitter }
// -- area spotlight
light_source { L rgb 1 spotlight radius 15 falloff 25 point_at 0 area_light x, y, 3, 3 adaptive 0 }
// -- fading
light_source { L rgb 2 fade_distance 4 fade_power 2 }
// -- fading by a power of 1
light_source { L rgb 1 fade_distance 6 fade_power 1 }
// -- fading by other powers
light_source { L rgb 1 fade_distance 6 fade_power 1.5 } light_source { <4,3,-3> rgb .5 fade_distance 2 fade_power 3 }
// -- fading by 1000
light_source { L rgb 1 fade_distance 6 fade_power 1000 }
// -- looks_like
light_source { <0,1.5,-1> rgb 1 looks_like { sphere { 0, .3 pigment { rgb <1,1,0> } finish { ambient 1 } } } }
// -- projected_through
light_source { L rgb 1 projected_through { disc { <-1.5,2.5,-2>, y, .8 } } }
// -- transformed
light_source { 0 rgb 1 translate <3,5,-4> rotate 20*y } 
// -- transformed spotlight
light_source { 0 rgb 1 spotlight point_at <0,-1,0> radius 20 falloff 30 translate <0,5,0> }
// -- of an identifier
#declare S = light_source { L rgb 1 } light_source { S translate 3*x } object { S rotate 90*y }
// -- light groups
light_group { light_source { L rgb 1 } sphere { <0,1,-1>, .4 pigment { rgb y } } global_lights off } light_source { <4,3,-3> rgb <.3,.3,.6> }
// -- light groups with global lights
light_group { light_source { L rgb 1 } sphere { <0,1,-1>, .4 pigment { rgb y } } global_lights } light_source { <4,3,-3> rgb <.3,.3,.6> }
// -- transformed light groups
light_group { light_source { L rgb 1 } sphere { <0,1,-1>, .4 pigment { rgb y } } translate x rotate 20*y } light_source { <4,3,-3> rgb <.3,.3,.6> }
// -- media flags
light_source { L rgb 1 media_interaction off media_attenuation on }
// -- negative light
light_source { L rgb 1 } light_source { <4,3,-3> rgb -.3 shadowless }
// -- none
// -- photons of a light (parses)
light_source { L rgb 1 photons { reflection on refraction off } }
// -- adaptive of a point light
light_source { L rgb 1 adaptive 1 }
