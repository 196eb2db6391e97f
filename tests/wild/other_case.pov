#version 3.7;
global_settings { assumed_gamma 1 }
#include "Colors.INC"
#include "Other_Case_Parts.inc"
camera { location <0, 1, -5> look_at 0 }
light_source { <-4, 5, -6> rgb 1 }
sphere { 0, 1 pigment { image_map { png "OAK.PNG" map_type 1 } } }
cylinder { <1.5, -1, 0>, <1.5, 1, 0>, Thick pigment { Red } }
