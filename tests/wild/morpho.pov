// A mesh of a finite element program, one line to a cylinder.
background { rgb <1,1,1> }
camera { location <0,0,-9> up <0,1,0> right <1.33333,0,0> angle 50look_at <0,0,0> sky <0,1,0> }
light_source { <50,50,-50> rgb <1,1,1> }
union {
cylinder { <-3,-2,0>, <0,2.4,0>, 0.2 texture { pigment { rgb <0.8,0.2,0.2,0> } } }
cylinder { <0,2.4,0>, <3,-2,0>, 0.2 texture { pigment { rgb <0.2,0.8,0.2,0> } } }
cylinder { <3,-2,0>, <-3,-2,0>, 0.2 texture { pigment { rgb <0.2,0.2,0.8,0.5> } } }
cylinder { <-3,-2,0>, <0,-0.4,-1>, 0.1 texture { pigment { rgb <0.8,0.8,0.2,0> } } }
cylinder { <0,2.4,0>, <0,-0.4,-1>, 0.1 texture { pigment { rgb <0.8,0.2,0.8,0> } } }
cylinder { <3,-2,0>, <0,-0.4,-1>, 0.1 texture { pigment { rgb <0.2,0.8,0.8,0> } } }
}
