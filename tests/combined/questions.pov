// SPDX-License-Identifier: Apache-2.0
#version 3.7;
global_settings { assumed_gamma 1 }

#include "strings.inc"
#include "rand.inc"
#include "math.inc"
// What a scene can ask while it is read: rays, insides, extents, colours, noise, texts.
camera { location <0, 5, -10> look_at <0, 0.5, 0> angle 42 }
light_source { <-8, 12, -10> rgb 1 }
#declare Hill = union { sphere { <0,-1.5,0>, 2.5 } sphere { <2.5,-0.6,0.5>, 1.2 } torus { 2.6, 0.3 translate <-1,0.2,0> } };
object { Hill pigment { rgb <0.7,0.8,0.6> } }
#declare R = seed(12);
#for (I, 1, 60)
  #local Normal = <0,0,0>;
  #local P = trace(Hill, <RRand(-4, 4, R), 10, RRand(-3, 3, R)>, -y, Normal);
  #if (vlength(Normal) > 0)
    cylinder { P, P + 0.5*Normal, 0.06 pigment { rgb (Normal + 1)/2 } }
  #else
    sphere { <RRand(-4, 4, R), 0.1, RRand(-3, 3, R)>, 0.1 pigment { rgb <1,0,0> } }
  #end
#end
#declare A = min_extent(Hill); #declare B = max_extent(Hill);
box { A, <B.x, A.y + 0.1, B.z> pigment { rgb <0.9,0.9,0.5> } }
#declare Pig = pigment { bozo color_map { [0 rgb <1,0,0>] [1 rgb <0,0,1>] } scale 0.5 };
#for (I, 0, 9) box { <I*0.8 - 4, -0.4, -4>, <I*0.8 - 3.4, 0.2 + 0.3*inside(Hill, <I - 4.5, 0, 0>), -3.6> pigment { color eval_pigment(Pig, <I, 0, 0>) } } #end
#declare T = concat(str(pi, 0, 4), chr(65), substr("abcdef", 2, 3), strupr("x"), vstr(3, <1,2,3>, ":", 0, 1));
text { ttf "cyrvetic.ttf" T 0.2, 0 scale 0.7 translate <-4, 2.2, 0> pigment { rgb <0.2,0.2,0.6> } }
#debug concat(T, "\n")
plane { y, -0.5 pigment { rgb 0.6 } }
