// SPDX-License-Identifier: Apache-2.0
// One room through five projections: Declare=Projection=1 to 5.
#version 3.7;
global_settings { assumed_gamma 1 }
#ifndef (Projection) #declare Projection = 1; #end

camera {
  #switch (Projection)
    #case (1) perspective angle 75 #break
    #case (2) orthographic angle 75 #break
    #case (3) fisheye angle 180 #break
    #case (4) panoramic #break
    #else spherical
  #end
  location <0, 1.6, -3.4>
  look_at <0, 1.3, 0>
}
light_source { <1.5, 2.8, -2.5> rgb 0.9 }

box {
  <-3, 0, -5>, <3, 3, 3>
  pigment { checker rgb <0.85, 0.80, 0.70>, rgb <0.60, 0.66, 0.72> scale 0.999 }
  finish { ambient 0.2 diffuse 0.8 }
  hollow
}
#for (X, -2, 2)
  cylinder { <X, 0, 1.5>, <X, 2.2, 1.5>, 0.18
    pigment { rgb <0.75, 0.35, 0.25> } finish { ambient 0.2 diffuse 0.7 phong 0.4 } }
#end
sphere { <0, 0.5, -0.8>, 0.5 pigment { rgb <0.20, 0.45, 0.75> } finish { ambient 0.2 phong 0.8 } }
