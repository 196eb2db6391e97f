// SPDX-License-Identifier: Apache-2.0
// Pigments, their maps and their modifiers.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location <.13,.17,-5> right 4*x up 3*y look_at <.13,.17,0> }
#default { finish { ambient 1 diffuse 0 } }
#declare M = color_map { [0 rgb <1,.9,.1>] [.5 rgb <.1,.2,.6>] [1 rgb <.9,.1,.4>] }
#declare W = pigment { wood color_map { M } turbulence .1 scale .5 }
// -- colour
plane { z, 0 pigment { color rgb <.3,.6,.9> } } sphere { 0, 1 pigment { rgb x } } box { 1, 2 pigment { color red .5 green .25 } }
// -- color_map of many entries
plane { z, 0 pigment { gradient x color_map { [0 rgb x] [.2 rgb y] [.2 rgb z] [.6 color rgb 1] [.8 rgb 0] } rotate 30*z } }
// -- colour_map in the old form
plane { z, 0 pigment { gradient x colour_map { [0, .3 color rgb x color rgb y] [.3, 1 color rgb y color rgb z] } } }
// -- color_map of an identifier
plane { z, 0 pigment { bozo color_map { M } scale .4 } }
// -- color_map within its range
plane { z, 0 pigment { gradient x color_map { [.3 rgb x] [.6 rgb z] } } }
// -- pigment_map
plane { z, 0 pigment { gradient x pigment_map { [0 rgb x] [.5 W] [1 checker rgb 1 rgb 0 scale .2] } scale 2 } }
// -- average
plane { z, 0 pigment { average pigment_map { [1 W] [2 gradient y color_map { M }] [1 rgb z] } } }
// -- pigment lists
plane { z, 0 pigment { checker pigment { W }, pigment { gradient x scale .2 } } } 
// -- checker of default colours
plane { z, 0 pigment { checker scale .3 } }
// -- brick of pigments
plane { z, 0 pigment { brick pigment { rgb .5 }, pigment { W } brick_size <.6,.3,.5> mortar .06 translate <.1,.1,.1> } }
// -- hexagon of default colours
plane { z, 0 pigment { hexagon rotate 90*x scale .5 } }
// -- waves
plane { z, 0 pigment { gradient x color_map { M } triangle_wave scale .8 } }
// -- sine_wave, frequency and phase
plane { z, 0 pigment { gradient x color_map { M } sine_wave frequency 2 phase .3 } }
// -- scallop_wave
plane { z, 0 pigment { gradient y color_map { M } scallop_wave frequency -1.5 } }
// -- cubic_wave
plane { z, 0 pigment { onion color_map { M } cubic_wave } }
// -- poly_wave
plane { z, 0 pigment { onion color_map { M } poly_wave 3 phase .1 } }
// -- ramp_wave
plane { z, 0 pigment { radial color_map { M } ramp_wave frequency 3 rotate 90*x } }
// -- turbulence
plane { z, 0 pigment { gradient x color_map { M } turbulence <.3,.1,0> octaves 4 omega .4 lambda 2.3 } }
// -- turbulence of marble and agate
plane { z, 0 pigment { marble color_map { M } turbulence .7 octaves 3 } } plane { z, 1 pigment { agate agate_turb .5 } }
// -- noise_generator
plane { z, 0 pigment { bozo noise_generator 1 color_map { M } scale .3 } } disc { -.1*z, z, .8 pigment { bozo noise_generator 3 color_map { M } scale .3 } }
// -- transforms
plane { z, 0 pigment { checker rgb 1 rgb x scale <.4,.2,1> rotate 30*z translate <.1,.2,.3> matrix <1,.3,0, 0,1,0, 0,0,1, 0,0,0> } }
// -- transform by name
#declare T = transform { scale .3 rotate 20*z } plane { z, 0 pigment { checker rgb 1 rgb x transform T } }
// -- pigment of an identifier, changed
plane { z, 0 pigment { W scale 2 color_map { [0 rgb x] [1 rgb y] } } }
// -- filter and transmit
plane { z, 0 pigment { checker rgb 1 rgb .2 scale .3 } } disc { -z, z, 1 pigment { rgbf <1,.5,.2,.7> } } disc { <1.5,0,-1>, z, .5 pigment { rgbt <.1,.5,.2,.7> } }
// -- quick_color
plane { z, 0 pigment { checker rgb 1 rgb x quick_color rgb y } }
// -- image_map of a function
plane { z, 0 pigment { image_map { function 8, 8 { x*y } map_type 0 interpolate 2 } scale 2 } }
// -- image_map once
plane { z, 0 pigment { image_map { function 4, 4 { x*.5+.2 } once } } } plane { z, 1 pigment { rgb <0,.3,.3> } }
// -- image_map round a sphere
sphere { 0, 1.4 pigment { image_map { function 8, 8 { x*y+.1 } map_type 1 interpolate 2 } } }
// -- image_map filter all
plane { z, 0 pigment { image_map { function 8, 8 { x } filter all .5 transmit all .3 } } } plane { z, 1 pigment { rgb y } }
// -- image_map on a cylinder and a torus
sphere { 0, 1.4 pigment { image_map { function 8, 8 { x*y+.1 } map_type 2 } } } sphere { <1.5,0,-1>, .7 pigment { image_map { function 8, 8 { x*y+.1 } map_type 5 } translate <1.5,0,0> } }
// -- image_map with no file (fails)
plane { z, 0 pigment { image_map { png "nothing_of_this_name.png" } } }
// -- uv_mapping
sphere { 0, 1.4 pigment { uv_mapping gradient x color_map { M } frequency 4 } }
// -- srgb
plane { z, 0 pigment { gradient x color_map { [0 srgb <.2,.5,.8>] [1 srgbt <.9,.5,.1,.3>] } } } plane { z, 1 pigment { srgb .5 } }
// -- no pigment
plane { z, 0 }
// -- color_map of expressions
#declare C = array[3] { rgb x, rgb y, rgb z }
plane { z, 0 pigment { gradient x color_map { #for (I, 0, 2) [I/2 C[I]] #end } } }
// -- pigment { } that is empty
plane { z, 0 pigment { } } disc { -z, z, 1 pigment { rgb y } }
// -- color_map that is empty (fails)
plane { z, 0 pigment { gradient x color_map { } } }
// -- warp repeat
plane { z, 0 pigment { onion color_map { M } scale .5 warp { repeat x offset <0,.2,0> } warp { repeat .7*y flip <1,1,0> } } }
// -- warp turbulence
plane { z, 0 pigment { gradient x color_map { M } warp { turbulence .3 octaves 3 lambda 2 omega .5 } scale .8 } }
// -- warp black_hole
plane { z, 0 pigment { checker rgb 1 rgb x scale .2 warp { black_hole <.3,.2,0>, .8 strength 1.5 falloff 2 } warp { black_hole <-1,0,0>, .6 inverse } } }
// -- warp black_hole repeated
plane { z, 0 pigment { checker rgb 1 rgb x scale .2 warp { black_hole <.3,.2,0>, .4 strength 1 falloff 1 repeat <1,1,0> } } }
// -- warp spherical, cylindrical and toroidal
plane { z, 0 pigment { checker rgb 1 rgb x scale .1 warp { spherical orientation y dist_exp 1 } } } disc { <1,0,-1>, z, .6 pigment { checker rgb 1 rgb y scale .1 warp { cylindrical orientation z dist_exp 0 } } } disc { <-1,0,-1>, z, .6 pigment { checker rgb 1 rgb z scale .1 warp { toroidal orientation z dist_exp 0 major_radius .3 } } }
// -- warp planar
sphere { 0, 1.3 pigment { checker rgb 1 rgb x scale .2 warp { planar <1,1,-1>, .3 } } }
// -- warp cubic (parses)
sphere { 0, 1.3 pigment { checker rgb 1 rgb x scale .2 warp { cubic } } }
// -- spiral with turbulence
plane { z, 0 pigment { spiral1 4 turbulence .1 color_map { M } } }
// -- blend of pigments by function
plane { z, 0 pigment { function { min(1, max(0, x*x + y*y)) } pigment_map { [0 W] [1 rgb z] } } }
