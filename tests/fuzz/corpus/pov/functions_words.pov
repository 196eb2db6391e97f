#declare F = function(a, b) { select(a - b, sin(a), max(b, pow(2, 0.5), a/b)) + f_noise3d(a, b, 1) }
#declare F = function(x, y) { sum(i, 1, 5, i*x) - prod(j, 1, 3, y + j) }
#declare G = function { pattern { bozo turbulence 0.3 } }
#declare H = function { pigment { gradient x color_map { [0 rgb 0] [1 rgbt 1] } } }
#declare T = function { transform { rotate 30*x scale 2 inverse } }
#declare V = G(1, 2, 3) + H(F(1, 2), 0, 0).red; #declare W = T(1, 2, 3);
