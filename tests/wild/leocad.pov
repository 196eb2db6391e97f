// A document without #version, with every part its own #declare.
global_settings { assumed_gamma 1.0 }
#declare lg_quality = 3;
#declare lg_studs = 1;
#declare MaxTraceLevel = 5;
#ifndef (SkipWriteLightMacro)
#macro WriteLight(Type, Shadowless, Location, Target, Color)
light_source {
	Location
	Color
	#if (Type = 1) spotlight point_at Target radius 25 falloff 35 tightness 2 #end
	#if (Shadowless) shadowless #end
}
#end
#end
#ifndef (lc_red) #declare lc_red = texture { pigment { rgb <0.69,0.05,0.05> } finish { ambient 0.25 diffuse 0.6 specular 0.5 roughness 0.02 } } #end
#ifndef (lc_trans_clear) #declare lc_trans_clear = texture { pigment { rgbf <0.95,0.95,0.95,0.75> } finish { ambient 0.2 reflection 0.1 } } #end
background { color rgb <0.33, 0.4, 0.5> }
camera { perspective right x * image_width / image_height sky z location <3.2, -3.1, 2.2> look_at <0, 0, 0.2> angle 42 }
WriteLight(0, 1, <-3, -4, 6>, <0, 0, 0>, <0.4, 0.4, 0.4>)
WriteLight(1, 0, <4, -2, 7>, <0, 0, 0>, color rgb <1, 1, 1>)
#declare lc_3003 = union {
 box { <-0.8, -0.8, 0>, <0.8, 0.8, 0.96> }
 cylinder { <-0.4, -0.4, 0.96>, <-0.4, -0.4, 1.1>, 0.24 }
 cylinder { <0.4, -0.4, 0.96>, <0.4, -0.4, 1.1>, 0.24 }
 cylinder { <-0.4, 0.4, 0.96>, <-0.4, 0.4, 1.1>, 0.24 }
 cylinder { <0.4, 0.4, 0.96>, <0.4, 0.4, 1.1>, 0.24 }
}
object {
 lc_3003
 texture { lc_red }
 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, -0.9, 0, -0.4>
}
merge {
 object { lc_3003 matrix <0.7, 0.7, 0, -0.7, 0.7, 0, 0, 0, 1, 1.1, 0.2, -0.4> }
 texture { lc_trans_clear } interior { ior 1.5 }
}
