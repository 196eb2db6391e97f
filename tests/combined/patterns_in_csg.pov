// SPDX-License-Identifier: Apache-2.0
#version 3.7;
global_settings { assumed_gamma 1 }

// Many patterns with warps on the parts of one solid.
camera { location <0, 6, -9> look_at <0, 0, 0> angle 45 }
light_source { <-8, 12, -10> rgb 1 }
#declare Map = color_map { [0 rgb <0.1,0.1,0.4>] [0.4 rgb <0.9,0.5,0.2>] [0.7 rgb <1,1,0.8>] [1 rgb <0.2,0.6,0.3>] }
#macro Tile(I, Pattern) box { 0, <0.95, 0.3, 0.95> pigment { Pattern } translate <mod(I, 6) - 3, 0, div(I, 6) - 2> } #end
union {
  box { 0, <0.95,0.3,0.95> pigment { agate color_map { Map } scale 0.4 } translate <-3,0,-2> }
  box { 0, <0.95,0.3,0.95> pigment { crackle form <-1,1,0> metric 1 color_map { Map } scale 0.2 } translate <-2,0,-2> }
  box { 0, <0.95,0.3,0.95> pigment { spiral1 4 color_map { Map } rotate 90*x translate 0.5 } translate <-1,0,-2> }
  box { 0, <0.95,0.3,0.95> pigment { onion sine_wave frequency 3 color_map { Map } warp { turbulence 0.4 } } translate <0,0,-2> }
  box { 0, <0.95,0.3,0.95> pigment { radial frequency 6 phase 0.3 triangle_wave color_map { Map } translate 0.5*(x + z) } translate <1,0,-2> }
  box { 0, <0.95,0.3,0.95> pigment { waves color_map { Map } scale 0.3 warp { black_hole <0.5,0.3,0.5>, 0.4 falloff 3 strength 0.9 } } translate <2,0,-2> }
  box { 0, <0.95,0.3,0.95> pigment { brick rgb 0.8 rgb <0.7,0.2,0.2> brick_size <0.31,0.11,0.17> mortar 0.02 } translate <-3,0,-1> }
  box { 0, <0.95,0.3,0.95> pigment { marble color_map { Map } warp { repeat 0.3*x flip x } warp { turbulence <0.2,0.3,0.1> octaves 3 lambda 2.5 omega 0.4 } } translate <-2,0,-1> }
  box { 0, <0.95,0.3,0.95> pigment { cylindrical color_map { Map } cubic_wave frequency 3 translate <0.5,0,0.5> } translate <-1,0,-1> }
  box { 0, <0.95,0.3,0.95> pigment { mandel 20 color_map { Map } rotate 90*x scale 0.4 translate <0.6,0,0.5> } translate <0,0,-1> }
  box { 0, <0.95,0.3,0.95> pigment { ripples color_map { Map } scale 0.2 poly_wave 2 } translate <1,0,-1> }
  box { 0, <0.95,0.3,0.95> pigment { wrinkles color_map { Map } scale 0.2 ramp_wave warp { spherical } } translate <2,0,-1> }
  box { 0, <0.95,0.3,0.95> pigment { hexagon rgb 1 rgb <0.3,0.6,1> rgb <1,0.5,0.3> scale 0.15 } translate <-3,0,0> }
  box { 0, <0.95,0.3,0.95> pigment { granite color_map { Map } scale 0.4 noise_generator 1 } translate <-2,0,0> }
  box { 0, <0.95,0.3,0.95> pigment { gradient <1,1,0.4> color_map { Map } scallop_wave scale 0.4 } translate <-1,0,0> }
  box { 0, <0.95,0.3,0.95> pigment { average pigment_map { [1 wood color_map { Map } scale 0.3] [2 leopard color_map { Map } scale 0.1] } } translate <0,0,0> }
  box { 0, <0.95,0.3,0.95> pigment { dents color_map { Map } scale 0.2 } translate <1,0,0> }
  box { 0, <0.95,0.3,0.95> pigment { boxed color_map { Map } scale 0.5 translate <0.5,0.15,0.5> warp { planar z, 0.2 } } translate <2,0,0> }
  translate 0.3*z
}
plane { y, -0.2 pigment { rgb 0.5 } }
