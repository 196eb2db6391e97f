// SPDX-License-Identifier: Apache-2.0
// Teapot, after the scene of that name among the Standard Procedural Databases of E. Haines, "A
// Proposal for Standard Graphics Environments", IEEE Computer Graphics and Applications 7(11),
// 1987.
//
// M. Newell's teapot of 1975: 32 Bezier patches, each cut into Size by Size cells of two
// triangles, on a board of Size by Size squares. It tests triangles whose normals are interpolated.
//
// Size:         2    4     8    12     24
// Triangles:  240  992  4032  9120  36672   = 64 Size^2 - 8 Size, and Size^2 polygons
#version 3.7;
#ifndef (Size) #declare Size = 12; #end

global_settings { assumed_gamma 1 max_trace_level 5 }
background { rgb <0.078, 0.361, 0.753> }

// Right-handed with z upwards; the height of the picture spans 45 degrees.
camera {
  location <4.86, 7.2, 5.4>
  sky z
  right -x*image_width/image_height
  angle 2*degrees(atan2(tan(radians(22.5))*image_width/image_height, 1))
  look_at <0.1, 0, 1>
}
// Lights share the brightness of one: each of n has 1/sqrt(n).
#declare Light = rgb 1/sqrt(2);
light_source { <-3.1, 9.8, 12.1> Light }
light_source { <11.3, 5.1, 8.8> Light }

// Bernstein's weights of four control points, and their derivatives, at I/Size for each I, and last
// close to 0.
#declare Weights = array[Size + 2][4];
#declare Slopes = array[Size + 2][4];
#declare Beside = Size + 1;
#declare I = 0;
#while (I <= Beside)
  #declare T = (I = Beside ? 1e-4 : I/Size);
  #declare Weights[I][0] = pow(1 - T, 3);
  #declare Weights[I][1] = 3*T*pow(1 - T, 2);
  #declare Weights[I][2] = 3*T*T*(1 - T);
  #declare Weights[I][3] = T*T*T;
  #declare Slopes[I][0] = -3*pow(1 - T, 2);
  #declare Slopes[I][1] = 3*(1 - T)*(1 - 3*T);
  #declare Slopes[I][2] = 3*T*(2 - 3*T);
  #declare Slopes[I][3] = 3*T*T;
  #declare I = I + 1;
#end

// The sum of 16 control points, each times its weights: of Down, at U down the rows, and of Along,
// at V along them.
#macro Blend(P, Down, U, Along, V)
  #local Sum = <0, 0, 0>;
  #local I = 0;
  #while (I < 16)
    #local Sum = Sum + Down[U][div(I, 4)]*Along[V][mod(I, 4)]*P[I];
    #local I = I + 1;
  #end
  Sum
#end

// The product of the tangents of a patch.
#macro Tangents(P, U, V)
  vcross(Blend(P, Slopes, U, Weights, V), Blend(P, Weights, U, Slopes, V))
#end

// The point and the normal at cell corner K.
#macro Evaluate(P, K)
  #local U = div(K, Size + 1);
  #local V = mod(K, Size + 1);
  #declare Points[K] = Blend(P, Weights, U, Weights, V);
  #local N = Tangents(P, U, V);
  #if (vlength(N) < 1e-6)
    // The first row of control points is a single point: the normal beside it is the same.
    #local N = Tangents(P, Beside, V);
  #end
  #declare Normals[K] = vnormalize(N);
#end

#declare Corners = (Size + 1)*(Size + 1);
#declare Points = array[Corners];
#declare Normals = array[Corners];

// A triangle of three cell corners, mirrored, unless it has shrunk to a line. It is flat where the
// cells are so large that its normals point to both of its sides.
#macro Facet(A, B, C, Flip)
  #local Face = vcross(Points[B] - Points[A], Points[C] - Points[A]);
  #if (vlength(Face) > 1e-6)
    #local SideA = vdot(Face, Normals[A]);
    #if (min(SideA*vdot(Face, Normals[B]), SideA*vdot(Face, Normals[C])) > 0)
      smooth_triangle {
        Points[A]*Flip, Normals[A]*Flip, Points[B]*Flip, Normals[B]*Flip,
        Points[C]*Flip, Normals[C]*Flip
      }
    #else
      triangle { Points[A]*Flip, Points[B]*Flip, Points[C]*Flip }
    #end
  #end
#end

// The triangles of a patch, and of its mirror images: Flips says which there are.
#macro Patch(P, Flips)
  #local K = 0;
  #while (K < Corners)
    Evaluate(P, K)
    #local K = K + 1;
  #end
  #local F = 0;
  #while (F < dimension_size(Flips, 1))
    #local K = 0;
    #while (K < Size*(Size + 1))
      #if (mod(K, Size + 1) < Size)
        Facet(K, K + 1, K + Size + 1, Flips[F])
        Facet(K + 1, K + Size + 2, K + Size + 1, Flips[F])
      #end
      #local K = K + 1;
    #end
    #local F = F + 1;
  #end
#end

#declare Quarters = array[4] { <1, 1, 1>, <-1, 1, 1>, <1, -1, 1>, <-1, -1, 1> }
#declare Halves = array[2] { <1, 1, 1>, <1, -1, 1> }

