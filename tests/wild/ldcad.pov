#version 3.7;
global_settings {
  assumed_gamma 1.0
  max_trace_level 20
  radiosity { count 20 pretrace_start 0.08 pretrace_end 0.08 error_bound 1.8 recursion_limit 1 }
}
#declare LdRef = 0;
#default { finish { ambient 0 diffuse 0.8 } }
camera { right -4/3*x sky -y location <60,-60,-80> look_at <0,0,0> angle 40 }
sky_sphere { pigment { gradient y color_map { [0 rgb <0.9,0.9,1>] [1 rgb <0.6,0.7,1>] } } emission 1 }
light_source { <100,-200,-150> rgb 1.2 }
plane { -y, -12 pigment { rgb 0.7 } }
#declare Part = union { box { <-20,0,-20>,<20,12,20> }
 #for (I, -10, 10, 20) #for (J, -10, 10, 20) cylinder { <I,0,J>,<I,-4,J>,6 } #end #end }
object { Part texture { pigment { rgb <0.1,0.4,0.8> } finish { specular 0.3 reflection { 0.05 } } } }
