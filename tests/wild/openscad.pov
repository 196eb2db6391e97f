// Written by a program: each triangle a polygon of its own, closed.
#version 3.7;
global_settings { assumed_gamma 1.0 max_trace_level 8 }
camera { location <8, -12, 9> sky <0, 0, 1> right <-4/3, 0, 0> look_at <0, 0, 1> angle 30 }
background { color rgb <1, 1, 0.90> }
#declare i = 0;
#for (X, -1, 1, 1) #for (Y, -1, 1, 1) #for (Z, -1, 1, 1)
light_source { <X*40+1, Y*40-3, Z*40+2> color rgb <0.08, 0.08, 0.08> }
#end #end #end
#declare MATERIAL = finish { ambient 0.05 diffuse 0.6 specular 0.2 roughness 0.01 conserve_energy reflection { 0.05, 0.1 fresnel on } }
union {
polygon { 4, <-2, -2, 0>, <2, -2, 0>, <0, 0, 3>, <-2, -2, 0> texture { pigment { color rgbf <0.976, 0.843, 0.172, 0> } } finish { MATERIAL } interior { ior 1.32 } }
polygon { 4, <2, -2, 0>, <2, 2, 0>, <0, 0, 3>, <2, -2, 0> texture { pigment { color rgbf <0.976, 0.843, 0.172, 0> } } finish { MATERIAL } interior { ior 1.32 } }
polygon { 4, <2, 2, 0>, <-2, 2, 0>, <0, 0, 3>, <2, 2, 0> texture { pigment { color rgbf <0.976, 0.843, 0.172, 0> } } finish { MATERIAL } interior { ior 1.32 } }
polygon { 4, <-2, 2, 0>, <-2, -2, 0>, <0, 0, 3>, <-2, 2, 0> texture { pigment { color rgbf <0.976, 0.843, 0.172, 0> } } finish { MATERIAL } interior { ior 1.32 } }
polygon { 4, <-2, -2, 0>, <-2, 2, 0>, <2, 2, 0>, <-2, -2, 0> texture { pigment { color rgbf <0.976, 0.843, 0.172, 0> } } finish { MATERIAL } interior { ior 1.32 } }
polygon { 4, <-2, -2, 0>, <2, 2, 0>, <2, -2, 0>, <-2, -2, 0> texture { pigment { color rgbf <0.976, 0.843, 0.172, 0> } } finish { MATERIAL } interior { ior 1.32 } }
}
