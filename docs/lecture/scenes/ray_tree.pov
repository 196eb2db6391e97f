// SPDX-License-Identifier: Apache-2.0
// Glass between mirrors: every ray that meets the ball or the walls sends out two more, down to
// Declare=Level=N.
#version 3.7;
#ifndef (Level) #declare Level = 8; #end
global_settings { assumed_gamma 1 max_trace_level Level adc_bailout 1/512 }

camera { location <0.4, 1.5, -4.6> look_at <0, 0.9, 0> right x*image_width/image_height angle 52 }
light_source { <-1.5, 5.5, -3.5> rgb 1 }
background { rgb <0.55, 0.70, 0.90> }
plane { y, 0 pigment { checker rgb 0.9, rgb <0.25, 0.32, 0.40> } finish { ambient 0.15 diffuse 0.7 } }
#declare Mirror = texture { pigment { rgb 0.05 } finish { ambient 0 diffuse 0.1 reflection 0.85 } }
box { <-2.6, 0, 1.8>, <2.6, 2.6, 1.9> texture { Mirror } }
box { <-2.0, 0, -1.5>, <-1.9, 2.4, 1.6> texture { Mirror } rotate 8*y }
sphere {
  <0, 0.9, 0>, 0.9
  pigment { rgbf <0.95, 1, 0.97, 0.9> }
  finish { ambient 0 diffuse 0 specular 0.7 roughness 0.004 reflection { 0.05, 0.9 falloff 3 } }
  interior { ior 1.5 }
}
sphere { <1.3, 0.35, -1.0>, 0.35 pigment { rgb <0.85, 0.35, 0.20> } finish { ambient 0.1 diffuse 0.8 phong 0.6 } }
