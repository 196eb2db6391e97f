// SPDX-License-Identifier: Apache-2.0
// Balls, the sphereflake, after the scene of that name among the Standard Procedural Databases of
// E. Haines, "A Proposal for Standard Graphics Environments", IEEE Computer Graphics and
// Applications 7(11), 1987.
//
// Each ball carries nine of a third of its radius, six around its equator and three above, which
// carry nine in turn. All of them are mirrors in part. It tests rays that scatter over objects
// whose sizes differ by powers of three.
//
// Size:        1    2    3     4      5
// Spheres:    10   91  820  7381  66430   = (9^(Size + 1) - 1) / 8, and one polygon
#version 3.7;
#ifndef (Size) #declare Size = 4; #end

global_settings { assumed_gamma 1 max_trace_level 5 }
background { rgb <0.078, 0.361, 0.753> }

// Right-handed with z upwards; the height of the picture spans 45 degrees.
camera {
  location <2.1, 1.3, 1.7>
  sky z
  right -x*image_width/image_height
  angle 2*degrees(atan2(tan(radians(22.5))*image_width/image_height, 1))
  look_at 0
}
// Lights share the brightness of one: each of n has 1/sqrt(n).
#declare Light = rgb 1/sqrt(3);
light_source { <4, 3, 2> Light }
light_source { <1, -4, 4> Light }
light_source { <-3, 1, 5> Light }

polygon {
  5, <12, 12, -0.5>, <-12, 12, -0.5>, <-12, -12, -0.5>, <12, -12, -0.5>, <12, 12, -0.5>
  pigment { rgb <1, 0.75, 0.33> }
  finish { ambient 0.1 diffuse 0.8 }
}

// A ball, with those it carries. Its pole is Pole, and Side is a unit vector on its equator.
#macro Ball(Level, Centre, Radius, Pole, Side)
  sphere { Centre, Radius }
  #if (Level > 0)
    #local Across = vcross(Pole, Side);
    #local I = 0;
    #while (I < 9)
      // Azimuth, and height above the equator, in degrees.
      #local A = radians(I < 6 ? 60*I : 120*I + 30);
      #local H = radians(I < 6 ? 0 : 60);
      #local Way = cos(H)*(cos(A)*Side + sin(A)*Across) + sin(H)*Pole;
      #local Turned = vnormalize(Pole - vdot(Pole, Way)*Way);
      Ball(Level - 1, Centre + 4/3*Radius*Way, Radius/3, Way, Turned)
      #local I = I + 1;
    #end
  #end
#end

union {
  Ball(Size, <0, 0, 0>, 0.5, z, vnormalize(x + 0.3*y))
  pigment { rgb <1, 0.9, 0.7> }
  finish { ambient 0.1 diffuse 0.5 phong 0.5 phong_size 10 reflection 0.5 }
}
