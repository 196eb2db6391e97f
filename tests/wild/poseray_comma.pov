// The settings of a computer that writes numbers with a comma.
#version 3.5;
global_settings {
  adc_bailout 0,01
  max_trace_level 15
  assumed_gamma 1
}
camera { location <0, 0, -5> look_at 0 }
light_source { <-4, 5, -6> rgb 1 }
sphere { 0, 1 pigment { rgb <0.9, 0.4, 0.3> } }
