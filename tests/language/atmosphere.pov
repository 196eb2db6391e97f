// SPDX-License-Identifier: Apache-2.0
// Backgrounds, fog, sky spheres, rainbows and global settings.
#version 3.7;
camera { location <1.1,1.3,-5> look_at <0,.6,0> angle 65 }
light_source { <3,5,-10> rgb 1 }
sphere { 0, 1 pigment { rgb <1,.6,.3> } finish { ambient .2 } }
plane { y, -1 pigment { checker rgb 1 rgb .3 } }
// -- background
global_settings { assumed_gamma 1 }
background { rgb <.2,.3,.6> }
// -- background of a colour
global_settings { assumed_gamma 1 }
background { color red .5 blue .2 }
// -- fog
global_settings { assumed_gamma 1 }
fog { distance 6 color rgb <.6,.7,.8> }
// -- fog of type 1
global_settings { assumed_gamma 1 }
fog { fog_type 1 distance 4 rgbf <.6,.7,.8,.3> }
// -- fog that lets light through
global_settings { assumed_gamma 1 }
fog { distance 3 rgbt <.6,.7,.8,.3> }
// -- ground fog
global_settings { assumed_gamma 1 }
fog { fog_type 2 distance 3 rgb .8 fog_offset -.5 fog_alt .6 }
// -- ground fog turned
global_settings { assumed_gamma 1 }
fog { fog_type 2 distance 3 rgb .8 fog_offset -.5 fog_alt .6 up <.2,1,0> }
// -- ground fog with turbulence
global_settings { assumed_gamma 1 }
fog { fog_type 2 distance 3 rgb .8 fog_offset 0 fog_alt .4 turbulence .5 turb_depth .3 octaves 3 omega .5 lambda 2 }
// -- two fogs
global_settings { assumed_gamma 1 }
fog { distance 8 rgb <.8,.2,.2> } fog { fog_type 2 distance 4 rgb .8 fog_offset 0 fog_alt .3 }
// -- fog of an identifier
global_settings { assumed_gamma 1 }
#declare F = fog { distance 6 rgb .5 } fog { F distance 3 }
// -- transformed fog
global_settings { assumed_gamma 1 }
fog { fog_type 2 distance 3 rgb .8 fog_offset 0 fog_alt .4 translate .5*y rotate 10*z }
// -- sky_sphere
global_settings { assumed_gamma 1 }
sky_sphere { pigment { gradient y color_map { [0 rgb 1] [.6 rgb <.1,.3,.8>] } } }
// -- sky_sphere of layers
global_settings { assumed_gamma 1 }
sky_sphere { pigment { gradient y color_map { [0 rgb 1] [.6 rgb <.1,.3,.8>] } } pigment { bozo color_map { [0 rgbt 1] [1 rgbt <1,1,1,.2>] } scale .3 } rotate 20*x emission .8 }
// -- sky_sphere of an identifier
global_settings { assumed_gamma 1 }
#declare S = sky_sphere { pigment { rgb <.4,.5,.9> } } sky_sphere { S }
// -- rainbow
global_settings { assumed_gamma 1 }
rainbow { angle 42 width 20 distance 20 direction <-.3,-.2,1> jitter 0 color_map { [0 rgbt <1,0,0,.3>] [1 rgbt <0,0,1,.3>] } }
// -- rainbow with an arc
global_settings { assumed_gamma 1 }
background { rgb .4 } rainbow { angle 30 width 12 distance 9 direction <0,-.1,1> color_map { [0 rgbt <1,0,0,.2>] [.5 rgbt <0,1,0,.2>] [1 rgbt <0,0,1,.2>] } up y arc_angle 120 falloff_angle 60 }
// -- media of the scene (parses)
global_settings { assumed_gamma 1 }
media { scattering { 1, .01 } }
// -- ambient_light
global_settings { assumed_gamma 1 }
global_settings { ambient_light rgb <2,.5,.5> }
// -- max_trace_level
global_settings { assumed_gamma 1 }
global_settings { max_trace_level 2 } sphere { <2,0,0>, 1 finish { reflection .8 } }
// -- adc_bailout
global_settings { assumed_gamma 1 }
global_settings { adc_bailout .2 max_intersections 64 number_of_waves 5 noise_generator 1 hf_gray_16 off }
// -- irid_wavelength
global_settings { assumed_gamma 1 }
global_settings { irid_wavelength rgb <.7,.5,.4> mm_per_unit 10 }
// -- charset
global_settings { assumed_gamma 1 }
global_settings { charset utf8 }
// -- number_of_waves
global_settings { assumed_gamma 1 }
global_settings { number_of_waves 3 } sphere { <2,0,-1>, 1 pigment { rgb 1 } normal { waves .6 scale .2 } }
// -- noise_generator
global_settings { assumed_gamma 1 }
global_settings { noise_generator 3 } sphere { <2,0,-1>, 1 pigment { bozo color_map { [0 rgb x] [1 rgb z] } scale .2 } }
// -- radiosity (parses)
global_settings { assumed_gamma 1 }
global_settings { radiosity { adc_bailout .01 always_sample off brightness 1 count 20 error_bound 1.8 gray_threshold 0 low_error_factor .5 max_sample -1 maximum_reuse .2 minimum_reuse .015 media off nearest_count 5 normal off pretrace_start .08 pretrace_end .04 recursion_limit 2 subsurface off } }
// -- photons (parses)
global_settings { assumed_gamma 1 }
global_settings { photons { spacing .1 gather 20, 100 radius .1, 1, .1 autostop 0 jitter .4 max_trace_level 5 adc_bailout .01 expand_thresholds .2, 40 media 0, 2 } }
// -- subsurface (parses)
global_settings { assumed_gamma 1 }
global_settings { subsurface { samples 20, 5 radiosity off } mm_per_unit 40 }
// -- assumed_gamma 2.2
global_settings { assumed_gamma 2.2 }
// -- assumed_gamma srgb
global_settings { assumed_gamma srgb }
// -- assumed_gamma 1.5
global_settings { assumed_gamma 1.5 }
// -- no assumed_gamma

// -- no assumed_gamma in version 3.5
#version 3.5;
// -- empty global_settings
global_settings { assumed_gamma 1 }
global_settings { }
// -- unknown setting (fails)
global_settings { assumed_gamma 1 }
global_settings { shininess 3 }
// -- fog that is scaled unevenly
global_settings { assumed_gamma 1 } fog { fog_type 2 distance 3 rgb .8 fog_offset -.4 fog_alt .5 up <1,1,0> scale <1,3,1> }
// -- srgb colours with assumed_gamma 2.2
global_settings { assumed_gamma 2.2 } sphere { <2,0,-1>, 1 pigment { srgb <.2,.5,.8> } finish { ambient 1 diffuse 0 } }
// -- srgb colours with assumed_gamma srgb
global_settings { assumed_gamma srgb } sphere { <2,0,-1>, 1 pigment { srgb <.2,.5,.8> } finish { ambient 1 diffuse 0 } }
// -- images with assumed_gamma
global_settings { assumed_gamma 2.2 } sphere { <2,0,-1>, 1 pigment { image_map { function 8, 8 { x } } } finish { ambient 1 diffuse 0 } }
