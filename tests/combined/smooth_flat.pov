// SPDX-License-Identifier: Apache-2.0
#version 3.7;
global_settings { assumed_gamma 1 }
// Meshes whose corner normals agree with nothing, under layers that turn with the mesh.
camera { location <0, 3, -7> look_at <0, 0.4, 0> angle 42 }
light_source { <-5, 8, -6> rgb 1 }
#declare M = mesh {
  #for (I, 0, 7) #for (J, 0, 7)
    #local A = <I - 4, 0.4*sin(I*1.3)*cos(J), J - 4>/2; #local B = <I - 3, 0.4*sin(I*1.3 + 1.3)*cos(J), J - 4>/2;
    #local C = <I - 4, 0.4*sin(I*1.3)*cos(J + 1), J - 3>/2; #local D = <I - 3, 0.4*sin(I*1.3 + 1.3)*cos(J + 1), J - 3>/2;
    smooth_triangle { A, y, B, y + 0.3*x, C, y - 0.3*z }
    triangle { B, C, D }
  #end #end
}
object { M texture { pigment { wood scale 0.3 } finish { specular 0.4 } } texture { pigment { bozo color_map { [0.4 rgbt 1] [0.6 rgbt <0.2, 0.5, 0.3, 0.2>] } scale 0.4 } } rotate 25*y }
plane { y, -0.8 pigment { rgb 0.7 } }
