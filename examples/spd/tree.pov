// SPDX-License-Identifier: Apache-2.0
// Tree, after the scene of that name among the Standard Procedural Databases of E. Haines, "A
// Proposal for Standard Graphics Environments", IEEE Computer Graphics and Applications 7(11),
// 1987.
//
// A branch is a cone with a ball on its end, where it forks into two shorter ones (M. Aono and
// T. Kunii, "Botanical Tree Image Generation", IEEE Computer Graphics and Applications 4(5), 1984).
// It tests a crowd of tiny objects on a large ground under seven lights.
//
// Size:       1   3    5    8    11     13
// Cones:      3  15   63  511  4095  16383   = 2^(Size + 1) - 1, as many spheres, and one polygon
#version 3.7;
#ifndef (Size) #declare Size = 11; #end

global_settings { assumed_gamma 1 max_trace_level 5 }
background { rgb <0.078, 0.361, 0.753> }

// Right-handed with z upwards; the height of the picture spans 45 degrees.
camera {
  location <4.5, 0.4, 2>
  sky z
  right -x*image_width/image_height
  angle 2*degrees(atan2(tan(radians(22.5))*image_width/image_height, 1))
  look_at <0, 0, 1.5>
}
// Lights share the brightness of one: each of n has 1/sqrt(n).
#declare Light = rgb 1/sqrt(7);
light_source { <-5, 5, 50> Light }
light_source { <30, -30, 30> Light }
light_source { <-40, -30, 20> Light }
light_source { <10, 30, 40> Light }
light_source { <-30, 40, 10> Light }
light_source { <50, 25, 40> Light }
light_source { <40, -10, 60> Light }

polygon {
  5, <50, 50, 0>, <-50, 50, 0>, <-50, -50, 0>, <50, -50, 0>, <50, 50, 0>
  pigment { rgb <1, 0.75, 0.33> }
  finish { ambient 0.1 diffuse 0.4 }
}

// A fork: each of the two branches leans away from the axis, and is so much shorter; the next fork
// is turned around the axis.
#declare Lean = array[2] { radians(24), radians(-38) }
#declare Shorter = array[2] { 0.80, 0.70 }
#declare Turn = radians(110);

// A branch from Foot along Axis, with all that it bears. Side is a unit vector across it, towards
// which the first of its branches leans; Radius is that of its foot.
#macro Branch(Level, Foot, Axis, Side, Length, Radius)
  #local End = Foot + Length*Axis;
  cone { Foot, Radius, End, 0.72*Radius open }
  sphere { End, 0.72*Radius }
  #if (Level > 0)
    #local Fork = 0;
    #while (Fork < 2)
      #local Way = cos(Lean[Fork])*Axis + sin(Lean[Fork])*Side;
      #local Beside = vcross(Axis, Side);
      #local Inward = vcross(Beside, Way);
      Branch(Level - 1, End, Way, cos(Turn)*Inward + sin(Turn)*Beside,
             Shorter[Fork]*Length, 0.72*Radius)
      #local Fork = Fork + 1;
    #end
  #end
#end

union {
  Branch(Size, <0, 0, 0>, z, y, 0.75, 0.06)
  pigment { rgb <0.55, 0.40, 0.20> }
  finish { ambient 0.1 diffuse 1 }
}
