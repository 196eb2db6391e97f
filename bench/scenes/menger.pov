// SPDX-License-Identifier: Apache-2.0
// Menger's sponge as a box less square bars: one difference of 31, 274 or 2461 parts at levels 2 to
// 4. `Declare=Level=3` on the command line selects the level.
#version 3.7;
global_settings { assumed_gamma 1 }
#ifndef (Level) #declare Level = 3; #end
camera { location <1.9, 1.6, -2.6> look_at <0, -0.05, 0> angle 38 }
light_source { <4, 6, -5> rgb 1 }
background { rgb <0.2, 0.3, 0.4> }
difference {
  box { -0.5, 0.5 }
  #local Cells = 1;
  #local K = 0;
  #while (K < Level)
    #local Side = 1/Cells;
    #local I = 0;
    #while (I < Cells)
      #local J = 0;
      #while (J < Cells)
        #local A = -0.5 + (I + 1/3)*Side;
        #local B = -0.5 + (J + 1/3)*Side;
        #local W = Side/3;
        box { <A, B, -1>, <A + W, B + W, 1> }
        box { <A, -1, B>, <A + W, 1, B + W> }
        box { <-1, A, B>, <1, A + W, B + W> }
        #local J = J + 1;
      #end
      #local I = I + 1;
    #end
    #local Cells = 3*Cells;
    #local K = K + 1;
  #end
  pigment { rgb <0.9, 0.7, 0.4> }
  finish { ambient 0.2 diffuse 0.8 }
}
