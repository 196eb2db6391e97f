// SPDX-License-Identifier: Apache-2.0
// One solid of many: the union of Count boxes less the union of Count spheres, spread through a
// cube. `Declare=Count=27000` on the command line selects the number.
#version 3.7;
global_settings { assumed_gamma 1 }
#ifndef (Count) #declare Count = 1000; #end
camera { location <2.2, 1.8, -3> look_at 0 angle 38 }
light_source { <5, 8, -6> rgb 1 }
background { rgb <0.2, 0.3, 0.4> }
#declare Random = seed(7);
#declare Size = 0.75/pow(Count, 1/3);
#macro Place() <rand(Random) - 0.5, rand(Random) - 0.5, rand(Random) - 0.5>*2 #end
difference {
  union {
    #local I = 0;
    #while (I < Count)
      #local P = Place();
      box { P - Size, P + Size }
      #local I = I + 1;
    #end
  }
  union {
    #local I = 0;
    #while (I < Count)
      sphere { Place(), 1.2*Size }
      #local I = I + 1;
    #end
  }
  pigment { rgb <0.5, 0.7, 0.9> }
  finish { ambient 0.2 diffuse 0.8 }
}
