camera { spherical location <1, 2, -3> angle 200 100 look_at 0 rotate y }
camera { cylinder 2 location -z right x*1.5 up y sky <1, 1, 0> look_at 0 angle 50 }
camera { orthographic location -5*z look_at 0 right 4*x up 3*y aperture 0.4 focal_point 0 blur_samples 5, 9 confidence 0.9 variance 1/128 normal { bumps 0.1 } }
background { rgb 0.5 } fog { distance 9 rgbft <1, 1, 1, 0.1, 0.2> fog_type 2 fog_alt 1 up z turbulence 0.2 } rainbow { angle 40 width 5 distance 99 color_map { [0 rgb 0] [1 rgb 1] } }
sky_sphere { pigment { gradient y color_map { [0 blue 1] [1 rgb 1] } } emission 0.5 }
global_settings { max_trace_level 3 adc_bailout 0.1 ambient_light rgb 1 assumed_gamma 2.2 charset utf8 noise_generator 2 number_of_waves 3 radiosity { count 9 } photons { count 9 } subsurface { } }
