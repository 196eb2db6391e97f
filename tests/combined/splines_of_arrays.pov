// SPDX-License-Identifier: Apache-2.0
#version 3.7;
global_settings { assumed_gamma 1 }

// A macro that builds splines out of arrays of points, and tubes along them.
camera { location <0, 3, -9> look_at <0, 0.5, 0> angle 50 }
light_source { <10, 20, -15> rgb 1 }
#declare Points = array[3][5] {
  { <-4,0,0>, <-2,2,0>, <0,0,1>, <2,-1,0>, <4,1,0> },
  { <-4,1,2>, <-2,0,2>, <0,2,2>, <2,0,2>, <4,0,2> },
  { <-4,2,-1>, <-2,1,-1>, <0,1,-2>, <2,2,-1>, <4,-1,-1> } }
#macro Path(Row, Kind)
  #if (Kind = 0) spline { natural_spline #end
  #if (Kind = 1) spline { cubic_spline #end
  #if (Kind = 2) spline { linear_spline #end
    #local I = 0;
    #while (I < dimension_size(Points, 2))
      I/4, Points[Row][I]
      #local I = I + 1;
    #end
  }
#end
#macro Tube(S, N, Colour)
  union {
    #local I = 0;
    #while (I < N)
      #local A = S(I/N); #local B = S((I + 1)/N);
      sphere { A, 0.2 }
      #if (vlength(B - A) > 0) cylinder { A, B, 0.2 } #end
      #local I = I + 1;
    #end
    pigment { rgb Colour } finish { phong 0.6 }
  }
#end
#declare K = 0;
#while (K < 3)
  #declare S = Path(K, K)
  Tube(S, 20 + 10*K, <K/2, 1 - K/3, 0.4>)
  #declare K = K + 1;
#end
plane { y, -1.5 pigment { checker rgb 0.8, rgb 0.6 } }
