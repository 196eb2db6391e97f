// Bricks with a setting for everything.
#ifndef (LDXQual) #declare LDXQual = 2; #end
#ifndef (LDXSW) #declare LDXSW = 0.5; #end
#ifndef (LDXStuds) #declare LDXStuds = 1; #end
#ifndef (LDXShads) #declare LDXShads = 1; #end
#ifndef (LDXAmb) #declare LDXAmb = 0.4; #end
#ifndef (LDXDif) #declare LDXDif = 0.4; #end
#ifndef (LDXRefl) #declare LDXRefl = 0.08; #end
#ifndef (LDXPhong) #declare LDXPhong = 0.5; #end
#ifndef (LDXPhongS) #declare LDXPhongS = 40; #end
#ifndef (LDXTRefl) #declare LDXTRefl = 0.2; #end
#ifndef (LDXTFilt) #declare LDXTFilt = 0.85; #end
#ifndef (LDXIoR) #declare LDXIoR = 1.25; #end
#ifndef (LDXFloor) #declare LDXFloor = 1; #end
#ifndef (LDXFloorLoc) #declare LDXFloorLoc = 24; #end
#ifndef (LDXSkipWriteTexture) #declare LDXSkipWriteTexture = 0; #end
#declare LDXOrigVer = version;
#declare AnimCircle = (LDXQual > 1 ? 1 : 0);
camera {
	#declare LDXCamAspect = image_width/image_height;
	location < -90.000000,-110.000000,-150.000000 >
	sky -y
	right LDXCamAspect * < -1,0,0 >
	look_at < 0.0,6.0,0.0 >
	angle 45
}
#ifndef (LDXSkipBG) background { color rgb <0.8,0.85,0.9> } #end
light_source { <-300,-500,-200> color rgb <1,1,1> #if (LDXShads = 0) shadowless #end }
#if (LDXFloor)
plane { y, LDXFloorLoc hollow texture { pigment { color rgb <0.8,0.8,0.8> } finish { ambient LDXAmb diffuse LDXDif } } }
#end
#macro LDXSeamMatrix(Width, Height, Depth, CenterX, CenterY, CenterZ)
#local aw = 0;
#local ah = 0;
#local ad = 0;
#if (Width != 0)
#local aw = 1/Width*LDXSW;
#end
#if (Height != 0)
#local ah = 1/Height*LDXSW;
#end
#if (Depth != 0)
#local ad = 1/Depth*LDXSW;
#end
#local ax = (CenterX > 0 ? aw*CenterX : aw*-CenterX*-1);
matrix <1-aw,0,0,0,1-ah,0,0,0,1-ad,ax,ah*CenterY,ad*CenterZ>
#end
#ifndef (LDXColor4)
#declare LDXColor4 = #if (version >= 3.1) material { #end
	texture {
		pigment { #if (LDXQual > 1) color rgbf <0.78,0.1,0.03,0> #else color rgb <0.7,0.1,0.03> #end }
#if (LDXQual > 1)
		finish { ambient LDXAmb diffuse LDXDif phong LDXPhong phong_size LDXPhongS reflection LDXRefl }
#end
	}
#if (version >= 3.1) } #end
#end
#ifndef (LDXColor33)
#declare LDXColor33 = #if (version >= 3.1) material { #end
	texture {
		pigment { #if (LDXQual > 1) color rgbf <0.2,0.4,0.9,LDXTFilt> #else color rgb <0.2,0.4,0.9> #end }
#if (LDXQual > 1)
		finish { ambient LDXAmb diffuse LDXDif phong LDXPhong phong_size LDXPhongS reflection LDXTRefl }
#end
	}
#if (version >= 3.1) #if (LDXQual > 1) interior { ior LDXIoR } #end } #end
#end
#declare LDXStud = cylinder { <0,0,0>, <0,-4,0>, 6 }
#declare LDX_3005_dot_dat =
union {
	difference {
		box { <-10,0,-10>, <10,24,10> }
		box { <-6,4,-6>, <6,25,6> }
	}
#if (LDXStuds) object { LDXStud } #end
}
#declare LDX_slope_dot_dat =
mesh2 { vertex_vectors { 6, <-10,24,-10>,<10,24,-10>,<10,24,10>,<-10,24,10>,<-10,0,10>,<10,0,10> }
	face_indices { 8, <0,1,2>,<0,2,3>,<0,4,5>,<0,5,1>,<3,2,5>,<3,5,4>,<0,3,4>,<1,5,2> } inside_vector <0,1,0> }
object { object { LDX_3005_dot_dat LDXSeamMatrix(20, 24, 20, 0, 12, 0) } matrix <1,0,0,0,1,0,0,0,1,-22,0,0> material { LDXColor4 } }
object { object { LDX_3005_dot_dat LDXSeamMatrix(20, 24, 20, 0, 12, 0) } matrix <1,0,0,0,1,0,0,0,1,0,0,0> material { LDXColor33 } }
object { object { LDX_slope_dot_dat LDXSeamMatrix(20, 24, 20, 0, 12, 0) } matrix <1,0,0,0,1,0,0,0,1,24,0,0> material { LDXColor4 } }
