polygon { 5, 0, x, x+y, y, 0 } triangle { 0, x, y } smooth_triangle { 0, z, x, z, y, z+x } disc { 0, z, 2, 0.5 }
mesh2 { vertex_vectors { 3, 0, x, y } normal_vectors { 1, z } uv_vectors { 3, 0, u, v } texture_list { 1, texture { pigment { rgb 1 } } } face_indices { 1, <0, 1, 2>, 0 } uv_indices { 1, <0, 1, 2> } inside_vector z uv_mapping }
blob { threshold 0.5 sphere { 0, 1, 2 } cylinder { 0, x, 1, -1 pigment { rgb x } } sturm hierarchy off }
lathe { bezier_spline 4, <1, 0>, <2, 1>, <1, 2>, <0, 3> } sor { 4, <0, 0>, <1, 1>, <1, 2>, <0, 3> }
sphere_sweep { cubic_spline 4, 0, 1, x, 0.5, y, 0.2, z, 1 tolerance 0.1 } isosurface { function { x*x + y*y - 1 + z } contained_by { sphere { 0, 2 } } max_gradient 4 } height_field { function 4, 4 { x*y } smooth water_level 0.1 }
bicubic_patch { type 1 flatness 0.1 u_steps 2 v_steps 2 0, x, 2*x, 3*x, y, x+y, 2*x+y, 3*x+y, 2*y, x+2*y, 2*x+2*y, 3*x+2*y, 3*y, x+3*y, 2*x+3*y, 3*x+3*y } julia_fractal { <0.1, 0.2, 0.3, 0.4> quaternion cube max_iteration 5 } parametric { function { u }, function { v }, function { u*v } <0, 0>, <1, 1> contained_by { box { -1, 1 } } }
