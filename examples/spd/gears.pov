// SPDX-License-Identifier: Apache-2.0
// Gears, after the scene of that name among the Standard Procedural Databases of E. Haines, "A
// Proposal for Standard Graphics Environments", IEEE Computer Graphics and Applications 7(11),
// 1987.
//
// A block of Size^3 gears that mesh with those beside them. A gear is two polygons of 144 corners
// and 144 small ones between; light passes through them in part. It tests concave polygons of many
// corners, and rays that go on behind what they meet.
//
// Size:         1     2     3     4      5
// Polygons:   147  1169  3943  9345  18251   = 146 Size^3 + 1
#version 3.7;
#ifndef (Size) #declare Size = 4; #end

global_settings { assumed_gamma 1 max_trace_level 5 }
background { rgb <0.078, 0.361, 0.753> }

// Right-handed with z upwards; the height of the picture spans 45 degrees.
camera {
  location <-0.88, -1.68, 1.28>
  sky z
  right -x*image_width/image_height
  angle 2*degrees(atan2(tan(radians(22.5))*image_width/image_height, 1))
  look_at <0, 0, -0.08>
}
// Lights share the brightness of one: each of n has 1/sqrt(n).
#declare Light = rgb 1/sqrt(5);
light_source { <2, 4, 4> Light }
light_source { <-2, 4, 4> Light }
light_source { <-2, -4, 4> Light }
light_source { <2, -4, 4> Light }
light_source { <0, 0, 6> Light }

polygon {
  5, <6, 6, -0.6>, <-6, 6, -0.6>, <-6, -6, -0.6>, <6, -6, -0.6>, <6, 6, -0.6>
  pigment { rgb <1, 0.75, 0.33> }
  finish { ambient 0.1 diffuse 0.5 }
}

#declare Teeth = 36;
#declare Corners = 4*Teeth;
#declare Pitch = 0.5/Size;      // radius at which two gears touch: half of their distance
#declare Addendum = 0.09*Pitch; // by which a tooth stands out of the pitch circle, and its root in
#declare Half = 0.2/Size;       // half of the thickness

// Corner I of the outline of a gear around the origin, turned by Turn teeth. A tooth is broader at
// its root than at its tip, and leaves its neighbour's teeth some play.
#declare Places = array[4] { -0.23, -0.11, 0.11, 0.23 }
#declare Radii = array[4] { Pitch - Addendum, Pitch + Addendum, Pitch + Addendum, Pitch - Addendum }
#macro Corner(I, Turn)
  #local A = 2*pi*(div(I, 4) + Places[mod(I, 4)] + Turn)/Teeth;
  Radii[mod(I, 4)]*<cos(A), sin(A), 0>
#end

// Where one gear has a tooth, those beside it have a gap. The last corner is the first again.
#declare Outlines = array[2][Corners + 1];
#declare I = 0;
#while (I <= Corners)
  #declare Outlines[0][I] = Corner(mod(I, Corners), 0);
  #declare Outlines[1][I] = Corner(mod(I, Corners), 0.5);
  #declare I = I + 1;
#end

#macro Gear(Turn)
  #local Flank = -1;
  #while (Flank <= 1)
    polygon {
      Corners + 1
      #local I = 0;
      #while (I <= Corners)
        , Outlines[Turn][I] + Flank*Half*z
        #local I = I + 1;
      #end
    }
    #local Flank = Flank + 2;
  #end
  #local I = 0;
  #while (I < Corners)
    #local A = Outlines[Turn][I];
    #local B = Outlines[Turn][I + 1];
    polygon { 5, A - Half*z, B - Half*z, B + Half*z, A + Half*z, A - Half*z }
    #local I = I + 1;
  #end
#end

#declare Colours = array[3] {
  rgbt <0.95, 0.35, 0.30, 0.3>, rgbt <0.45, 0.85, 0.40, 0.3>, rgbt <0.45, 0.50, 0.95, 0.3>
}

#declare K = 0;
#while (K < Size)
  #declare J = 0;
  #while (J < Size)
    #declare I = 0;
    #while (I < Size)
      union {
        Gear(mod(I + J, 2))
        translate (<I, J, K> + 0.5)/Size - 0.5
        pigment { Colours[mod(I + J + K, 3)] }
        finish { ambient 0.1 diffuse 0.7 phong 0.3 phong_size 30 reflection 0.15 }
      }
      #declare I = I + 1;
    #end
    #declare J = J + 1;
  #end
  #declare K = K + 1;
#end
