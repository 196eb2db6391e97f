// Persistence of a modeller's scene: z is up.
#version 3.5;
global_settings {
  adc_bailout 0.003922
  ambient_light <1.0,1.0,1.0>
  assumed_gamma 1.9
  hf_gray_16 off
  irid_wavelength <0.247059,0.176471,0.137255>
  max_trace_level 5
  number_of_waves 10
  noise_generator 1
  charset ascii
}
background { color <0.3,0.4,0.5> }
camera {  //  Camera StdCam
  location  <      4.000,      -9.000,       5.000>
  sky       <    0.00000,    0.00000,    1.00000> // Use right handed-system
  up        <        0.0,        0.0,        1.0> // Where Z is up
  right     <    1.33333,        0.0,        0.0> // Angle ratio
  angle         40.00000 // Overridden by any angle in the file
  look_at   <      0.000,       0.000,       0.600>
}
light_source {   // Light1
  <0.0, 0.0, 0.0>
  color rgb <1.000, 1.000, 1.000>
  translate  <5.0, -8.0, 12.0>
}
#declare Speckle = texture { pigment { bozo color_map { [ 0.0 rgbft <0.9, 0.6, 0.2, 0.0, 0.0> ] [ 1.0 rgbft <0.4, 0.1, 0.1, 0.0, 0.0> ] } turbulence 0.4 scale 0.7 } normal { bumps , 0.3 scale 0.2 } finish { ambient 0.2 diffuse 0.7 specular 0.4 } }
union {
  torus { 1.0, 0.35 rotate -x*90 texture { Speckle } scale <1.2, 1.2, 1> translate z*1.2 }
  cone { <0,0,0>, 1.0, <0,0,1>, 0.0 scale <0.8, 0.8, 1.5> texture { pigment { color rgb <0.5,0.8,0.5> } } }
}
plane { z, 0.0 texture { pigment { checker color rgb 0.8 color rgb 0.5 } } }
