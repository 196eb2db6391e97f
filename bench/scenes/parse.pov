// SPDX-License-Identifier: Apache-2.0
// The language itself: a million turns of a loop, every tenth of which places a ball.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0, -30> look_at 0 }
light_source { <-20, 30, -30> rgb 1 }
#declare Random = seed(1);
#declare Sum = 0;
#declare I = 0;
#while (I < 1000000)
  #declare Sum = Sum + sin(I)*0.5;
  #if (mod(I, 10) = 0)
    sphere { <20*rand(Random) - 10, 16*rand(Random) - 8, 20*rand(Random)>, 0.08 pigment { rgb 1 } }
  #end
  #declare I = I + 1;
#end
