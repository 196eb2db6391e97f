// SPDX-License-Identifier: Apache-2.0
// A lighthouse lens on a table: rings of glass held in brass, all of it solids and what is left
// when solids are taken from solids.
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 7 adc_bailout 0.02 }

camera {
  location <-1.8, 4.6, -14>
  right x*image_width/image_height
  angle 40
  look_at <0.25, 2.15, 0>
}

// ---- Light: a broad window on the left, a faint one behind, and the lamp inside the lens.

light_source {
  <-9, 13, -9> rgb <1.75, 1.55, 1.3>
  area_light <4, 0, -4>, <0, 4, 0>, 5, 5 adaptive 1
}
light_source { <12, 7, 9> rgb <0.30, 0.40, 0.62> shadowless }
light_source {
  <0, 2.1, 0> rgb <1.5, 1.1, 0.55>
  fade_distance 2.2 fade_power 2
}

// A wall far behind in evening light; it is also what the glass and the brass have to mirror.
sphere {
  <0, 0, 0>, 60
  hollow no_shadow
  pigment {
    gradient y
    color_map {
      [0.485 rgb <0.020, 0.030, 0.055>]
      [0.500 rgb <0.95, 0.42, 0.14>]
      [0.515 rgb <0.90, 0.52, 0.26>]
      [0.545 rgb <0.42, 0.34, 0.36>]
      [0.620 rgb <0.10, 0.16, 0.30>]
      [1.000 rgb <0.01, 0.02, 0.06>]
    }
    translate -0.5*y scale 120
  }
  finish { ambient 0 diffuse 0 emission 1 }
}

// ---- What things are made of.

#declare Brass = texture {
  pigment { rgb <0.78, 0.52, 0.20> }
  finish {
    ambient 0.02 diffuse 0.30 specular 0.8 roughness 0.015 metallic brilliance 2
    reflection { 0.45 metallic }
  }
}

#declare Glass = material {
  texture {
    pigment { rgbf <0.96, 0.99, 0.975, 0.96> }
    finish {
      ambient 0 diffuse 0.02 specular 0.9 roughness 0.002
      reflection { 0.03, 0.9 fresnel on } conserve_energy
    }
  }
  interior { ior 1.5 fade_distance 6 fade_power 2 fade_color <0.4, 0.8, 0.65> }
}

#declare Ivory = texture {
  pigment { rgb <0.93, 0.87, 0.74> }
  finish { ambient 0.03 diffuse 0.62 specular 0.25 roughness 0.03 }
}

#declare Vermilion = texture {
  pigment { rgb <0.75, 0.12, 0.05> }
  finish { ambient 0.03 diffuse 0.7 specular 0.5 roughness 0.01 reflection { 0.02, 0.25 } }
}

// ---- The table: planks of dark wood under lacquer.

#declare Plank = texture {
  pigment {
    wood turbulence 0.06 octaves 3
    color_map {
      [0.0 rgb <0.105, 0.050, 0.025>]
      [0.6 rgb <0.190, 0.095, 0.045>]
      [1.0 rgb <0.070, 0.032, 0.018>]
    }
    scale <0.35, 0.35, 6> rotate <2, 4, 0>
  }
  normal { bumps 0.03 scale <0.3, 1, 3> }
  finish { ambient 0.03 diffuse 0.8 specular 0.5 roughness 0.006 reflection { 0.06, 0.55 falloff 3 } }
}

#for (I, -8, 8)
  box {
    <I*1.9 - 0.93, -0.5, -30>, <I*1.9 + 0.93, 0, 7>
    texture { Plank translate <mod(I*3.7 + 40, 5), mod(I*1.3 + 20, 2), I*11> }
  }
#end
box { <-17, -1, -30>, <17, -0.06, 6.9> pigment { rgb 0.01 } finish { ambient 0 } }

// ---- The lens: a drum of glass rings around the lamp, each a prism bent into a circle.

// A ring whose section is a triangle: thick at one rim, thin at the other.
#macro Prism_ring(Low, High, Inner, Wide, Narrow)
  difference {
    cone { <0, Low, 0>, Inner + Wide, <0, High, 0>, Inner + Narrow }
    cylinder { <0, Low - 1, 0>, <0, High + 1, 0>, Inner }
  }
#end

