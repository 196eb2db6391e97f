// SPDX-License-Identifier: Apache-2.0
#version 3.7;
global_settings { assumed_gamma 1 }

// Balls and sticks under an orthographic camera with its right vector turned, atoms of clear glass.
background { rgb 1 }
camera { orthographic right -8*x up 6*y direction z location <0, 0, 20> look_at 0 }
light_source { <20, 30, 40> rgb 1 }
light_source { <-20, 10, 40> rgb 0.4 shadowless }
#declare Dull = finish { ambient 0.15 diffuse 0.8 phong 0.3 }
#macro atom(P, R, C, F) sphere { P, R pigment { C } finish { F } } #end
#macro bond(A, B, R, C)
  #local M = (A + B)/2;
  cylinder { A, M, R pigment { color C } finish { Dull } }
  cylinder { M, B, R open pigment { color C*0.7 } finish { Dull } }
#end
#declare N = 7;
#declare P = array[N];
#declare I = 0;
#while (I < N)
  #declare P[I] = vrotate(<2.2, 0, 0.2*I>, z*360*I/N);
  #declare I = I + 1;
#end
#declare I = 0;
#while (I < N)
  bond(P[I], P[mod(I + 1, N)], 0.12, rgb <0.4, 0.4, 0.45>)
  atom(P[I], 0.45, rgbt <1, 0.2 + I/10, 0.2, 0.6>, Dull)
  atom(P[I]*0.55 + z, 0.3, rgbf <0.2, 0.4, 1, 0.7>, Dull)
  #declare I = I + 1;
#end
