// SPDX-License-Identifier: Apache-2.0
#version 3.7;
global_settings { assumed_gamma 1 }

// An array of objects, placed by nested loops that choose by #switch, under transforms and inverses.
camera { location <-4, 6, -9> look_at <0, 0, 0.5> angle 42 }
light_source { <-6, 12, -8> rgb 1 }
#declare Things = array[4];
#declare Things[0] = sphere { 0, 0.4 }
#declare Things[1] = box { -0.35, 0.35 rotate 30*y }
#declare Things[2] = cone { -0.4*y, 0.4, 0.4*y, 0.1 }
#declare Things[3] = difference { sphere { 0, 0.45 } cylinder { -y, y, 0.2 } }
#declare Tilt = transform { rotate <20, 0, 35> scale <1, 1.5, 0.8> translate 0.1*y }
#declare I = 0;
#while (I < 6)
  #declare J = 0;
  #while (J < 6)
    object { Things[mod(I*3 + J, 4)]
      #switch (mod(I + 2*J, 5))
        #case (0) transform { Tilt } #break
        #case (1) transform { Tilt inverse } #break
        #range (2, 3) rotate <0, 20*I, 30*J> #break
        #else scale <1, 0.5 + J/6, 1>
      #end
      translate <I - 2.5, 0, J - 2.5>
      pigment { rgb <I/5, 0.4, J/5> } }
    #declare J = J + 1;
  #end
  #declare I = I + 1;
#end
plane { y, -0.8 pigment { rgb 0.7 } }
