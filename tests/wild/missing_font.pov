#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1, -5> look_at 0 }
light_source { <-4, 5, -6> rgb 1 }
text { ttf "C:\WINDOWS\Fonts\arial.ttf" "Wild" 0.3, 0 pigment { rgb <1, 0.5, 0> } translate <-1, -0.3, 0> }
