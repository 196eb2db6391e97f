// SPDX-License-Identifier: Apache-2.0
// Numeric expressions and functions.
#version 3.7;
global_settings { assumed_gamma 1 }
#macro Show(Value) #debug concat("= ", str(Value, 0, 9), "\n") #end
// -- literals
Show(-2.0) Show(-4) Show(34) Show(3.4e6) Show(2e-5) Show(.3) Show(0.6) Show(1E+2) Show(5.) Show(+7)
// -- constants
Show(pi) Show(true) Show(yes) Show(on) Show(false) Show(no) Show(off)
// -- built-in variables
Show(clock) Show(clock_delta) Show(clock_on) Show(frame_number) Show(initial_clock)
Show(final_clock) Show(initial_frame) Show(final_frame) Show(image_width) Show(image_height)
Show(version)
// -- operators
Show(1+2*3-4/2) Show(-(2+3)) Show(!0) Show(!3) Show(2*-3) Show(10/4/2) Show(2-3-4) Show(+-+2)
// -- relations
Show((1<2)) Show((1<=1)) Show((1=1)) Show((1!=1)) Show((2>=3)) Show((2>1)) Show((1=1+1e-11))
Show((1<1+1e-11)) Show((1e-11<2e-11)) Show((1=1+1e-9))
// -- logic
Show((1&0)) Show((1|0)) Show((2&3)) Show((1<2 & 3>2)) Show((0|0|1)) Show((1 & !0)) Show((1|0&0))
Show((1e-11|0)) Show((1e-9|0))
// -- conditional
Show((1?2:3)) Show((0?2:3)) Show((1<2?(3<2?4:5):6)) Show((0?1:0?2:3)) Show((1=1?7:8)+1)
// -- text relations
Show(("a"="a")) Show(("a"<"b")) Show(("a">"b")) Show(("ab"!="a")) Show(("b">="b")) Show(("b"<="a"))
// -- rounding
Show(abs(-2.5)) Show(ceil(2.1)) Show(ceil(-2.1)) Show(floor(2.9)) Show(floor(-2.1)) Show(int(2.9))
Show(int(-2.9)) Show(div(7,2)) Show(div(-7,2)) Show(mod(7,3)) Show(mod(-7,3)) Show(mod(5.5,2))
Show(mod(7,-3))
// -- circular functions
Show(sin(1)) Show(cos(1)) Show(tan(1)) Show(asin(.5)) Show(acos(.5)) Show(atan2(1,2)) Show(atan2(-1,-2))
Show(atan2(1,0)) Show(degrees(pi)) Show(radians(90))
// -- hyperbolic functions
Show(sinh(1)) Show(cosh(1)) Show(tanh(1)) Show(asinh(1)) Show(acosh(2)) Show(atanh(.5))
// -- powers
Show(exp(1)) Show(ln(2)) Show(log(1000)) Show(pow(2,10)) Show(pow(2,-.5)) Show(pow(-2,3)) Show(sqrt(2))
Show(pow(0,2)) Show(sqrt(0))
// -- extremes
Show(max(1,2)) Show(min(1,2)) Show(max(1,5,2,3)) Show(min(4,1,-3,2))
// -- bits
Show(bitwise_and(12,10)) Show(bitwise_or(12,10)) Show(bitwise_xor(12,10)) Show(bitwise_and(15,7,3))
Show(bitwise_or(1,2,4,8)) Show(bitwise_xor(15,7,3.9))
// -- select
Show(select(-1,2,3)) Show(select(0,2,3)) Show(select(1,2,3)) Show(select(-1,2,3,4)) Show(select(0,2,3,4))
Show(select(1,2,3,4))
// -- defined
#declare Known = 1;
Show(defined(Known)) Show(defined(Unknown))
// -- random numbers
#declare R = seed(1); #declare S = seed(12345);
Show(rand(R)) Show(rand(R)) Show(rand(S)) Show(rand(R)) Show(rand(S)) #declare R = seed(1); Show(rand(R))
Show(seed(-3)) Show(rand(seed(0)))
// -- inside
#declare Ball = sphere { 0, 1 }
#declare Cut = difference { box { -1, 1 } sphere { 0, .5 } }
Show(inside(Ball, 0)) Show(inside(Ball, <0,0,2>)) Show(inside(Cut, 0)) Show(inside(Cut, .9))
// -- trace
#declare Ball = sphere { 0, 1 pigment { rgb 1 } }
#declare N = <9,9,9>;
#declare P = trace(Ball, <0,.5,-5>, z, N);
Show(P.x) Show(P.y) Show(P.z) Show(N.x) Show(N.y) Show(N.z)
#declare P = trace(Ball, <0,2,-5>, z, N); Show(P.z) Show(vlength(N))
#declare P = trace(Ball, <0,0,-5>, 3*z); Show(P.z)
// -- file_exists
Show(file_exists("floats.pov")) Show(file_exists("nothing-of-this-name.inc"))
// -- val
Show(val("123.45")) Show(val("-1e3")) Show(val("2*3")) Show(val("  7 "))
// -- asc and strlen
Show(asc("ABC")) Show(strlen("hello")) Show(strlen("")) Show(strcmp("a","b")) Show(strcmp("b","b"))
// -- dot items
#declare V = <1,2,3,4,5>;
Show(V.x) Show(V.y) Show(V.z) Show(V.t) Show(V.filter) Show(V.transmit) Show(V.red) Show(V.green)
Show(V.blue) Show(V.gray) Show(V.u) Show(V.v) Show(<7,8,9>.y)
// -- vector functions
Show(vdot(<1,2,3>,<4,5,6>)) Show(vlength(<3,4,12>))
// -- missing bracket (fails)
Show((1+2)
// -- unknown name (fails)
Show(Nothing)
// -- division by zero
Show(1/0)
// -- too few arguments (fails)
Show(pow(2))
// -- atan
Show(atan(1))
// -- sqr outside functions (fails)
Show(sqr(3))
// -- prod in an expression (fails)
Show(prod(i, 1, 3, i))
// -- redeclared built-in (fails)
#declare pi = 3;
// -- variables of the picture declared anew
#declare image_width = image_width*2; #declare frame_number = 3; #declare final_clock = 5;
Show(image_width) Show(frame_number) Show(final_clock) Show(image_height)
// -- clock declared anew (fails)
#declare clock = 1;
