#version 3.7;
camera { location <0, 1.6, -5> look_at <0, 0.13, 0> }
light_source { <-4, 5, -6> rgb 0.9 }
background { rgb <0.2, 0.3, 0.5> }
plane { y, -1 pigment { checker rgb <0.2, 0.5, 0.3>, rgb <0.8, 0.8, 0.6> } }
sphere { <-1.1, 0, 0>, 1 pigment { bozo color_map { [0.2 rgb <0.9, 0.2, 0.1>] [0.8 rgb <0.9, 0.8, 0.5>] } scale 0.3 } finish { specular 0.5 } }
sphere { <1.1, 0, 0>, 1 pigment { granite scale 2 } normal { bumps 0.4 scale 0.2 } finish { reflection 0.2 } }
sphere { <0, 1.3, 1>, 0.8 pigment { image_map { png "oak.png" map_type 1 } } finish { ambient rgb <0.2, 0.1, 0.1> diffuse 0.7 } }
