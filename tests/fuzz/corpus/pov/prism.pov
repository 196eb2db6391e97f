#version 3.7;
global_settings { assumed_gamma 1 }

camera {
  location <0, 6.5, -8.5>
  right x*image_width/image_height
  angle 50
  look_at <0, 0, 0.1>
}
light_source { <-6, 9, -5> rgb 1 }
light_source { <6, 8, -8> rgb 0.25 shadowless }
background { rgb <0.93, 0.91, 0.88> }
plane { y, 0 pigment { rgb <0.88, 0.86, 0.82> } finish { ambient 0.15 diffuse 0.7 } }

#declare Teeth = 14;
#macro Rim(I)
  #local Radius = (mod(I, 4) < 2 ? 1.55 : 1.25);
  <Radius*cos(pi*(I + 0.5)/(2*Teeth)), Radius*sin(pi*(I + 0.5)/(2*Teeth))>
#end
prism {
  linear_spline linear_sweep 0, 0.5, 4*Teeth + 1 + 5
  #for (I, 0, 4*Teeth)
    Rim(I),
  #end
  <-0.4, -0.4>, <0.4, -0.4>, <0.4, 0.4>, <-0.4, 0.4>, <-0.4, -0.4>
  pigment { rgb <0.35, 0.42, 0.50> }
  finish { ambient 0.1 diffuse 0.6 specular 0.5 roughness 0.03 metallic }
  translate <-2.3, 0, 0.2>
}

prism {
  cubic_spline linear_sweep 0, 0.35, 10
  <0.4, -1.5>, <0, -1.7>, <0.9, -0.9>, <0.95, 0.3>, <0.4, 1.2>,
  <0, 1.75>, <-0.7, 0.8>, <-0.9, -0.5>, <0, -1.7>, <0.4, -1.5>
  pigment { rgb <0.30, 0.60, 0.22> }
  finish { ambient 0.12 diffuse 0.75 phong 0.3 }
  rotate 25*y
  translate <0.9, 0, 0>
}

prism {
  conic_sweep linear_spline 0, 1, 6
  #for (I, 0, 5)
    #if (I > 0) , #end
    <0.95*cos(2*pi*I/5), 0.95*sin(2*pi*I/5)>
  #end
  rotate 180*x
  scale <1, 1.5, 1>
  translate <3.1, 1.5, 0.2>
  pigment { rgb <0.85, 0.35, 0.20> }
  finish { ambient 0.12 diffuse 0.75 phong 0.3 }
}
