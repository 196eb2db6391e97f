// SPDX-License-Identifier: Apache-2.0
// Vectors and colours.
#version 3.7;
global_settings { assumed_gamma 1 }
#macro Show(Value) #debug concat("= ", vstr(5, Value*<1,1,1,1,1>, ", ", 0, 9), "\n") #end
#macro Show3(Value) #debug concat("= ", vstr(3, Value, ", ", 0, 9), "\n") #end
// -- literals
Show3(<1,2,3>) Show(<1,2,3,4,5>) Show3(<1+1,2*2,-3>) Show3(x) Show3(y) Show3(z) Show3(2*x+3*y-z)
#debug concat("= ", vstr(2, <1,2>, ",", 0, 3), "\n")
// -- operators
Show3(<1,2,3>+<4,5,6>) Show3(<1,2,3>-1) Show3(<1,2,3>*<2,2,3>) Show3(<1,2,3>/2) Show3(-<1,2,3>)
Show3(2/<1,2,4>) Show3(+<1,2,3>) Show(<1,2,3,4>+<1,1,1,1,1>) Show3(<1,2>+<1,1,1>)
// -- promotion
Show(5) Show(<1,2>) Show(<1,2,3>) Show(rgb 1) Show(rgbt <1,2,3,4>)
// -- functions
Show3(vaxis_rotate(<1,2,3>, y, 30)) Show3(vcross(<1,2,3>,<4,5,6>)) Show3(vnormalize(<1,2,2>))
Show3(vrotate(<1,2,3>, <10,20,30>)) Show3(vturbulence(2, .5, 6, <.1,.2,.3>)) Show3(vaxis_rotate(x, <1,2,3>, 50))
Show3(vnormalize(<0,0,0>))
// -- min_extent
#declare Box = box { <-1,-2,-3>, <1,2,3> rotate 90*y }
Show3(min_extent(Box)) Show3(max_extent(Box))
// -- extents of shapes
#declare A = torus { 2, .5 } #declare B = cone { 0, 1, 2*y, .5 }
#declare C = union { sphere { 0, 1 } box { 2, 3 } } #declare D = intersection { box { 0, 2 } box { 1, 3 } }
Show3(min_extent(A)) Show3(max_extent(A)) Show3(max_extent(B)) Show3(max_extent(C)) Show3(max_extent(D))
Show3(min_extent(D))
// -- colour keywords
Show(rgb <1,2,3>) Show(rgbf <1,2,3,4>) Show(rgbt <1,2,3,4>) Show(rgbft <1,2,3,4,5>) Show(color red .5)
Show(color red 1 green 2 blue 3) Show(colour green 1 filter .5) Show(color blue 1 transmit .25)
Show(color rgb 1) Show(rgb <1,1,1>*.5) Show(color alpha .5)
// -- sRGB
Show(srgb <.5,.25,1>) Show(srgbf <.5,.25,1,.3>) Show(srgbt <.5,.25,1,.3>) Show(srgbft <.5,.25,1,.3,.4>) Show(srgb 255/255)
Show(srgb <.03,.04,.02>) Show(srgb <.5,.5,.5>*2)
// -- sRGB without gamma handling of the file
Show(color srgb <.5,.5,.5>)
// -- colours of identifiers
#declare Red = rgb <1,.1,.2>;
Show(Red) Show(Red*2) Show(Red+x) Show(color Red filter .5) Show(color Red green 1) Show(-Red)
#declare Grey = Red.gray; Show(Grey)
// -- conditional
Show3((1 ? <1,2,3> : <4,5,6>)) Show3((0 ? x : y))
// -- mixed sizes
Show(<1,2,3> * <1,2>) Show(<1,2,3,4>*2)
// -- vectors of six (fails)
Show(<1,2,3,4,5,6>)
// -- missing bracket (fails)
Show3(<1,2,3)
// -- dot of a scalar (fails)
Show(5.x)
