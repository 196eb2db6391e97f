// SPDX-License-Identifier: Apache-2.0
#version 3.7;
global_settings { assumed_gamma 1 }

// A hundred thousand spheres without a union around them, by nested loops.
camera { location <0, 30, -75> look_at <0, -2, 0> angle 40 }
light_source { <60, 100, -60> rgb 1 }
#declare T = texture { pigment { rgb <0.9, 0.5, 0.3> } finish { phong 0.4 } }
#for (I, -50, 49)
  #for (J, -50, 49)
    #for (K, 0, 9)
      sphere { <I*0.7, K*0.7 + sin(I/5)*cos(J/6)*3, J*0.7>, 0.2 texture { T } }
    #end
  #end
#end
