// SPDX-License-Identifier: Apache-2.0
#version 3.7;
global_settings { assumed_gamma 1 }

// Sphere sweeps of every kind, whole and cut, on a mirror.
camera { location <0, 4, -9> look_at <0, 0.4, 0> angle 42 }
light_source { <-8, 12, -10> rgb 1 }
sphere_sweep { linear_spline 4, <-3,0,0>, 0.3, <-2,1.5,0>, 0.5, <-1,0,0.5>, 0.2, <-1.4,0.6,-1>, 0.3 pigment { rgb <1, 0.5, 0.3> } }
sphere_sweep { cubic_spline 6, <0,-1,0>, 0.3, <-0.5,0,0>, 0.3, <0.5,1,0>, 0.4, <0.8,2,0>, 0.2, <1.6,1,0>, 0.3, <2,0,0>, 0.2 tolerance 0.0001 pigment { rgb <0.3, 0.8, 0.4> } }
difference {
  sphere_sweep { b_spline 6, <1.5,0,-2>, 0.5, <2,0.5,-1>, 0.5, <3,1,0>, 0.6, <3,0,1>, 0.5, <2,-0.5,2>, 0.4, <1,0,2>, 0.4 tolerance 0.0001 }
  box { <0, 0.45, -3>, <5, 3, 3> }
  pigment { rgb <0.4, 0.5, 1> } finish { phong 0.5 }
}
plane { y, -1 pigment { rgb 0.4 } finish { reflection 0.4 } }
