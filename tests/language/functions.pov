// SPDX-License-Identifier: Apache-2.0
// User-defined functions.
#version 3.7;
global_settings { assumed_gamma 1 }
#macro Show(Value) #debug concat("= ", str(Value, 0, 9), "\n") #end
#macro Show3(Value) #debug concat("= ", vstr(3, Value, ", ", 0, 9), "\n") #end
#macro Show5(Value) #debug concat("= ", vstr(5, Value, ", ", 0, 6), "\n") #end
// -- of x, y, z
#declare F = function { x + 2*y + 3*z } Show(F(1,2,3)) Show(F(1,2,3)*2)
// -- with parameters
#declare F = function(a, b) { a*b + 1 } Show(F(3, 4)) #declare G = function(a) { F(a, a) } Show(G(2))
// -- precedence
#declare F = function(a,b,c) { a + b*c - a/b } Show(F(1,2,3)) #undef F #declare F = function(a) { -a*2 } Show(F(3))
#undef F #declare F = function(a) { 2 - -a } Show(F(3)) #undef F #declare F = function(a,b) { a-b-1 } Show(F(5,2)) 
// -- relations
#declare F = function(a,b) { (a < b) + 2*(a <= b) + 4*(a = b) + 8*(a != b) + 16*(a >= b) + 32*(a > b) }
Show(F(1,2)) Show(F(2,2)) Show(F(3,2)) #undef F #declare F = function(a,b) { (a & b) + 2*(a | b) } Show(F(0,1)) Show(F(2,3))
// -- functions within
#declare F = function(a) { abs(a)+acos(.5)+acosh(2)+asin(.5)+asinh(1)+atan2(1,2)+atanh(.5)+ceil(a)+cos(a)+cosh(a)+degrees(a) } Show(F(.3))
#undef F #declare F = function(a) { exp(a)+floor(a)+int(a)+ln(2)+log(100)+max(a,1,2)+min(a,1,0)+mod(7,3)+pow(2,a)+radians(a)+sin(a) } Show(F(.3))
#undef F #declare F = function(a) { sinh(a)+sqrt(2)+tan(a)+tanh(a)+div(7,2)+atan(a)+select(a,1,2)+select(a,1,2,3) } Show(F(.3))
// -- bitwise within (fails)
#declare F = function(a) { bitwise_and(a, 3) } Show(F(2))
// -- sum and prod
#declare F = function(n) { sum(i, 1, n, i*i) } Show(F(4)) #undef F #declare F = function(n) { prod(i, 1, n, i) } Show(F(5))
#undef F #declare F = function(x, n) { prod(b, 1, n, x/b) } Show(F(2, 3)) Show(F(2, 0)) #undef F #declare F = function { sum(i, 1, 3, sum(j, 1, i, j)) } Show(F(0,0,0))
// -- constants of the scene
#declare K = 3; #declare F = function(a) { a*K } #declare K = 5; Show(F(2))
// -- other names
#declare F = function(r, s, u, v) { r + 10*s + 100*u + 1000*v } Show(F(1,2,3,4)) #undef F #declare F = function(x, y) { x/y } Show(F(1,2))
// -- vectors of splines
#declare F = function { spline { linear_spline 0, <0,0,0> 1, <1,2,3> } } Show3(F(.5)) Show(F(.5).y)
// -- transforms
#declare F = function { transform { rotate 90*z translate <1,2,3> } } Show3(F(1,0,0))
#undef F #declare F = function { transform { scale 2 inverse } } Show3(F(1,2,3))
// -- pigments
#declare F = function { pigment { gradient x color_map { [0 rgb 0] [1 rgbft <1,.5,.25,.1,.2>] } } }
Show(F(.5,0,0).red) Show(F(.5,0,0).green) Show(F(.5,0,0).gray) Show(F(.5,0,0).transmit) Show(F(.5,0,0).filter)
// -- patterns
#declare F = function { pattern { spherical } } Show(F(.5,0,0)) #undef F #declare F = function { pattern { gradient x scale 2 } } Show(F(.5,0,0))
#undef F #declare F = function { pattern { wood turbulence .2 } } Show(F(.5,.1,.2)) #undef F #declare F = function { pattern { bozo } } Show(F(.5,.1,.2))
// -- internal functions
#declare F = function { internal(61) } Show(F(1,2,2,1)) #undef F #declare F = function { internal(25) } Show(F(.3,.4,.5,2,3,.2,.8,1,1,0))
// -- functions as parameters of macros
#declare F = function(a) { a*a } #macro M(Fn, A) Show(Fn(A)) #end M(F, 3) M(function(a) { a+1 }, 3)
// -- functions kept
#declare F = function(a) { a*a } #declare G = function(a) { F(a)+1 } #undef F #declare F = function(a) { 2*a } Show(G(5)) Show(F(5))
// -- division by zero
#declare F = function(a) { 1/a } Show(select(F(2), 1, 2))
// -- vectors within (fails)
#declare F = function(a) { <a, a> } Show(F(1))
// -- unknown name within (fails)
#declare F = function(a) { a*Unknown } Show(F(1))
// -- too few arguments (fails)
#declare F = function(a, b) { a } Show(F(1))
// -- too many arguments (fails)
#declare F = function(a, b) { a } Show(F(1, 2, 3))
// -- dots of parameters
#declare F = function(x, y, z) { x } #macro M(P) F(P.x, P.y, P.z) #end Show(M(<4,5,6>))
// -- recursion (fails)
#declare F = function(a) { F(a - 1) } Show(F(1))
