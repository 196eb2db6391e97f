#version 3.8;
global_settings { assumed_gamma 1 }
camera { location <0, 1, -5> look_at 0 }
light_source { <-4, 5, -6> rgb 1 }
#declare Points = array { <-1, 0, 0>, <0, 0.5, 0>, <1, 0, 0> };
#declare Grid = array { array { 0.1, 0.2 }, array { 0.3, 0.4, 0.5 } };
#declare Mixed = array mixed { 0.4, <0.8, 0.3, 0.2>, "a word", sphere { 0, 0.3 } };
#for (I, 0, dimension_size(Points, 1) - 1)
  sphere { Points[I], Mixed[0] pigment { rgb Mixed[1] } }
#end
object { Mixed[3] translate y pigment { rgb <Grid[1][2], Grid[0][0], 1> } }
