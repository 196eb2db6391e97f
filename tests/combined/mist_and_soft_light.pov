// SPDX-License-Identifier: Apache-2.0
#version 3.7;
global_settings { assumed_gamma 1 }

// An area light without jitter through ground fog that turns, over fog of its own colour.
camera { location <0, 2.5, -9> look_at <0, 1, 0> angle 50 }
light_source { <-5, 8, -4> rgb 1 area_light 3*x, 3*z, 5, 5 adaptive 1 circular orient }
light_source { <6, 4, -6> rgb <0.4, 0.3, 0.2> parallel point_at 0 fade_distance 8 fade_power 2 }
fog { fog_type 2 distance 6 rgb <0.6, 0.7, 0.9> fog_offset 0.3 fog_alt 0.8 up y turbulence 0.4 turb_depth 0.3 octaves 3 }
fog { distance 60 rgbft <0.8, 0.7, 0.6, 0.1, 0.1> }
#for (I, -3, 3) cylinder { <I*1.5, -1, I*I*0.4>, <I*1.5, 2.5, I*I*0.4>, 0.3 pigment { rgb <0.8, 0.5 + I/8, 0.4> } } #end
plane { y, -0.5 pigment { checker rgb 0.9 rgb 0.4 } }
