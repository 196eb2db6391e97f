#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1, -5> look_at 0 }
light_source { <-4, 5, -6> rgb 1 }
sphere { 0, 1 pigment { image_map { jpeg "C:\pictures\bark.jpg" map_type 1 } } }
