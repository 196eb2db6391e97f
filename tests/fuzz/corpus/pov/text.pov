#version 3.7;
global_settings { assumed_gamma 1 }

camera {
  location <0.6, 2.2, -7.5>
  right x*image_width/image_height
  angle 50
  look_at <0, 0.75, 0>
}
light_source { <-6, 8, -8> rgb 1 }
light_source { <6, 4, -7> rgb <0.25, 0.3, 0.4> shadowless }
background { rgb <0.10, 0.16, 0.25> }

#declare Word = text { ttf "timrom.ttf" "Dioptre" 0.5, 0 };
#declare Middle = (min_extent(Word).x + max_extent(Word).x)/2;

difference {
  object { Word translate -Middle*x scale 1.8 }
  box { <-9, 0.52, -1>, <9, 0.60, 2> }
  pigment { rgb <0.90, 0.62, 0.22> }
  finish { ambient 0.08 diffuse 0.6 specular 0.7 roughness 0.02 metallic reflection { 0.15 metallic } }
}

plane {
  y, -0.02
  pigment { rgb <0.16, 0.24, 0.34> }
  finish { ambient 0.1 diffuse 0.6 reflection 0.2 }
}
