// SPDX-License-Identifier: Apache-2.0
// A file without a version and without a gamma, as they were written for decades.
camera { location <0, 2, -6> look_at <0, 0.5, 0> }
light_source { <-5, 8, -6> color rgb <1, 1, 1> }
sphere { <0, 0.5, 0>, 1 texture { pigment { color red 1 green 0.5 } finish { phong 0.8 ambient 0.2 } } }
box { <1.2, -0.5, -0.5> <2, 1, 0.5> pigment { color rgb <0.2, 0.4, 0.9> } }
cone { <-2, -0.5, 0> 0.7 <-2, 1.4, 0> 0.1 pigment { marble turbulence 1 } normal { bumps 0.4 scale 0.2 } }
plane { <0, 1, 0>, -0.5 pigment { checker color rgb <0.5, 0.5, 0.5> color rgb <0.25, 0.25, 0.25> } }
fog { distance 30 color rgb <0.5, 0.6, 0.7> }
