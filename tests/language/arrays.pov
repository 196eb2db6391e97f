// SPDX-License-Identifier: Apache-2.0
// Arrays and splines.
#version 3.7;
global_settings { assumed_gamma 1 }
#macro Show(Value) #debug concat("= ", str(Value, 0, 9), "\n") #end
#macro Show3(Value) #debug concat("= ", vstr(3, Value, ", ", 0, 9), "\n") #end
#macro Say(Text) #debug concat("= ", Text, "\n") #end
// -- declaration
#declare A = array[3]; #declare A[0] = 1; #declare A[1] = A[0] + 1; #declare A[2] = A[1]*A[1];
Show(A[0]) Show(A[1]) Show(A[2]) Show(dimensions(A)) Show(dimension_size(A, 1))
// -- initialiser
#declare A = array[3] { 1, 2, 3 } #declare B = array[2][3] { { 1, 2, 3 }, { 4, 5, 6 } }
#declare C = array[3] { 1, 2, 3, } #declare D = array[2] { <1,2,3>, x }
Show(A[2]) Show(B[1][0]) Show(dimensions(B)) Show(dimension_size(B, 2)) Show(C[2]) Show3(D[1])
// -- local
#macro F() #local L = array[2] { 7, 8 } Show(L[1]) #end F()
// -- of texts and objects
#declare T = array[2] { "one", "two" } Say(T[1])
#declare O = array[2] { sphere { 0, 1 }, box { -1, 1 } }
Show(inside(O[0], 0)) Show(inside(O[1], 2))
// -- whole arrays
#declare A = array[2] { 1, 2 } #declare B = A; #declare B[0] = 5; Show(A[0]) Show(B[0])
// -- arrays of arrays
#declare A = array[2] { 1, 2 } #declare B = array[2]; #declare B[0] = A; #declare B[1] = A;
Show(B[1][1]) Show(dimension_size(B[0], 1))
// -- five dimensions
#declare A = array[2][2][2][2][2]; #declare A[1][0][1][0][1] = 9; Show(A[1][0][1][0][1]) Show(dimensions(A))
// -- elements known
#declare A = array[2]; #declare A[0] = 1;
#ifdef (A[0]) Say("first") #end #ifdef (A[1]) Say("second") #end #ifndef (A[1]) Say("not second") #end
#undef A[0] #ifndef (A[0]) Say("no first") #end
// -- changed by a macro
#macro Set(V) #declare V = V + 1; #end
#declare A = array[2] { 1, 2 } Set(A[1]) Show(A[1])
// -- index beyond the end (fails)
#declare A = array[2] { 1, 2 } Show(A[2])
// -- index below zero (fails)
#declare A = array[2] { 1, 2 } Show(A[-1])
// -- no value (fails)
#declare A = array[2]; Show(A[0])
// -- linear spline
#declare S = spline { linear_spline 0, <0,0,0> 1, <1,2,3> 3, <3,0,1> }
Show3(S(0)) Show3(S(.5)) Show3(S(2)) Show3(S(-1)) Show3(S(4))
// -- default spline
#declare S = spline { 0, <0,0,0>, 1, <1,2,3>, 3, <3,0,1> } Show3(S(.25))
// -- quadratic spline
#declare S = spline { quadratic_spline 0, <0,0,0> 1, <1,2,3> 3, <3,0,1> 4, x }
Show3(S(.5)) Show3(S(1)) Show3(S(2.5)) Show3(S(3.5)) Show3(S(-1)) Show3(S(5))
// -- cubic spline
#declare S = spline { cubic_spline -1, <0,0,-1> 0, <0,0,0> 1, <1,2,3> 3, <3,0,1> 4, x 5, y }
Show3(S(.5)) Show3(S(1)) Show3(S(2.5)) Show3(S(3.5)) Show3(S(-1)) Show3(S(5)) Show3(S(4.5)) Show3(S(-.5))
// -- natural spline
#declare S = spline { natural_spline 0, <0,0,0> 1, <1,2,3> 3, <3,0,1> 4, x }
Show3(S(.5)) Show3(S(1)) Show3(S(2.5)) Show3(S(3.5)) Show3(S(-1)) Show3(S(5))
// -- evaluated as another kind
#declare S = spline { linear_spline -1, <0,0,-1> 0, <0,0,0> 1, <1,2,3> 3, <3,0,1> }
Show3(S(.5, cubic_spline)) Show3(S(.5, quadratic_spline)) Show3(S(.5, natural_spline)) Show3(S(.5, linear_spline))
// -- from another spline
#declare S = spline { linear_spline 0, <0,0,0> 1, <1,2,3> } #declare R = spline { S 2, <5,5,5> }
#declare Q = spline { S } Show3(R(1.5)) Show3(Q(.5))
// -- out of order and twice
#declare S = spline { linear_spline 2, <2,0,0> 0, <0,0,0> 1, <1,1,1> 1, <1,5,5> } Show3(S(.5)) Show3(S(1))
// -- sizes
#declare S = spline { linear_spline 0, <0,0> 1, <1,2> } Show(S(.5).u) Show(S(.5).v)
#declare S = spline { linear_spline 0, <0,0,0,0,0> 1, <1,2,3,4,5> } Show(S(.5).transmit) Show(S(.5).filter)
// -- of numbers
#declare S = spline { linear_spline 0, 1 1, 3 } Show3(S(.5))
// -- in an expression
#declare S = spline { linear_spline 0, <0,0,0> 1, <1,2,3> } Show3(2*S(.5)+x) Show(S(.5).y) Show(vlength(S(1)))
