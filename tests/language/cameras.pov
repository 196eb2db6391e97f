// SPDX-License-Identifier: Apache-2.0
// Cameras.
#version 3.7;
global_settings { assumed_gamma 1 }
light_source { <3,5,-10> rgb 1 }
background { rgb <.1,.2,.4> }
#default { finish { ambient .3 } }
plane { y, -1 pigment { checker rgb 1 rgb <.2,.6,.2> } }
sphere { 0, 1 pigment { gradient y color_map { [0 rgb x] [1 rgb <1,1,0>] } } }
box { -1, 1 translate <2.5,0,2> pigment { rgb <0,.4,1> } }
// -- none
// -- perspective
camera { perspective location <1,1,-5> look_at <.5,0,0> angle 50 }
// -- right, up and direction
camera { location <.1,1,-6> right 1.2*x up y direction 1.43*z }
// -- right
camera { location <0,1,-6> right -1.33*x look_at 0 }
// -- angle after look_at
camera { location <0,1,-6> look_at x angle 40 }
// -- angle before look_at
camera { location <0,1,-6> angle 40 look_at x }
// -- sky
camera { location <0,1,-6> sky <1,1,0> look_at 0 }
// -- transformed
camera { location -6*z look_at 0 rotate <20,30,0> translate y*.5 scale 1.1 }
// -- of an identifier
#declare C = camera { location <0,1,-6> look_at 0 } camera { C translate x }
// -- orthographic
camera { orthographic location <2,2,-6> look_at 0 right 8*x up 6*y }
// -- orthographic by angle
camera { orthographic location <2,2,-6> look_at 0 angle 50 }
// -- fisheye
camera { fisheye location <0,1,-3> look_at 0 angle 160 }
// -- ultra_wide_angle
camera { ultra_wide_angle location <0,1,-4> look_at 0 angle 120 }
// -- omnimax
camera { omnimax location <0,1,-3> look_at 0 }
// -- panoramic
camera { panoramic location <0,1,-4> look_at 0 angle 120 }
// -- cylinder 1
camera { cylinder 1 location <0,1,-4> look_at 0 angle 100 }
// -- cylinder 2
camera { cylinder 2 location <0,1,-4> look_at 0 angle 100 }
// -- cylinder 3
camera { cylinder 3 location <0,1,-4> look_at 0 angle 100 }
// -- cylinder 4
camera { cylinder 4 location <0,1,-4> look_at 0 angle 100 }
// -- spherical
camera { spherical location <0,1,-3> look_at 0 angle 180 }
// -- spherical with two angles
camera { spherical location <0,1,-3> look_at 0 angle 200 100 }
// -- focal blur without an aperture
camera { location <0,1,-6> look_at 0 aperture 0 blur_samples 10 focal_point 0 confidence .9 variance 1/128 }
// -- focal blur (parses)
camera { location <0,1,-6> look_at 0 aperture .3 blur_samples 4, 10 focal_point <0,0,0> confidence .9 variance 1/128 }
// -- bokeh (parses)
camera { location <0,1,-6> look_at 0 aperture .3 blur_samples 4 focal_point 0 bokeh { pigment { gradient x color_map { [0 rgb <0,0,0>] [1 rgb <1,1,0>] } } } }
// -- normal
camera { location <0,1,-6> look_at 0 normal { gradient x .2 scale .3 } }
// -- two cameras
camera { location <0,1,-60> look_at 0 } camera { location <0,1,-6> look_at 0 }
// -- angle 180 (fails)
camera { location <0,1,-6> look_at 0 angle 180 }
// -- mesh_camera (parses)
camera { mesh_camera { 1 0 mesh { triangle { <-1,-1,-3>, <1,-1,-3>, <0,1,-3> } } } location <0,0,.01> }
// -- look_at the location (fails)
camera { location <0,1,-6> look_at <0,1,-6> }
// -- blur_samples alone
camera { location <0,1,-6> look_at 0 blur_samples 10 }
