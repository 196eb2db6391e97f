// SPDX-License-Identifier: Apache-2.0
// Balls of air, water, glass and diamond before stripes: what is behind stands on its head as soon
// as the light is bent enough.
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 10 }

camera { location <0, 1.1, -8> look_at <0, 0.9, 0> right x*image_width/image_height angle 48 }
light_source { <-6, 9, -8> rgb 1 }
plane { y, 0 pigment { rgb 0.75 } finish { ambient 0.15 diffuse 0.7 } }
plane {
  -z, -4
  pigment { gradient x+y color_map { [0.5 rgb <0.92, 0.90, 0.84>] [0.5 rgb <0.25, 0.40, 0.60>] } scale 0.9 }
  finish { ambient 0.5 diffuse 0.5 }
}
#macro Ball(X, Ior) sphere {
  <X, 0.9, 0>, 0.85
  pigment { rgbf <0.98, 0.99, 1, 0.97> }
  finish { ambient 0 diffuse 0 specular 0.6 roughness 0.005 reflection { 0, 1 fresnel } conserve_energy }
  interior { ior Ior }
} #end
Ball(-2.7, 1.0001)
Ball(-0.9, 1.33)
Ball(0.9, 1.5)
Ball(2.7, 2.4)
