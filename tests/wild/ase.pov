#include "colors.inc"
#include "finish.inc"

global_settings {assumed_gamma 1 max_trace_level 6}
background {color White transmit 0.0}
camera {orthographic angle 5
  right -10.92*x up 8.19*y
  direction 50.00*z
  location <0,0,50.00> look_at <0,0,0>}
light_source {<  2.00,   3.00,  40.00> color White
  area_light <0.70, 0, 0>, <0, 0.70, 0>, 5, 5
  adaptive 1 jitter}
// no fog
#declare simple = finish {phong 0.7}
#declare pale = finish {ambient 0.5 diffuse 0.85 roughness 0.001 specular 0.200 }
#declare jmol = finish {ambient .2 diffuse .6 specular 1 roughness .001 metallic}
#declare Rcell = 0.070;
#declare Rbond = 0.100;

#macro atom(LOC, R, COL, TRANS FIN)
  sphere{LOC, R texture{pigment{color COL transmit TRANS} finish{FIN}}}
#end
#macro constrain(LOC, R, COL, TRANS FIN)
union{torus{R, Rcell rotate 45*z texture{pigment{color COL transmit TRANS} finish{FIN}}}
     torus{R, Rcell rotate -45*z texture{pigment{color COL transmit TRANS} finish{FIN}}}
     translate LOC}
#end

cylinder {< -4.00,  -3.00,  -9.00>, <  4.00,  -3.00,  -9.00>, Rcell pigment {Black}}
cylinder {< -4.00,   3.00,  -9.00>, <  4.00,   3.00,  -9.00>, Rcell pigment {Black}}
atom(< -2.20,  -0.40,  -1.90>, 1.36, rgb <0.56, 0.88, 0.31>, 0.0, simple) // #0
atom(<  0.30,   0.90,  -3.20>, 1.02, rgb <1.00, 0.05, 0.05>, 0.0, pale) // #1
atom(<  2.30,  -0.80,  -2.60>, 1.24, rgb <0.30, 0.65, 1.00>, 0.3, jmol) // #2
cylinder {< -2.20,  -0.40,  -1.90>, <  0.30,   0.90,  -3.20>, Rbond texture{pigment {color rgb <0.56, 0.88, 0.31> transmit 0.0} finish{pale}}}
cylinder {<  0.30,   0.90,  -3.20>, <  2.30,  -0.80,  -2.60>, Rbond texture{pigment {color rgb <1.00, 0.05, 0.05> transmit 0.0} finish{pale}}}
constrain(<  2.30,  -0.80,  -2.60>, 1.24, Black, 0, pale) // #2
