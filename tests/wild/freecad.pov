// Created by a CAD workbench: tabs, the part in its own coordinates, the camera turned instead.
#version 3.6;
#include "colors.inc"
#include "metals.inc"

global_settings {
	assumed_gamma 1.0
	ambient_light color rgb <1.0,1.0,1.0>
}
//default values
sky_sphere {
	pigment {
		gradient y
		color_map {
			[0.0  color LightGray]
			[0.3  color White]
			[0.7  color LightGray]
		}
	}
}
#declare CamUp = < 0, 0, 4.5>;
#declare CamRight = < 6, 0, 0>;
#declare CamRotation = <-35.2643897, 8.0e-15, 45>;
#declare CamPosition = < 40, -40, 41>;
camera {
	orthographic
	location < 0, 0, 0>
	direction < 0, 1, 0>
	up CamUp
	right CamRight
	scale 5
	rotate CamRotation
	translate CamPosition
}
light_source { CamPosition color rgb < 0.5, 0.5, 0.5> }
light_source { < 50, -90, 70> color rgb < 0.6, 0.6, 0.6> shadowless }
//----- Cut -----
#declare Cut_TEXTURE = texture {
	pigment {
		color rgb < 0.8, 0.8, 0.8>
	}
	finish { phong 0.5 }
}
difference {
	box { <0,0,0>, <10, 10, 10>
		pigment { color rgb < 0.2, 0.5, 0.8> }
		finish { phong 0.5 }
	}
	union {
		cylinder { <0, 0, 0>, <0, 0, 14>, 3.5
			translate < 5, 5, -2>
		}
		cone { <0, 0, 0>, 2 <0, 0, 12>, 1
			rotate <0, 90, 0>
			translate < -1, 5, 5>
		}
	}
	texture { Cut_TEXTURE }
	translate <-3, -3, 1>
}
prism { linear_sweep linear_spline 0, 2, 5, <0,0>, <6,0>, <6,4>, <0,6>, <0,0>
	rotate <90, 0, 0> translate <-14, 4, 0>
	pigment { image_map { png "oak.png" map_type 0 interpolate 2 } scale 6 }
}
