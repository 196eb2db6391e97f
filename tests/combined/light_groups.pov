// SPDX-License-Identifier: Apache-2.0
#version 3.7;
global_settings { assumed_gamma 1 }

// Light groups, lamps with shapes that look like lights, spots through holes.
camera { location <0, 4, -9> look_at <0, 0.8, 0> angle 45 }
light_source { <0, 20, -20> rgb 0.3 }
light_group {
  light_source { <-3, 4, -2> rgb <1, 0.6, 0.3> looks_like { sphere { 0, 0.3 pigment { rgb <1,0.8,0.6> } finish { ambient 1 diffuse 0 } } } }
  sphere { <-2, 0.5, 0>, 1 pigment { rgb 1 } }
  box { <-3.6, -0.5, -1>, <-3, 1, 1> pigment { rgb 1 } }
  global_lights on
}
light_group {
  light_source { <3, 5, -2> rgb <0.4, 0.6, 1> spotlight point_at <2, 0, 0> radius 12 falloff 20 tightness 4 }
  cone { <2, -0.5, 0>, 1, <2, 1.5, 0>, 0.2 pigment { rgb 1 } }
  global_lights off
}
light_source { <0, 5, 1> rgb 0.8 cylinder point_at <0, 0, 1> radius 0.6 falloff 1 }
difference { box { <-0.8, 2, 0.2>, <0.8, 2.1, 1.8> } cylinder { <0, 1, 1>, <0, 3, 1>, 0.3 } pigment { rgb <0.8, 0.9, 0.6> } }
plane { y, -0.5 pigment { rgb 0.9 } }
