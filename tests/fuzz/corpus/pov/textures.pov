#version 3.7;
global_settings { assumed_gamma 1 }

camera {
  location <0, 2.4, -10>
  right x*image_width/image_height
  angle 42
  look_at <0, 0.55, 0>
}
light_source { <-6, 9, -9> rgb 1 }
light_source { <9, 5, -6> rgb 0.25 shadowless }
background { rgb <0.13, 0.14, 0.17> }

plane {
  y, -1
  pigment { checker rgb 0.55, rgb 0.45 scale 0.8 }
  finish { ambient 0.1 diffuse 0.7 reflection 0.06 }
}

#declare Shine = finish { ambient 0.1 diffuse 0.75 specular 0.4 roughness 0.02 }

#declare Marble = texture {
  pigment {
    marble turbulence 0.7
    color_map { [0 rgb <0.95, 0.93, 0.90>] [0.7 rgb <0.80, 0.78, 0.78>] [1 rgb <0.25, 0.27, 0.32>] }
    scale 0.6
  }
  finish { Shine }
}
#declare Wood = texture {
  pigment {
    wood turbulence 0.08
    color_map { [0 rgb <0.72, 0.45, 0.22>] [0.8 rgb <0.55, 0.30, 0.13>] [1 rgb <0.40, 0.20, 0.08>] }
    scale 0.22 rotate <70, 20, 0>
  }
  finish { Shine }
}
#declare Agate = texture {
  pigment {
    agate
    color_map { [0 rgb <0.20, 0.09, 0.05>] [0.5 rgb <0.75, 0.42, 0.20>] [1 rgb <0.97, 0.90, 0.75>] }
    scale 0.8
  }
  finish { Shine }
}
#declare Granite = texture {
  pigment {
    granite
    color_map { [0 rgb <0.10, 0.16, 0.14>] [0.5 rgb <0.30, 0.48, 0.42>] [1 rgb <0.85, 0.90, 0.85>] }
  }
  finish { Shine }
}
#declare Onion = texture {
  pigment {
    onion
    color_map { [0 rgb <0.10, 0.25, 0.55>] [0.5 rgb <0.90, 0.92, 0.95>] [1 rgb <0.10, 0.25, 0.55>] }
    scale 0.35 translate <0.4, 0.3, -0.6>
  }
  finish { Shine }
}
#declare Bumpy = texture {
  pigment { rgb <0.80, 0.20, 0.12> }
  normal { bumps 0.6 scale 0.12 }
  finish { Shine }
}

#declare Samples = array[6] { Marble, Wood, Agate, Granite, Onion, Bumpy };
#for (I, 0, 5)
  sphere {
    0, 1
    texture { Samples[I] }
    translate <2.4*(mod(I, 3) - 1), 2.1*div(I, 3), 1.2*div(I, 3)>
  }
#end
