// SPDX-License-Identifier: Apache-2.0
// Tetra, after the scene of that name among the Standard Procedural Databases of E. Haines, "A
// Proposal for Standard Graphics Environments", IEEE Computer Graphics and Applications 7(11),
// 1987.
//
// Sierpinski's tetrahedron: four of half the size in its corners, and nothing in the middle, each
// made in the same way. It tests rays that pass through a cloud with many holes; most of the
// picture is background.
//
// Size:         1   2   3     4     5     6      8
// Triangles:    4  16  64   256  1024  4096  65536   = 4^Size
#version 3.7;
#ifndef (Size) #declare Size = 6; #end

global_settings { assumed_gamma 1 max_trace_level 5 }
background { rgb <0.078, 0.361, 0.753> }

// Right-handed with z upwards; the height of the picture spans 45 degrees.
camera {
  location <1.02, -3.20, 1.52>
  sky z
  right -x*image_width/image_height
  angle 2*degrees(atan2(tan(radians(22.5))*image_width/image_height, 1))
  look_at <0, 0, 0.72>
}
light_source { <1.9, -18.1, 6.3> rgb 1 }

// The tetrahedron of the corners A, B, C and D.
#macro Tetra(Level, A, B, C, D)
  #if (Level > 1)
    Tetra(Level - 1, A, (A + B)/2, (A + C)/2, (A + D)/2)
    Tetra(Level - 1, (B + A)/2, B, (B + C)/2, (B + D)/2)
    Tetra(Level - 1, (C + A)/2, (C + B)/2, C, (C + D)/2)
    Tetra(Level - 1, (D + A)/2, (D + B)/2, (D + C)/2, D)
  #else
    triangle { A, B, C }
    triangle { A, B, D }
    triangle { A, C, D }
    triangle { B, C, D }
  #end
#end

union {
  // One that is regular, on the ground, with its top above the origin.
  Tetra(Size, <0, 0, sqrt(2)>*1.1, <1, 0, 0>*1.1, <-0.5, sqrt(0.75), 0>*1.1,
        <-0.5, -sqrt(0.75), 0>*1.1)
  pigment { rgb <1, 0.2, 0.2> }
  finish { ambient 0.1 diffuse 1 }
}
