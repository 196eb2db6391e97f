#version 3.7;
global_settings { assumed_gamma 1 }

camera {
  location <3.5, 4.2, -8>
  right x*image_width/image_height
  angle 36
  look_at <0, -0.2, 0>
}
light_source { <-5, 7, -4> rgb 1 }
light_source { <6, 5, 6> rgb <0.30, 0.30, 0.40> }
background { rgb <0.10, 0.11, 0.15> }

#declare Height = function(X, Z) { 0.9*cos(3*sqrt(X*X + Z*Z))*exp(-0.35*(X*X + Z*Z)) }
#macro Upright(X, Z)
  #local E = 1e-3;
  vnormalize(<Height(X - E, Z) - Height(X + E, Z), 2*E, Height(X, Z - E) - Height(X, Z + E)>)
#end
#macro Corner(X, Z)
  <X, Height(X, Z), Z>, Upright(X, Z)
#end

#declare Steps = 48;
#declare Side = 6/Steps;
mesh {
  #for (I, 0, Steps - 1)
    #for (J, 0, Steps - 1)
      #local X = -3 + I*Side;
      #local Z = -3 + J*Side;
      smooth_triangle { Corner(X, Z), Corner(X + Side, Z), Corner(X, Z + Side) }
      smooth_triangle { Corner(X + Side, Z + Side), Corner(X + Side, Z), Corner(X, Z + Side) }
    #end
  #end
  pigment {
    gradient y
    color_map {
      [0.0 rgb <0.05, 0.20, 0.45>] [0.4 rgb <0.10, 0.50, 0.60>]
      [0.7 rgb <0.85, 0.80, 0.45>] [1.0 rgb <0.95, 0.95, 0.90>]
    }
    scale 1.6 translate -0.65*y
  }
  finish { ambient 0.08 diffuse 0.75 specular 0.4 roughness 0.02 }
}
