// SPDX-License-Identifier: Apache-2.0
#version 3.7;
global_settings { assumed_gamma 1 }

// A mesh2 with its own normals, textures by corner and uv, as part of a difference and alone.
camera { location <0, 3, -7> look_at <0, 0.3, 0> angle 42 }
light_source { <-8, 12, -10> rgb 1 }
#declare N = 8;
#declare M = mesh2 {
  vertex_vectors { 2*N + 2, <0,1,0>, <0,-1,0>
    #for (I, 0, N - 1) , vrotate(<0.9, 0.4, 0>, 360*I/N*y), vrotate(<0.9, -0.4, 0>, (360*I/N + 22.5)*y) #end }
  normal_vectors { 2*N + 2, y, -y
    #for (I, 0, N - 1) , vrotate(<0.9, 0.5, 0>, 360*I/N*y), vrotate(<0.9, -0.5, 0>, (360*I/N + 22.5)*y) #end }
  texture_list { 3, texture { pigment { rgb <1,0.3,0.3> } } texture { pigment { rgb <0.3,1,0.3> } finish { phong 0.5 } } texture { pigment { checker rgb 1 rgb <0,0,0.6> scale 0.2 } } }
  face_indices { 4*N
    #for (I, 0, N - 1)
      #local J = mod(I + 1, N);
      , <0, 2 + 2*I, 2 + 2*J>, 0, 1, 2
      , <1, 3 + 2*I, 3 + 2*J>, 2
      , <2 + 2*I, 3 + 2*I, 2 + 2*J>, 1
      , <3 + 2*I, 3 + 2*J, 2 + 2*J>, 0, 2, 1
    #end }
  inside_vector <0.1, 1, 0.2>
}
object { M translate -1.6*x }
difference { object { M scale 1.2 } box { 0, <2, 2, -2> pigment { rgb <0.9, 0.8, 0.4> } } translate 1.4*x }
plane { y, -1.2 pigment { rgb 0.8 } }
