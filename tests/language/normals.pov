// SPDX-License-Identifier: Apache-2.0
// Normals.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <1.1,2.3,-5> look_at <0,.1,0> angle 45 }
light_source { <3,5,-10> rgb 1 }
light_source { <-5,2,-3> rgb <0,.3,.6> shadowless }
#declare S = sphere { 0, 1.2 }
#default { pigment { rgb <1,.8,.4> } finish { ambient .2 specular .3 } }
// -- bumps .6 scale .2
object { S normal { bumps .6 scale .2 } }
// -- dents .6 scale .2
object { S normal { dents .6 scale .2 } }
// -- ripples .4 scale .2
object { S normal { ripples .4 scale .2 } }
// -- waves .4 scale .2
object { S normal { waves .4 scale .2 } }
// -- wrinkles .6 scale .3
object { S normal { wrinkles .6 scale .3 } }
// -- bumps scale .3
object { S normal { bumps scale .3 } }
// -- gradient x, .5 scale .3 sine_wave
object { S normal { gradient x, .5 scale .3 sine_wave } }
// -- marble .5 turbulence .3 scale .2
object { S normal { marble .5 turbulence .3 scale .2 } }
// -- agate .5 scale .3
object { S normal { agate .5 scale .3 } }
// -- granite .3 scale .5
object { S normal { granite .3 scale .5 } }
// -- onion .5 frequency 3
object { S normal { onion .5 frequency 3 } }
// -- wood .5 scale .3
object { S normal { wood .5 scale .3 } }
// -- quilted .7 control0 .4 control1 .8 scale .3
object { S normal { quilted .7 control0 .4 control1 .8 scale .3 } }
// -- checker .5 scale .3
object { S normal { checker .5 scale .3 } }
// -- brick .5 scale .1
object { S normal { brick .5 scale .1 } }
// -- hexagon .5 scale .3
object { S normal { hexagon .5 scale .3 } }
// -- spiral1 3, .5 scale .4
object { S normal { spiral1 3, .5 scale .4 } }
// -- leopard .5 scale .1
object { S normal { leopard .5 scale .1 } }
// -- crackle .7 scale .3
object { S normal { crackle .7 scale .3 } }
// -- radial .5 frequency 8
object { S normal { radial .5 frequency 8 } }
// -- function { sin(9*x) } .4
object { S normal { function { sin(9*x) } .4 } }
// -- bumps .5 bump_size 1.2 scale .3
object { S normal { bumps .5 bump_size 1.2 scale .3 } }
// -- bumps .6 accuracy .001 scale .2
object { S normal { bumps .6 accuracy .001 scale .2 } }
// -- bumps .5 no_bump_scale scale <.2,.4,.2>
object { S normal { bumps .5 no_bump_scale scale <.2,.4,.2> } }
// -- gradient x .6 slope_map { [0 <0,1>] [.5 <1,1>] [.5 <1,-1>] [1 <0,-1>] } scale .4
object { S normal { gradient x .6 slope_map { [0 <0,1>] [.5 <1,1>] [.5 <1,-1>] [1 <0,-1>] } scale .4 } }
// -- gradient y normal_map { [0 bumps .5 scale .2] [.5 ripples .3 scale .1] [1 dents 1 scale .2] } scale 1.5
object { S normal { gradient y normal_map { [0 bumps .5 scale .2] [.5 ripples .3 scale .1] [1 dents 1 scale .2] } scale 1.5 } }
// -- average normal_map { [1 bumps .5 scale .2] [2 ripples .3 scale .2] }
object { S normal { average normal_map { [1 bumps .5 scale .2] [2 ripples .3 scale .2] } } }
// -- checker normal { bumps .6 scale .1 }, normal { ripples .3 scale .1 } scale .5
object { S normal { checker normal { bumps .6 scale .1 }, normal { ripples .3 scale .1 } scale .5 } }
// -- bump_map { function 8, 8 { x*y } bump_size 3 interpolate 2 } scale .5
object { S normal { bump_map { function 8, 8 { x*y } bump_size 3 interpolate 2 } scale .5 } }
// -- facets coords .4 scale 1 (parses)
object { S normal { facets coords .4 scale 1 } }
// -- pigment_pattern { bozo color_map { [0 rgb 0] [1 rgb 1] } } .5 scale .3
object { S normal { pigment_pattern { bozo color_map { [0 rgb 0] [1 rgb 1] } } .5 scale .3 } }
// -- image_pattern { function 8, 8 { x*x } } .5
object { S normal { image_pattern { function 8, 8 { x*x } } .5 } }
// -- bozo .5 poly_wave 2 scale .3
object { S normal { bozo .5 poly_wave 2 scale .3 } }
// -- cells .5 scale .3
object { S normal { cells .5 scale .3 } }
// -- wrinkles -.5 turbulence .3 octaves 2 scale .4
object { S normal { wrinkles -.5 turbulence .3 octaves 2 scale .4 } }
// -- mandel 20, .5
object { S normal { mandel 20, .5 } }
// -- cylindrical .7 frequency 3
object { S normal { cylindrical .7 frequency 3 } }
// -- slope y, .5
object { S normal { slope y, .5 } }
