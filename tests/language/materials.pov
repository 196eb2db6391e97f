// SPDX-License-Identifier: Apache-2.0
// Textures, interiors and materials.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <1.1,2.3,-5> look_at <0,.1,0> angle 45 }
light_source { <3,5,-10> rgb 1 }
light_source { <-5,2,-3> rgb <0,.3,.6> shadowless }
#declare S = sphere { 0, 1.2 }
#default { pigment { rgb <1,.6,.3> } finish { ambient .2 } }
#declare Floor = plane { y, -1.2 pigment { checker rgb 1 rgb .3 } }
#declare R = texture { pigment { rgb x } finish { phong 1 } }
#declare G = texture { pigment { gradient y color_map { [0 rgb y] [1 rgb 1] } scale .3 } }
// -- layers
object { S texture { pigment { rgb <.2,.4,1> } } texture { pigment { bozo color_map { [0 rgbt 1] [.5 rgbt <1,1,0,.3>] [1 rgbf <1,0,0,.5>] } scale .4 } finish { phong .5 } } }
// -- layers of an identifier
#declare L = texture { R } texture { pigment { checker rgbt 1 rgb z scale .3 } } object { S texture { L } }
// -- texture_map
object { S texture { gradient x texture_map { [.2 R] [.6 G] [.8 pigment { rgb z }] } translate .5 } }
// -- texture lists
object { S texture { checker texture { R }, texture { G } scale .4 } }
// -- average of textures
object { S texture { average texture_map { [1 R] [2 G] } } }
// -- tiles
object { S texture { tiles { texture { R } tile2 texture { G } } scale .4 } }
// -- material_map
object { S texture { material_map { function 4, 4 { x } texture { R } texture { G } } } }
// -- transforms of textures
object { S texture { G rotate 50*z scale <.5,2,1> translate .1 } } object { S scale .5 translate <1.2,1,-1> texture { G } rotate 10*z }
// -- pigment, normal and finish of an object
object { S pigment { rgb y } normal { bumps .4 scale .2 } finish { specular .5 } }
// -- interior_texture
object { S clipped_by { plane { y, .4 } } texture { R } interior_texture { G } }
// -- ior
object { Floor } object { S pigment { rgbt <1,1,1,.9> } interior { ior 1.5 } }
// -- interior of an identifier
#declare I = interior { ior 1.2 caustics 1 } object { Floor } object { S pigment { rgbf <1,.8,.8,.9> } interior { I } }
// -- fading
object { Floor } object { S pigment { rgbt <1,1,1,1> } interior { ior 1.1 fade_distance .6 fade_power 1 fade_color <.9,.3,.2> } }
// -- fading by 1001
object { Floor } object { S pigment { rgbt <1,1,1,1> } interior { fade_distance .6 fade_power 1001 fade_colour rgb <.2,.9,.2> } }
// -- caustics
object { Floor } object { S pigment { rgbf <1,1,1,.8> } interior { ior 1.4 caustics .7 } }
// -- refraction in the old form
object { Floor } object { S pigment { rgbf <1,1,1,.8> } interior { ior 1.4 } finish { reflection .1 } }
// -- dispersion (parses)
object { S pigment { rgbf 1 } interior { ior 1.4 dispersion 1.02 dispersion_samples 9 } }
// -- media (parses)
object { S pigment { rgbt 1 } hollow interior { media { emission .3 absorption <.1,.2,.3> scattering { 5, rgb .3 eccentricity .2 extinction .5 } method 3 intervals 2 samples 4, 8 confidence .9 variance 1/200 ratio .8 jitter .2 aa_level 3 aa_threshold .1 density { spherical color_map { [0 rgb 0] [1 rgb 1] } density_map { [0 rgb 0] [1 bozo] } } } } }
// -- media of an identifier (parses)
#declare M = media { emission 1 } #declare D = density { spherical } object { S pigment { rgbt 1 } hollow interior { media { M density { D scale .5 } density { wood } } } }
// -- material with transforms
#declare M = material { texture { G } interior { ior 1.2 } } object { S material { M scale .5 rotate 30*z } }
// -- material and more
object { S material { texture { R } } finish { phong .2 } }
// -- texture of nothing
object { S texture { } }
// -- finish within a texture map
object { S texture { gradient y texture_map { [0 pigment { rgb 1 } finish { ambient 1 }] [1 pigment { rgb x } normal { bumps 1 scale .1 }] } } }