#declare Lens = union {
  // The middle belt bulges: a fat torus cut to a drum and hollowed.
  difference {
    intersection {
      torus { 0.75, 1.0 }
      cylinder { <0, -0.52, 0>, <0, 0.52, 0>, 3 }
    }
    cylinder { <0, -2, 0>, <0, 2, 0>, 1.45 }
  }
  #for (I, 0, 3)
    object { Prism_ring( 0.58 + I*0.36,  0.90 + I*0.36, 1.45 - I*0.12, 0.27, 0.05) }
    object { Prism_ring(-0.90 - I*0.36, -0.58 - I*0.36, 1.45 - I*0.12, 0.05, 0.27) }
  #end
  material { Glass }
}

#declare Frame = union {
  // Foot, in steps.
  cylinder { <0, -2.30, 0>, <0, -2.14, 0>, 1.95 }
  torus { 1.95, 0.08 translate -2.22*y }
  cone { <0, -2.14, 0>, 1.55, <0, -2.0, 0>, 1.35 }
  // Cap with a ball.
  cone { <0, 2.02, 0>, 1.28, <0, 2.34, 0>, 0.45 }
  torus { 1.26, 0.07 translate 2.04*y }
  cylinder { <0, 2.3, 0>, <0, 2.55, 0>, 0.16 }
  sphere { <0, 2.72, 0>, 0.24 }
  // Eight bars follow the rings.
  #for (I, 0, 7)
    union {
      cylinder { <1.78, -0.56, 0>, <1.78, 0.56, 0>, 0.05 }
      sphere { <1.78, -0.56, 0>, 0.05 }
      sphere { <1.78, 0.56, 0>, 0.05 }
      cylinder { <1.78, 0.56, 0>, <1.30, 2.04, 0>, 0.05 }
      cylinder { <1.78, -0.56, 0>, <1.30, -2.04, 0>, 0.05 }
      rotate (I*45 + 22.5)*y
    }
  #end
  torus { 1.74, 0.045 translate 0.56*y }
  torus { 1.74, 0.045 translate -0.56*y }
  texture { Brass }
}

#declare Lamp = union {
  cylinder { <0, -2.0, 0>, <0, -0.75, 0>, 0.22 texture { Brass } }
  sphere {
    0, 0.34 scale <1, 1.5, 1> translate -0.25*y
    no_shadow
    pigment { rgb <1, 0.82, 0.5> }
    finish { ambient 0 diffuse 0 emission 1.6 }
  }
}

union {
  object { Lens }
  object { Frame }
  object { Lamp }
  translate <0, 2.30, 0>
}

// ---- Three solids that Boolean operations made.

// A cube from which a ball and three bores were taken, with a mirror ball caught inside.
union {
  difference {
    intersection {
      box { -1, 1 }
      sphere { 0, 1.38 }
    }
    cylinder { -2*x, 2*x, 0.66 }
    cylinder { -2*y, 2*y, 0.66 }
    cylinder { -2*z, 2*z, 0.66 }
    texture { Ivory }
  }
  sphere {
    0, 0.74
    pigment { rgb <0.85, 0.88, 0.92> }
    finish { ambient 0 diffuse 0.05 specular 0.8 roughness 0.003 reflection 0.85 }
  }
  rotate 28*y
  translate <3.9, 1, 0.4>
}

// A star-shaped prism with its rim turned off by a cone, standing on its face.
#declare Points = 10;
intersection {
  prism {
    linear_spline linear_sweep 0, 0.55, Points*2 + 1
    #for (I, 0, Points*2)
      , <(0.62 + 0.33*mod(I, 2))*cos(pi*I/Points), (0.62 + 0.33*mod(I, 2))*sin(pi*I/Points)>
    #end
  }
  cone { <0, -0.3, 0>, 1.25, <0, 0.9, 0>, 0.45 }
  cylinder { <0, 0.2, 0>, <0, 2, 0>, 0.3 inverse }
  texture { Brass }
  rotate 10*y
  translate <1.45, 0, -2.9>
}

// A ball with a bite, showing its core.
union {
  difference {
    sphere { 0, 0.72 }
    sphere { 0, 0.62 }
    box { <0, 0, -2>, <2, 2, 0> }
    texture { Vermilion }
  }
  sphere { 0, 0.40 texture { Brass } }
  rotate <-14, 24, 0>
  translate <-3.25, 0.72, -2.0>
}

// A clear ball that gathers the whole room.
sphere { <3.15, 0.5, -2.7>, 0.5 material { Glass } }
sphere { <-4.6, 0.34, -0.4>, 0.34
  pigment { rgb <0.06, 0.20, 0.42> }
  finish { ambient 0.02 diffuse 0.6 specular 0.6 roughness 0.008 reflection { 0.03, 0.4 } }
}
