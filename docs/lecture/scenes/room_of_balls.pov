// SPDX-License-Identifier: Apache-2.0
// Declare=Count=N balls at random places of a cube, of a size that keeps the cube evenly full.
#version 3.7;
global_settings { assumed_gamma 1 }
#ifndef (Count) #declare Count = 1000; #end

camera { location <1.4, 1.2, -2.6> look_at <0.5, 0.45, 0.5> right x*image_width/image_height angle 34 }
light_source { <-3, 5, -4> rgb 1 }
background { rgb <0.92, 0.94, 0.97> }
plane { y, -0.1 pigment { rgb 0.8 } finish { ambient 0.2 diffuse 0.7 } }
#declare R = seed(1);
#declare Size = 0.28 / pow(Count, 1/3);
union {
  #for (I, 1, Count)
    sphere { <rand(R), rand(R), rand(R)>, Size*(0.6 + 0.8*rand(R))
      pigment { rgb <0.3 + 0.6*rand(R), 0.4 + 0.4*rand(R), 0.3 + 0.6*rand(R)> } }
  #end
  finish { ambient 0.15 diffuse 0.7 phong 0.3 reflection 0.1 }
}
