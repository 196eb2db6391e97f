// SPDX-License-Identifier: Apache-2.0
// Rings, after the scene of that name among the Standard Procedural Databases of E. Haines, "A
// Proposal for Standard Graphics Environments", IEEE Computer Graphics and Applications 7(11),
// 1987.
//
// A pyramid of knots, each of six linked rings: a ring is a pentagon of five cylinders, with a ball
// at each corner, and faces one of the six axes of the dodecahedron. It tests slender objects that
// fill little of their bounds.
//
// Size:         1    3     5     7     9
// Knots:        1   14    55   140   285   = Size (Size + 1) (2 Size + 1) / 6
// Cylinders:   30  420  1650  4200  8550   = 30 for each knot, as many spheres, and one polygon
#version 3.7;
#ifndef (Size) #declare Size = 7; #end

global_settings { assumed_gamma 1 max_trace_level 5 }
background { rgb <0.078, 0.361, 0.753> }

// Right-handed with z upwards; the height of the picture spans 45 degrees.
camera {
  location <2.9, -4.3, 2.5>*Size/3
  sky z
  right -x*image_width/image_height
  angle 2*degrees(atan2(tan(radians(22.5))*image_width/image_height, 1))
  look_at <0, 0, 0.75>*Size/3
}
// Lights share the brightness of one: each of n has 1/sqrt(n).
#declare Light = rgb 1/sqrt(3);
light_source { <8, -12, 20>*Size/3 Light }
light_source { <-12, -6, 12>*Size/3 Light }
light_source { <12, 8, 15>*Size/3 Light }

polygon {
  5, <8, 8, 0>*Size, <-8, 8, 0>*Size, <-8, -8, 0>*Size, <8, -8, 0>*Size, <8, 8, 0>*Size
  pigment { rgb <1, 0.75, 0.33> }
  finish { ambient 0.1 diffuse 0.8 }
}

// A knot spans one unit. Its pentagons lie a little off its middle, so that they link.
#declare Radius = 0.40;
#declare Offset = 0.12;
#declare Thick = 0.035;
#declare Golden = (1 + sqrt(5))/2;
#declare Axes = array[6] {
  vnormalize(<0, 1, Golden>), vnormalize(<0, -1, Golden>),
  vnormalize(<1, Golden, 0>), vnormalize(<-1, Golden, 0>),
  vnormalize(<Golden, 0, 1>), vnormalize(<Golden, 0, -1>)
}

#macro Ring(Middle, Axis)
  // Any axis points away from x, y and z alike, so that this is never 0.
  #local Side = vnormalize(vcross(Axis, <Axis.y, Axis.z, Axis.x>));
  #local Across = vcross(Axis, Side);
  #local Last = Middle + Offset*Axis + Radius*Side;
  #local I = 1;
  #while (I <= 5)
    #local A = 2*pi*I/5;
    #local Next = Middle + Offset*Axis + Radius*(cos(A)*Side + sin(A)*Across);
    cylinder { Last, Next, Thick open }
    sphere { Next, Thick }
    #local Last = Next;
    #local I = I + 1;
  #end
#end

#declare Colours = array[6] {
  rgb <1.0, 0.4, 0.3>, rgb <1.0, 0.8, 0.3>, rgb <0.5, 0.9, 0.3>,
  rgb <0.3, 0.9, 0.8>, rgb <0.4, 0.5, 1.0>, rgb <0.9, 0.4, 0.9>
}

#declare R = 0;
#while (R < 6)
  union {
    // Layer 1 is the top, of one knot; the lowest has Size by Size of them.
    #declare Layer = 1;
    #while (Layer <= Size)
      #declare J = 0;
      #while (J < Layer)
        #declare I = 0;
        #while (I < Layer)
          #declare Middle = <I - (Layer - 1)/2, J - (Layer - 1)/2, 0.55 + 0.8*(Size - Layer)>;
          Ring(Middle, Axes[R])
          #declare I = I + 1;
        #end
        #declare J = J + 1;
      #end
      #declare Layer = Layer + 1;
    #end
    pigment { Colours[R] }
    finish { ambient 0.1 diffuse 0.6 phong 0.4 phong_size 30 reflection 0.2 }
  }
  #declare R = R + 1;
#end
