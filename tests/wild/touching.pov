#version 3.7;
global_settings{assumed_gamma 1}
camera{location<0,1,-5>look_at 0angle 40right x*4/3}
light_source{<-4,5,-6>rgb 1}
sphere{0,1pigment{rgb<1,.5,.2>}finish{phong.5}}
