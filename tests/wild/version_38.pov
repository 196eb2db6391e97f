#version 3.8;
camera { location <0, 1, -5> look_at 0 }
light_source { <-4, 5, -6> rgb 1 }
background { rgb 0.2 }
sphere { 0, 1 pigment { rgb <0.2, 0.7, 0.4> } }
