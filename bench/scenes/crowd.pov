// SPDX-License-Identifier: Apache-2.0
// Many small solids: Count differences of two to four parts, loose in a cube.
// `Declare=Count=125000` on the command line selects the number.
#version 3.7;
global_settings { assumed_gamma 1 }
#ifndef (Count) #declare Count = 10000; #end
camera { location <2.2, 1.8, -3> look_at 0 angle 38 }
light_source { <5, 8, -6> rgb 1 }
background { rgb <0.2, 0.3, 0.4> }
#declare Random = seed(3);
#declare Size = 0.6/pow(Count, 1/3);
#declare Paint = texture { pigment { rgb <0.6, 0.9, 0.6> } finish { ambient 0.2 diffuse 0.8 } }
#local I = 0;
#while (I < Count)
  #local P = <rand(Random) - 0.5, rand(Random) - 0.5, rand(Random) - 0.5>*2;
  difference {
    #if (mod(I, 2)) sphere { P, Size } #else box { P - 0.8*Size, P + 0.8*Size } #end
    cylinder { P - 2*Size*y, P + 2*Size*y, 0.4*Size }
    #if (mod(I, 3) > 0) sphere { P + 0.7*Size*<1, 0.5, -1>, 0.6*Size } #end
    #if (mod(I, 3) > 1) box { P, P + 2*Size } #end
    texture { Paint }
  }
  #local I = I + 1;
#end
