#declare C = rgbft <0.1, 0.2, 0.3, 0.4, 0.5>; #declare D = color red 1 green 0.5 blue 0 filter 0.2; #declare E = srgb <0.5, 0.5, 0.5>*2 + C.gray;
sphere { C.red, D.red + E.transmit pigment { color C + D } } sphere { <1, 2>*3 - z/4, vlength(vcross(x, y)) + vdot(x, y) }
#declare V = vrotate(x, <10, 20, 30>) + vaxis_rotate(y, z, 45) + vturbulence(2, 0.5, 6, x); #declare W = trace(sphere { 0, 1 }, -3*z, z);
