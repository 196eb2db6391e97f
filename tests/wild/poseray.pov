// A scene around a mesh: geometry and materials in files of their own.
#local Temp_version = version;
#version 3.7;
//==================================================
global_settings {
  assumed_gamma 1.0
  adc_bailout 0.005
  max_trace_level 10
  number_of_waves 2
}
#declare Pretrace = 8/max(image_width, image_height);
#include "poseray_parts_POV_mat.inc"
#include "poseray_parts_POV_geom.inc"
camera {
  perspective
  up <0,1,0>
  right -x*image_width/image_height
  location <0,0,2*2.4>
  look_at <0,0,0>
  angle 36.86
  rotate <-15,0,0>
  rotate <0,30,0>
}
light_source { <0,0,5.2> color rgb <1,1,1>*1.6 shadowless rotate <-36,42,0> }
background { color srgb <0.88,0.90,0.93> }
object { figure rotate <0,12,0> }
#version Temp_version;
