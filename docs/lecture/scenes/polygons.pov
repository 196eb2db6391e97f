// SPDX-License-Identifier: Apache-2.0
// Planar polygons: a concave star, a square with a hole, and a spiral.
#version 3.7;
global_settings { assumed_gamma 1 }

camera { location <0, 0, -7.5> look_at 0 right x*image_width/image_height angle 52 }
light_source { <-4, 6, -9> rgb 1 }
background { rgb <0.93, 0.94, 0.96> }
#default { finish { ambient 0.3 diffuse 0.7 } }

polygon {
  11,
  #for (I, 0, 10) #local R = 1 - 0.6*mod(I, 2); R*<sin(mod(I, 10)*pi/5), cos(mod(I, 10)*pi/5), 0> #end
  pigment { rgb <0.85, 0.45, 0.15> } rotate 20*y translate -2.1*x
}
polygon {
  10,
  <-0.9, -0.9>, <0.9, -0.9>, <0.9, 0.9>, <-0.9, 0.9>, <-0.9, -0.9>
  <-0.4, -0.3>, <0.5, -0.4>, <0.3, 0.5>, <-0.5, 0.3>, <-0.4, -0.3>
  pigment { rgb <0.20, 0.45, 0.70> } rotate 20*y
}
#declare Turns = 24;
polygon {
  2*Turns + 1,
  #for (I, 0, Turns - 1) (0.2 + 0.7*I/(Turns - 1))*<sin(I*0.6), cos(I*0.6), 0> #end
  #for (I, Turns - 1, 0, -1) (0.05 + 0.7*I/(Turns - 1))*<sin(I*0.6), cos(I*0.6), 0> #end
  0.2*<0, 1, 0>
  pigment { rgb <0.25, 0.60, 0.35> } rotate 20*y translate 2.1*x
}
