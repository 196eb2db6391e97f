// SPDX-License-Identifier: Apache-2.0
// A sphere of radius 1 at a distance of Far radii, through a telescope that always shows it at the
// same size: the quadratic must not lose its digits.
#version 3.7;
global_settings { assumed_gamma 1 }
#ifndef (Far) #declare Far = 1e6; #end

camera { location -Far*z look_at 0 right x*image_width/image_height angle 2.6/Far*180/pi*image_width/image_height }
light_source { <-4, 6, -8>*Far rgb 1 }
background { rgb <0.10, 0.12, 0.18> }
sphere {
  0, 1
  pigment { checker rgb <0.95, 0.80, 0.35>, rgb <0.35, 0.20, 0.10> scale 0.31 }
  finish { ambient 0.1 diffuse 0.8 phong 0.5 phong_size 80 }
}
