// SPDX-License-Identifier: Apache-2.0
#version 3.7;
global_settings { assumed_gamma 1 }

// A row for each item of a finish, with values that others do not show.
camera { location <0, 6, -14> look_at <0, 0, 0> angle 42 }
light_source { <-8, 12, -10> rgb 1 }
light_source { <10, 3, -6> rgb <0.3, 0.4, 0.6> }
#declare F = array[12] { finish { brilliance 3 diffuse 0.9 }, finish { phong 1 phong_size 8 metallic }, finish { specular 0.8 roughness 0.02 metallic 0.5 },
  finish { diffuse albedo 0.8 specular albedo 0.6 roughness 0.05 }, finish { phong albedo 0.5 phong_size 60 }, finish { diffuse 0.6, 0.4 },
  finish { reflection { rgb <0.1,0.2,0.3>, rgb <0.9,0.6,0.3> } }, finish { reflection { 0, 1 fresnel } conserve_energy }, finish { reflection 0.5 reflection_exponent 0.5 },
  finish { ambient rgb <0.3,0,0.1> emission rgb <0,0.1,0.2> }, finish { reflection { 0.4 metallic 0.7 } brilliance 0.5 }, finish { specular 1 roughness 0.3 diffuse 0.2 } }
#for (I, 0, 11)
  sphere { <mod(I, 4)*3 - 4.5, 0, 3 - div(I, 4)*3>, 1.1 pigment { rgb <0.8, 0.5, 0.3> } finish { F[I] } interior { ior 1.4 } }
#end
plane { y, -1.1 pigment { checker rgb 1 rgb <0.4,0.6,0.5> } }
sky_sphere { pigment { gradient y color_map { [0 rgb 1] [1 rgb <0.2,0.4,0.9>] } } }
