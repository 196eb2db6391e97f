#version 3.7;
global_settings { assumed_gamma 1 }

camera {
  location <0, 5, -11>
  right x*image_width/image_height
  angle 50
  look_at <0, 0.9, 0>
}
background { rgb <0.02, 0.02, 0.03> }

light_source {
  <-6, 9, -4> rgb 0.35
  area_light <3, 0, 0>, <0, 0, 3>, 7, 7 adaptive 1
}

#macro Spot(Colour, Angle)
  light_source {
    <4*cos(radians(Angle)), 7, 4*sin(radians(Angle))> Colour*0.9
    spotlight point_at <0.6*cos(radians(Angle)), 0, 0.6*sin(radians(Angle))>
    radius 14 falloff 17
  }
#end
Spot(rgb <1, 0, 0>, 90)
Spot(rgb <0, 1, 0>, 210)
Spot(rgb <0, 0, 1>, 330)

plane { y, 0 pigment { rgb 0.9 } finish { ambient 0.02 diffuse 0.8 } }

cone { 0, 0.45, 1.6*y, 0 pigment { rgb 0.95 } finish { ambient 0.02 diffuse 0.8 } }
sphere { <-3.2, 0.7, 0>, 0.7 pigment { rgb 0.9 } finish { ambient 0.02 diffuse 0.8 phong 0.5 } }
torus { 0.65, 0.25 translate <3.2, 0.25, 0> pigment { rgb 0.9 } finish { ambient 0.02 diffuse 0.8 } }
