#version 3.7;
global_settings { assumed_gamma 1 }

camera {
  location <0, 2.6, -8.5>
  right x*image_width/image_height
  angle 42
  look_at <0, 2.1, 0>
}
light_source { <-6, 9, -7> rgb <1, 0.97, 0.90> }
light_source { <6, 4, -7> rgb <0.18, 0.22, 0.30> shadowless }
background { rgb <0.68, 0.80, 0.92> }
plane { y, 0 pigment { rgb <0.35, 0.50, 0.22> } finish { ambient 0.15 diffuse 0.7 } }

#declare Random = seed(11);

#macro Branch(Level)
  cone { 0, 0.10*Level/4, y, 0.075*Level/4 pigment { rgb <0.36, 0.25, 0.16> } }
  #if (Level > 0.7)
    #for (I, 0, 2)
      union {
        Branch(Level*0.76)
        scale 0.74
        rotate (24 + 18*rand(Random))*z
        rotate (120*I + 50*rand(Random))*y
        translate y
      }
    #end
  #else
    sphere {
      y, 0.32 scale <1, 1.2, 1>
      pigment { rgb <0.20 + 0.35*rand(Random), 0.50 + 0.15*rand(Random), 0.12> }
      finish { ambient 0.12 diffuse 0.7 }
    }
  #end
#end

union { Branch(4) scale 1.35 }

#declare Count = 0;
#while (Count < 150)
  #declare Place = <14*rand(Random) - 7, 0, 11*rand(Random) - 4>;
  #if (vlength(Place) > 1)
    union {
      cylinder { 0, 0.22*y, 0.015 pigment { rgb <0.20, 0.45, 0.15> } }
      sphere { 0.26*y, 0.07 pigment { rgb <0.9, 0.3 + 0.6*rand(Random), 0.2 + 0.5*rand(Random)> } }
      translate Place
    }
    #declare Count = Count + 1;
  #end
#end
