#version 3.7;
global_settings { assumed_gamma 1 }

camera {
  location <0, 4.5, -11>
  right x*image_width/image_height
  angle 54
  look_at <0, 0.6, 0>
}
light_source { <-6, 10, -8> rgb 1 }
light_source { <8, 6, -6> rgb 0.3 shadowless }
background { rgb <0.90, 0.92, 0.95> }

plane {
  y, -1
  pigment { rgb <0.80, 0.82, 0.85> }
  finish { ambient 0.15 diffuse 0.7 }
}

#declare Cube = box {
  -0.8, 0.8
  pigment { rgb <0.95, 0.65, 0.15> }
  finish { ambient 0.15 diffuse 0.75 phong 0.4 phong_size 60 }
}
#declare Ball = sphere {
  0, 1.05
  pigment { rgb <0.15, 0.40, 0.75> }
  finish { ambient 0.15 diffuse 0.75 phong 0.6 phong_size 60 }
}

union { object { Cube } object { Ball } rotate 30*y translate -3.9*x }
intersection { object { Cube } object { Ball } rotate 30*y translate -1.3*x }
difference { object { Cube } object { Ball } rotate 30*y translate 1.3*x }

difference {
  intersection { object { Cube } object { Ball } }
  union {
    cylinder { -2*x, 2*x, 0.45 }
    cylinder { -2*y, 2*y, 0.45 }
    cylinder { -2*z, 2*z, 0.45 }
    pigment { rgb <0.35, 0.65, 0.30> }
    finish { ambient 0.15 diffuse 0.75 }
  }
  rotate 30*y
  translate 3.9*x
}
