// Bricks by an older converter: QUAL, SW, STUDS, and a #version of its own time.
#declare QUAL = 2;
#declare SW = 0.5;
#declare STUDS = 1;
#declare BUMPS = 0;
#version 3.1;
global_settings { assumed_gamma 1.4 max_trace_level 10 }
#declare O7071 = sqrt(0.5);
#declare L3Cube = box { <-1,-1,-1>, <1,1,1> }
#declare L3Color14 = 
texture {
	pigment { rgb <0.98,0.85,0.1> }
	finish { ambient 0.3 diffuse 0.5 }
#if (QUAL > 1)
	finish { phong 0.5 phong_size 40 reflection 0.05 }
#if (BUMPS)
	normal { bumps 0.01 scale 20 }
#end
#end
}
#declare L3Color47 = 
texture {
	pigment { rgb <1,1,1> filter 0.9 }
	finish { ambient 0.3 diffuse 0.3 phong 0.5 phong_size 40 reflection 0.2 }
}
#declare p3024_dot_dat =
#if (QUAL = 0)
box { <-10,0,-10>, <10,8,10> }
#else
union {
	object { L3Cube matrix <10,0,0,0,4,0,0,0,10,0,4,0> }
#if (STUDS)
	cylinder { <0,0,0>, <0,-4,0>, 6 }
#end
}
#end
object {
	p3024_dot_dat
	matrix <1-SW/20,0,0,0,1-SW/8,0,0,0,1-SW/20,-14,0,0>
#if (version >= 3.1) #if (QUAL > 1) interior { ior 1.25 } #end #end
	texture { L3Color14 }
}
object {
	p3024_dot_dat
	matrix <O7071,0,-O7071,0,1-SW/8,0,O7071,0,O7071,14,0,0>
	interior { ior 1.25 }
	texture { L3Color47 }
}
object { plane { y, 8 hollow } texture { pigment { color rgb <0.3,0.5,0.3> } finish { ambient 0.4 diffuse 0.4 } } }
background { color rgb <0.5,0.7,0.9> }
camera {
	location <-40,-60,-80>
	sky      <0,-1,0>
	right    -4/3*x
	look_at  <0,0,0>
	angle    40
}
light_source { <-100,-200,-100> color rgb <1,1,1> }
