// SPDX-License-Identifier: Apache-2.0
// Patterns.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location <.13,.17,-5> right 4*x up 3*y look_at <.13,.17,0> }
#default { finish { ambient 1 diffuse 0 } }
#declare M = color_map { [0 rgb <1,.9,.1>] [.5 rgb <.1,.2,.6>] [1 rgb <.9,.1,.4>] }
#declare At = transform { scale .73 rotate <31,17,9> translate .211 }
// -- agate
plane { z, 0 pigment { agate color_map { M } transform At } }
// -- agate agate_turb .4
plane { z, 0 pigment { agate agate_turb .4 color_map { M } transform At } }
// -- boxed
plane { z, 0 pigment { boxed color_map { M } transform At } }
// -- bozo
plane { z, 0 pigment { bozo color_map { M } transform At } }
// -- bumps
plane { z, 0 pigment { bumps color_map { M } transform At } }
// -- cells
plane { z, 0 pigment { cells color_map { M } transform At } }
// -- crackle
plane { z, 0 pigment { crackle color_map { M } transform At } }
// -- crackle form <-1,1,0> metric 1
plane { z, 0 pigment { crackle form <-1,1,0> metric 1 color_map { M } transform At } }
// -- crackle solid offset .3
plane { z, 0 pigment { crackle solid offset .3 color_map { M } transform At } }
// -- crackle form <.5,.5,0> metric 3
plane { z, 0 pigment { crackle form <.5,.5,0> metric 3 color_map { M } transform At } }
// -- cylindrical
plane { z, 0 pigment { cylindrical color_map { M } transform At } }
// -- dents
plane { z, 0 pigment { dents color_map { M } transform At } }
// -- gradient <1,2,3>
plane { z, 0 pigment { gradient <1,2,3> color_map { M } transform At } }
// -- gradient y
plane { z, 0 pigment { gradient y color_map { M } transform At } }
// -- granite
plane { z, 0 pigment { granite color_map { M } transform At } }
// -- julia <.353,.288>, 30
plane { z, 0 pigment { julia <.353,.288>, 30 color_map { M } rotate 3*z } }
// -- julia <.353,.288>, 30 exponent 3 interior 1, 2 exterior 2, .5
plane { z, 0 pigment { julia <.353,.288>, 30 exponent 3 interior 1, 2 exterior 2, .5 color_map { M } rotate 3*z } }
// -- leopard
plane { z, 0 pigment { leopard color_map { M } transform At } }
// -- magnet 1 mandel 20
plane { z, 0 pigment { magnet 1 mandel 20 color_map { M } rotate 3*z } }
// -- magnet 2 julia <.4,.3>, 20
plane { z, 0 pigment { magnet 2 julia <.4,.3>, 20 color_map { M } rotate 3*z } }
// -- mandel 50
plane { z, 0 pigment { mandel 50 color_map { M } rotate 3*z } }
// -- mandel 20 exponent 4 exterior 1, 10 interior 2, 1
plane { z, 0 pigment { mandel 20 exponent 4 exterior 1, 10 interior 2, 1 color_map { M } rotate 3*z } }
// -- marble
plane { z, 0 pigment { marble color_map { M } transform At } }
// -- marble turbulence .5
plane { z, 0 pigment { marble turbulence .5 color_map { M } transform At } }
// -- onion
plane { z, 0 pigment { onion color_map { M } transform At } }
// -- planar
plane { z, 0 pigment { planar color_map { M } transform At } }
// -- quilted control0 .3 control1 .7
plane { z, 0 pigment { quilted control0 .3 control1 .7 color_map { M } transform At } }
// -- radial
plane { z, 0 pigment { radial color_map { M } transform At } }
// -- radial frequency 6
plane { z, 0 pigment { radial frequency 6 color_map { M } transform At } }
// -- ripples
plane { z, 0 pigment { ripples color_map { M } transform At } }
// -- spherical
plane { z, 0 pigment { spherical color_map { M } transform At } }
// -- spiral1 3
plane { z, 0 pigment { spiral1 3 color_map { M } transform At } }
// -- spiral2 4
plane { z, 0 pigment { spiral2 4 color_map { M } transform At } }
// -- spotted
plane { z, 0 pigment { spotted color_map { M } transform At } }
// -- waves
plane { z, 0 pigment { waves color_map { M } transform At } }
// -- wood
plane { z, 0 pigment { wood color_map { M } transform At } }
// -- wood turbulence .2 octaves 4 omega .6 lambda 1.9
plane { z, 0 pigment { wood turbulence .2 octaves 4 omega .6 lambda 1.9 color_map { M } transform At } }
// -- wrinkles
plane { z, 0 pigment { wrinkles color_map { M } transform At } }
// -- pavement
plane { z, 0 pigment { pavement color_map { M } rotate 90*x scale .4 } }
// -- function { x*x + sin(3*y) }
plane { z, 0 pigment { function { x*x + sin(3*y) } color_map { M } transform At } }
// -- pigment_pattern { bozo color_map { [0 rgb 0][1 rgb <1,.5,.2>] } }
plane { z, 0 pigment { pigment_pattern { bozo color_map { [0 rgb 0][1 rgb <1,.5,.2>] } } color_map { M } transform At } }
// -- slope <0,1,-.5>
sphere { 0, 1.4 pigment { slope <0,1,-.5> color_map { M } } }
// -- slope { <0,1,-.5>, 0, 1 altitude y, -1, 1 }
sphere { 0, 1.4 pigment { slope { <0,1,-.5>, 0, 1 altitude y, -1, 1 } color_map { M } } }
// -- aoi
sphere { 0, 1.4 pigment { aoi color_map { M } } }
// -- object { sphere { 0, 1 } color rgb 1, color rgb x }
plane { z, 0 pigment { object { sphere { 0, 1 } rgb 1, rgb x } transform At } }
// -- image_pattern { function 8, 8 { x + y } }
plane { z, 0 pigment { image_pattern { function 8, 8 { x + y } } color_map { M } transform At } }
// -- cubic
plane { z, 0 pigment { cubic rgb 1, rgb x, rgb y, rgb z, rgb .5, rgb <1,1,0> transform At } }
// -- checker
plane { z, 0 pigment { checker rgb 1, rgb x transform At } } 
// -- hexagon
plane { z, 0 pigment { hexagon rgb 1, rgb x, rgb y rotate 90*x transform At } }
// -- brick
plane { z, 0 pigment { brick rgb 1, rgb x brick_size <.8,.3,.4> mortar .05 transform At } }
// -- square
plane { z, 0 pigment { square rgb 1, rgb x, rgb y, rgb z rotate 90*x transform At } }
// -- triangular
plane { z, 0 pigment { triangular rgb 1, rgb x, rgb y, rgb z, rgb .5, rgb <1,1,0> rotate 90*x transform At } }
// -- facets coords .5 (parses)
sphere { 0, 1.3 pigment { rgb 1 } normal { facets coords .5 } finish { ambient 0 diffuse 1 } } light_source { <3,5,-10>, 1 }
// -- tiling 1 (parses)
plane { z, 0 pigment { tiling 1 color_map { M } rotate 90*x scale .4 } }
// -- tiling 7 (parses)
plane { z, 0 pigment { tiling 7 color_map { M } rotate 90*x scale .4 } }
// -- density_file df3 tiny.df3
plane { z, 0 pigment { density_file df3 "tiny.df3" color_map { M } transform At } }