// A part that is round: four control points of its profile, each a radius and a height. A quarter
// of a circle of radius 1 has the control points (1, 0), (1, 0.56), (0.56, 1) and (0, 1).
#macro Turned(R1, H1, R2, H2, R3, H3, R4, H4)
  #local Radii = array[4] { R1, R2, R3, R4 }
  #local Heights = array[4] { H1, H2, H3, H4 }
  #local P = array[16];
  #local I = 0;
  #while (I < 4)
    #local P[4*I] = <Radii[I], 0, Heights[I]>;
    #local P[4*I + 1] = <Radii[I], 0.56*Radii[I], Heights[I]>;
    #local P[4*I + 2] = <0.56*Radii[I], Radii[I], Heights[I]>;
    #local P[4*I + 3] = <0, Radii[I], Heights[I]>;
    #local I = I + 1;
  #end
  Patch(P, Quarters)
#end

// Half of a tube around y = 0: of each of four rows the outer end and the inner end, each x and z,
// and how far the tube bulges between them.
#macro Bent(Outer, Inner, Bulge)
  #local P = array[16];
  #local I = 0;
  #while (I < 4)
    #local P[4*I] = Outer[I];
    #local P[4*I + 1] = Outer[I] + Bulge[I]*y;
    #local P[4*I + 2] = Inner[I] + Bulge[I]*y;
    #local P[4*I + 3] = Inner[I];
    #local I = I + 1;
  #end
  Patch(P, Halves)
#end

union {
  // The rim, the body above and below its widest circle, the bottom, the knob and the lid.
  Turned(1.4, 2.4, 1.3375, 2.53125, 1.4375, 2.53125, 1.5, 2.4)
  Turned(1.5, 2.4, 1.75, 1.875, 2, 1.35, 2, 0.9)
  Turned(2, 0.9, 2, 0.45, 1.5, 0.225, 1.5, 0.15)
  Turned(0, 0, 1.425, 0, 1.5, 0.075, 1.5, 0.15)
  Turned(0, 3.15, 0.8, 3.15, 0, 2.85, 0.2, 2.7)
  Turned(0.2, 2.7, 0.4, 2.55, 1.3, 2.55, 1.3, 2.4)

  // The handle, from above to below, and the spout, from the body to its mouth.
  #declare Side = array[4] { <-1.6, 0, 2.025>, <-2.3, 0, 2.025>, <-2.7, 0, 2.025>, <-2.7, 0, 1.8> }
  #declare Back = array[4] { <-1.5, 0, 2.25>, <-2.5, 0, 2.25>, <-3, 0, 2.25>, <-3, 0, 1.8> }
  #declare Bulge = array[4] { 0.3, 0.3, 0.3, 0.3 }
  Bent(Side, Back, Bulge)
  #declare Side = array[4] { <-2.7, 0, 1.8>, <-2.7, 0, 1.575>, <-2.5, 0, 1.125>, <-2, 0, 0.9> }
  #declare Back = array[4] { <-3, 0, 1.8>, <-3, 0, 1.35>, <-2.65, 0, 0.9375>, <-1.9, 0, 0.6> }
  Bent(Side, Back, Bulge)
  #declare Side = array[4] { <1.7, 0, 1.425>, <2.6, 0, 1.425>, <2.3, 0, 2.1>, <2.7, 0, 2.4> }
  #declare Back = array[4] { <1.7, 0, 0.6>, <3.1, 0, 0.825>, <2.4, 0, 2.025>, <3.3, 0, 2.4> }
  #declare Bulge = array[4] { 0.66, 0.66, 0.25, 0.25 }
  Bent(Side, Back, Bulge)
  #declare Side = array[4] { <2.7, 0, 2.4>, <2.8, 0, 2.475>, <2.9, 0, 2.475>, <2.8, 0, 2.4> }
  #declare Back = array[4] { <3.3, 0, 2.4>, <3.525, 0, 2.49375>, <3.45, 0, 2.5125>, <3.2, 0, 2.4> }
  #declare Bulge = array[4] { 0.25, 0.25, 0.15, 0.15 }
  Bent(Side, Back, Bulge)

  pigment { rgb <1, 0.5, 0.1> }
  finish { ambient 0.1 diffuse 0.7 phong 0.3 phong_size 30 reflection 0.1 }
}

// The board spans 10 units and touches the bottom.
#macro Square(I, J) <I/Size - 0.5, J/Size - 0.5, 0>*10 #end
#declare Colours = array[2] { rgb <1, 0.75, 0.33>, rgb <0.25, 0.15, 0.10> }
#declare Colour = 0;
#while (Colour < 2)
  union {
    #declare K = 0;
    #while (K < Size*Size)
      #declare I = div(K, Size);
      #declare J = mod(K, Size);
      #if (mod(I + J, 2) = Colour)
        polygon {
          5, Square(I, J), Square(I + 1, J), Square(I + 1, J + 1), Square(I, J + 1), Square(I, J)
        }
      #end
      #declare K = K + 1;
    #end
    pigment { Colours[Colour] }
    finish { ambient 0.1 diffuse 0.8 }
  }
  #declare Colour = Colour + 1;
#end
