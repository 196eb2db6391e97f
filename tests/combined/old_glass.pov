// SPDX-License-Identifier: Apache-2.0
// Coloured glass of a file without a version: a filter takes less of the surface's own light.
camera { location <0, 2, -6> look_at <0, 0.5, 0> }
light_source { <-5, 8, -6> color rgb <1, 1, 1> }
sphere { <-1.2, 0.5, 0>, 1 texture { pigment { color rgbf <0.9, 0.3, 0.2, 0.6> } finish { phong 0.8 ambient 0.3 } } }
box { <0.2, -0.45, -0.5> <1.8, 1, 0.5> pigment { color rgbf <0.2, 0.4, 0.9, 0.8> } }
cone { <-2.6, -0.5, -1> 0.5 <-2.6, 1.4, -1> 0.1 texture { pigment { color rgb <0.8, 0.8, 0.8> } } texture { pigment { color rgbft <0.9, 0.7, 0.1, 0.3, 0.3> } } }
plane { <0, 1, 0>, -0.5 pigment { checker color rgb <0.5, 0.5, 0.5> color rgb <0.25, 0.25, 0.25> } }
