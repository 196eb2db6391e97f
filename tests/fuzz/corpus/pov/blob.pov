#version 3.7;
global_settings { assumed_gamma 1 }

camera {
  location <0, 4.2, -9>
  right x*image_width/image_height
  angle 36
  look_at <0, 0.8, 0>
}
light_source { <-5, 9, -7> rgb 1 }
light_source { <8, 5, -3> rgb <0.20, 0.25, 0.30> shadowless }
background { rgb <0.86, 0.90, 0.88> }

plane { y, 0 pigment { rgb <0.80, 0.84, 0.82> } finish { ambient 0.15 diffuse 0.7 } }

blob {
  threshold 0.5

  #for (I, 0, 8)
    sphere { <1.9*cos(2*pi*I/9), 0.55, 1.9*sin(2*pi*I/9)>, 1.15, 1 }
  #end

  cylinder { <0, 0.2, 0>, <0, 1.6, 0>, 0.8, 1 }
  sphere { <0, 2.2, 0>, 0.9, 1.2 }

  sphere { <0, 1.1, -2.3>, 0.9, -1.4 }
  pigment {
    gradient y
    color_map { [0 rgb <0.05, 0.35, 0.40>] [0.4 rgb <0.10, 0.60, 0.50>] [1 rgb <0.90, 0.95, 0.60>] }
    scale 2.9
  }
  finish { ambient 0.1 diffuse 0.7 specular 0.6 roughness 0.01 reflection { 0.02, 0.25 } }
}
