#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 10 }

camera {
  location <0, 3.2, -9>
  right x*image_width/image_height
  angle 50
  look_at <0, 0.9, 0>
}
light_source { <-7, 10, -5> rgb 1 }
light_source { <6, 8, 6> rgb <0.35, 0.4, 0.5> }
background { rgb <0.62, 0.72, 0.82> }

plane {
  y, 0
  pigment { checker rgb <0.92, 0.90, 0.86>, rgb <0.35, 0.40, 0.46> }
  finish { ambient 0.1 diffuse 0.75 }
}

#macro Glass(Fade)
  material {
    texture {
      pigment { rgbf <0.98, 0.98, 0.98, 0.97> }
      finish {
        ambient 0 diffuse 0.02 specular 0.8 roughness 0.002
        reflection { 0, 1 fresnel on } conserve_energy
      }
    }
    interior { ior 1.5 fade_distance 1.2 fade_power 2 fade_color Fade }
  }
#end

sphere { <-2.4, 1, 0>, 1 Glass(<0.95, 0.35, 0.30>) }

difference {
  sphere { 0, 1.15 }
  sphere { 0, 1.0 }
  plane { -y, -0.25 }
  translate <0, 1.15, 0.3>
  Glass(<0.35, 0.80, 0.50>)
}

intersection {
  sphere { -1.5*z, 1.9 }
  sphere { 1.5*z, 1.9 }
  rotate -15*y
  translate <2.4, 1.17, 0>
  Glass(<0.40, 0.60, 0.95>)
}
