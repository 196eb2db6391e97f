#version 3.7;
global_settings { assumed_gamma 1 }
#include ".\parts\sizes.inc"
camera { location <0, 1, -5> look_at 0 }
light_source { <-4, 5, -6> rgb 1 }
cylinder { -y, y, Thick pigment { image_map { png "..\wild\oak.png" } } }
