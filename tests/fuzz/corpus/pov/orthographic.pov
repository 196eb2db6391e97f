#version 3.7;
global_settings { assumed_gamma 1 }

camera {
  orthographic
  location <-10, 10, -10>
  right 8.4*x*image_width/image_height
  up 8.4*y
  look_at <0, 1.1, 0>
}
light_source { <-2, 10, -6> rgb 1 parallel point_at 0 }
background { rgb <0.95, 0.94, 0.90> }

#declare Surface = finish { ambient 0.25 diffuse 0.75 }

#for (I, 0, 5)
  #for (J, 0, 5)
    #local Height = max(0.25, 2.6 - 0.1*(pow(I - 2.5, 2) + pow(J - 2.5, 2))*1.9);
    box {
      <I - 2.96, 0, J - 2.96>, <I - 2.04, Height, J - 2.04>
      pigment { rgb <0.25 + 0.12*I, 0.45, 0.85 - 0.10*J> }
      finish { Surface }
    }
    #if (mod(I + J, 2) = 0)
      sphere {
        <I - 2.5, Height + 0.3, J - 2.5>, 0.3
        pigment { rgb <0.98, 0.95, 0.88> }
        finish { Surface phong 0.4 }
      }
    #end
  #end
#end
plane { y, 0 pigment { rgb <0.95, 0.94, 0.90> } finish { ambient 0.3 diffuse 0.7 } }
