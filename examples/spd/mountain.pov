// SPDX-License-Identifier: Apache-2.0
// Mountain, after the scene of that name among the Standard Procedural Databases of E. Haines, "A
// Proposal for Standard Graphics Environments", IEEE Computer Graphics and Applications 7(11),
// 1987.
//
// A fractal landscape (A. Fournier, D. Fussell and L. Carpenter, "Computer Rendering of Stochastic
// Models", Communications of the ACM 25(6), 1982): two triangles are split into four at the
// middles of their edges, which are moved up or down at random, and so on. Four balls of glass
// hang above. It tests many small triangles that fill the picture, seen through glass too.
//
// Size:          2    4     6      7       8
// Triangles:    32  512  8192  32768  131072   = 2 * 4^Size, and four spheres
#version 3.7;
#ifndef (Size) #declare Size = 6; #end

global_settings { assumed_gamma 1 max_trace_level 5 }
background { rgb <0.078, 0.361, 0.753> }

// Right-handed with z upwards; the height of the picture spans 45 degrees.
camera {
  location <-1.6, 1.6, 1.7>
  sky z
  right -x*image_width/image_height
  angle 2*degrees(atan2(tan(radians(22.5))*image_width/image_height, 1))
  look_at <0, 0, 0.15>
}
light_source { <-100, -100, 100> rgb 1 }

// Heights on a grid of N by N squares; a triangle's edges run along it or along its diagonals.
#declare N = pow(2, Size);
#declare Heights = array[N + 1][N + 1];
#declare Heights[0][0] = 0.0;
#declare Heights[N][0] = 0.15;
#declare Heights[0][N] = 0.1;
#declare Heights[N][N] = 0.05;
#declare Chance = seed(1987);

// Sets the height halfway between two corners, Step squares from each.
#macro Split(I, J, StepI, StepJ, Rough)
  #declare Heights[I][J] = (Heights[I - StepI][J - StepJ] + Heights[I + StepI][J + StepJ])/2
                           + Rough*(rand(Chance) - 0.5);
#end

#declare Step = N/2;
#declare Rough = 0.75;
#while (Step >= 1)
  #declare J = 0;
  #while (J <= N)
    #declare I = 0;
    #while (I <= N)
      #declare OddI = mod(I/Step, 2);
      #declare OddJ = mod(J/Step, 2);
      #if (OddI + OddJ > 0)
        // The diagonals of the squares run from (1, 0) to (0, 1).
        Split(I, J, Step*OddI, (OddI*OddJ > 0 ? -Step : Step*OddJ), Rough)
      #end
      #declare I = I + Step;
    #end
    #declare J = J + Step;
  #end
  #declare Step = Step/2;
  #declare Rough = 0.5*Rough;
#end

#macro Ground(I, J) <2*I/N - 1, 2*J/N - 1, Heights[I][J]> #end

union {
  #declare J = 0;
  #while (J < N)
    #declare I = 0;
    #while (I < N)
      triangle { Ground(I, J), Ground(I + 1, J), Ground(I, J + 1) }
      triangle { Ground(I + 1, J), Ground(I + 1, J + 1), Ground(I, J + 1) }
      #declare I = I + 1;
    #end
    #declare J = J + 1;
  #end
  pigment { rgb <0.50, 0.45, 0.35> }
  finish { ambient 0.1 diffuse 1 }
}

#declare Glass = texture {
  pigment { rgbf <1, 0.95, 0.9, 0.9> }
  finish { ambient 0 diffuse 0.1 phong 0.5 phong_size 60 reflection 0.1 }
}
union {
  sphere { <-0.55, 0.55, 0.62>, 0.17 }
  sphere { <-0.05, 0.05, 0.80>, 0.17 }
  sphere { <-0.85, -0.10, 0.72>, 0.13 }
  sphere { <0.10, 0.85, 0.72>, 0.13 }
  texture { Glass }
  interior { ior 1.5 }
}
