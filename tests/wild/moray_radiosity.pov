#version 3.1;
global_settings {
  assumed_gamma 1
  hf_gray_16
  radiosity {
    brightness       1.5
    count            20
    distance_maximum 5.0
    error_bound      1.8
    gray_threshold   0.5
    low_error_factor 0.8
    minimum_reuse    0.015
    nearest_count    4
    recursion_limit  1
  }
}
camera { location <0, 1, -5> look_at 0 }
light_source { <-4, 5, -6> rgb 1 }
sphere { 0, 1 pigment { rgb <0.9, 0.4, 0.3> } }
