#version 3.7;
#declare Size = 1.2
#declare Tall = <1, 1.4, 1>
#declare Brown = color rgb <0.6, 0.4, 0.2>
#declare Skin = texture { pigment { color Brown } finish { phong 0.6 } }
#declare Half = Size / 2
camera { location <0, 1, -5> look_at 0 }
light_source { <-4, 5, -6> rgb 1 }
sphere { 0, Half scale Tall texture { Skin } }
box { -Half, Half translate <1.5, 0, 0> pigment { Brown } }
