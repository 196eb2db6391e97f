#declare S = spline { natural_spline -1, <1, 0, 2> 0, x 1, y+z 2, <3, 4> }
#declare V = S(0.5, linear_spline); sphere { S(0.3), V.y + 1 }
#declare F = function { spline { cubic_spline 0, x 1, y 2, z 3, x } }
