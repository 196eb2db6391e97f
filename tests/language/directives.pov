// SPDX-License-Identifier: Apache-2.0
// Language directives.
#version 3.7;
global_settings { assumed_gamma 1 }
#macro Show(Value) #debug concat("= ", str(Value, 0, 9), "\n") #end
#macro Say(Text) #debug concat("= ", Text, "\n") #end
// -- comments
// a line
/* a block /* within a block */ // and a line
*/ Say("seen") // behind
// -- if
#if (1) Say("yes") #end #if (0) Say("no") #else Say("else") #end
#if (0) #if (1) Say("inner") #else Say("other") #end #else #if (1) Say("right") #end #end
// -- elseif
#declare N = 2; #if (N=1) Say("one") #elseif (N=2) Say("two") #elseif (N=3) Say("three") #else Say("none") #end
// -- ifdef
#declare K = 1; #ifdef (K) Say("known") #else Say("unknown") #end #ifdef (J) Say("known") #else Say("unknown") #end
#ifndef (J) Say("not known") #end #undef K #ifdef (K) Say("still") #end
// -- while
#declare I = 0; #while (I < 3) Show(I) #declare I = I + 1; #end
#declare I = 0; #while (1) #if (I = 2) #break #end Show(I) #declare I = I + 1; #end
// -- for
#for (I, 1, 3) Show(I) #end #for (I, 0, 1, .5) Show(I) #end #for (I, 3, 1, -1) Show(I) #end #for (I, 2, 1) Show(I) #end
#for (I, 1, 9) #if (I = 3) #break #end Show(I) #end
// -- switch
#macro Which(N) #switch (N) #case (1) Say("one") #break #case (2) Say("two") #range (3, 5) Say("three to five") #break
#range (7, 8) Say("seven") #else Say("other") #end #end
Which(1) Which(2) Which(4) Which(5) Which(7) Which(9) Which(2.5)
// -- switch without else
#switch (3) #case (1) Say("one") #break #case (2) Say("two") #break #end Say("after")
// -- nested loops
#for (I, 1, 2) #for (J, 1, 2) #if (J = 2) #break #end Show(10*I+J) #end #end
// -- macros
#macro M(A, B) (A + B) #end Show(M(1, 2)) Show(M(1, 2)*3) #macro Nothing() #end Nothing()
#macro Sum(N, S) #if (N = 0) Show(S) #else Sum(N - 1, S + N) #end #end Sum(5, 0)
// -- macro parameters
#macro Change(V) #declare V = 5; #end #declare W = 1; Change(W) Show(W) #declare W = 1; Change(+W) Show(W)
#macro Local() #local W = 9; #end Local() Show(W) #macro Other(V) #local V = 7; Show(V) #end Other(W) Show(W)
// -- macro of text
#macro T(S) concat(S, "!") #end Say(T("a")) #debug concat("= ", T("b"), "\n")
// -- macros and objects
#macro Ball(R) sphere { 0, R } #end #declare B = object { Ball(2) } Show(inside(B, <0,0,1.5>))
#declare C = Ball(1) Show(inside(C, <0,0,1.5>))
// -- macros that define macros
#macro Outer() #macro Inner() Say("inner") #end #end Outer() Inner()
// -- macro called with too few (fails)
#macro M(A, B) A #end Show(M(1))
// -- scopes
#declare A = 1; #macro F() #local A = 2; G() #end #macro G() Show(A) #declare A = 3; Show(A) #end F() Show(A)
// -- undef
#declare A = 1; #macro F() #local A = 2; #undef A Show(A) #end F() Show(A)
// -- declare deprecated
#declare deprecated A = 1; #declare deprecated once B = 2; #declare deprecated "Use C" C = 3; Show(A+B+C)
#declare deprecated once "Use D" D = 4; Show(D)
// -- messages
#warning "careful\n" #debug "= debug\n" #render "= render\n" #statistics "= statistics\n" 
// -- error (fails)
#error "stop\n"
// -- version
Show(version) #version 3.1; Show(version) #version 3.7; Show(version) #version unofficial 3.7; Show(version)
// -- version kept and given back
#declare V = version; #version 3.5; Show(version) #version V; Show(version)
// -- default
#default { pigment { rgb <1,0,0> } finish { ambient 1 diffuse 0 } }
#default { texture { pigment { rgb <0,1,0> } } }
camera { orthographic location -5*z right 4*x up 3*y look_at 0 }
sphere { 0, 1 finish { ambient 1 diffuse 0 } } box { -1, 1 translate 2*x finish { ambient .5 diffuse 0 } }
// -- files
#fopen W "language_test.txt" write #write (W, "1,", 2, ",<3,4,5>,\"text\",", <6,7,8>, ",", str(9,0,1), "\n") #fclose W
#fopen W "language_test.txt" append #write (W, "10\n") #fclose W
#fopen R "language_test.txt" read #read (R, A, B, C, D, E, F) Show(A) Show(B) Show(C.y) Say(D) Show(E.z) Show(F)
#ifdef (R) Say("open") #end #fclose R #ifdef (R) Say("still open") #else Say("closed") #end
// -- reading to the end
#fopen W "language_test.txt" write #write (W, "1,2,3") #fclose W #fopen R "language_test.txt" read
#while (defined(R)) #read (R, A) Show(A) #end
// -- include
#fopen W "language_test.inc" write #write (W, "Say(\"included\") #local L = 3; Show(L)\n") #fclose W
#include "language_test.inc" #ifdef (L) Say("L is left") #end #include concat("language_", "test.inc")
// -- include that is missing (fails)
#include "nothing_of_this_name.inc"
// -- end too many (fails)
#end
// -- if without end (fails)
#if (1)
// -- macro without end (fails)
#macro M()
// -- unknown directive (fails)
#nonsense
// -- directives within statements
camera { orthographic location -5*z right 4*x up 3*y look_at 0 }
background { rgb z } sphere { #declare R = 1; 0, R #if (1) pigment { rgb #if (0) 1 #else x #end } #end finish { #for (I,1,1) ambient 1 #end diffuse 0 } }
box { -.5, .5 translate 1.5*x pigment { rgb y } finish { ambient 1 } }
