// A molecule as a viewer writes it.
#if (version < 3.5)
#error "This scene needs POV-Ray 3.5 or later."
#end
#declare VMD_clip_on=array[3] {0, 0, 0};
#declare VMD_clip=array[3];
#declare VMD_scaledclip=array[3];
#declare VMD_line_width=0.0020;
#macro VMDC ( C1 )
  texture { pigment { rgbt C1 }}
#end
#macro VMD_point (P1, R1, C1)
  #local T = texture { finish { ambient 1.0 diffuse 0.0 phong 0.0 specular 0.0 } pigment { C1 } }
  #if(VMD_clip_on[2])
  intersection {
    sphere {P1, R1 texture {T} #if(VMD_clip_on[1]) clipped_by {VMD_clip[1]} #end no_shadow}
    VMD_clip[2]
  }
  #else
  sphere {P1, R1 texture {T} #if(VMD_clip_on[1]) clipped_by {VMD_clip[1]} #end no_shadow}
  #end
#end
#macro VMD_sphere (P1, R1, C1)
  #local T = texture { pigment { C1 } }
  #if(VMD_clip_on[2])
  intersection {
    sphere {P1, R1 texture {T} #if(VMD_clip_on[1]) clipped_by {VMD_clip[1]} #end no_shadow}
    VMD_clip[2]
  }
  #else
  sphere {P1, R1 texture {T} #if(VMD_clip_on[1]) clipped_by {VMD_clip[1]} #end no_shadow}
  #end
#end
#macro VMD_cylinder (P1, P2, R1, C1, O1)
  #local T = texture { pigment { C1 } }
  cylinder {P1, P2, R1 #if(O1) open #end texture {T} #if(VMD_clip_on[1]) clipped_by {VMD_clip[1]} #end no_shadow}
#end
#macro VMD_triangle (P1, P2, P3, N1, N2, N3, C1)
  smooth_triangle {P1, N1, P2, N2, P3, N3 texture { pigment { C1 } } no_shadow}
#end
camera {
  orthographic
  location <0.0000, 0.0000, -2.0000>
  look_at <-0.0000, -0.0000, 2.0000>
  up <0.0000, 3.0000, 0.0000>
  right <4.0000, 0.0000, 0.0000>
}
light_source {
  <-0.1000, 0.1000, -1.0000>
  color rgb<1.000, 1.000, 1.000>
  parallel
  point_at <0.0, 0.0, 0.0>
}
light_source {
  <1.0000, 2.0000, -0.5000>
  color rgb<1.000, 1.000, 1.000>
  parallel
  point_at <0.0, 0.0, 0.0>
}
background {
  color rgb<0.000, 0.000, 0.000>
}
#default { texture {
 finish { ambient 0.000 diffuse 0.650 phong 0.1 phong_size 40.000 specular 0.500 }
} }
#declare VMD_line_width=0.0200;
// MoleculeID: 0 ReprID: 0
VMD_cylinder(<-1.0,0.1,0.2>,<0.1,0.4,0.2>0.08,rgbt<0.250,0.750,0.750,0.000>,1)
VMD_cylinder(<0.1,0.4,0.2>,<0.9,-0.4,0.1>0.08,rgbt<0.250,0.750,0.750,0.000>,0)
VMD_sphere(<-1.0,0.1,0.2>,0.35,rgbt<1.000,0.000,0.000,0.000>)
VMD_sphere(<0.1,0.4,0.2>,0.3,rgbt<0.250,0.250,0.750,0.400>)
#declare VMD_clip_on[1]=1;
#declare VMD_clip[1] = plane { x, 0.95 }
VMD_sphere(<0.9,-0.4,0.1>,0.4,rgbt<1.000,1.000,1.000,0.000>)
#declare VMD_clip_on[1]=0;
VMD_point(<0.5,1.1,0.1>,0.05,rgbt<1.000,1.000,0.000,0.000>)
VMD_triangle(<-1.4,-1.2,0.3>,<-0.2,-1.2,0.3>,<-0.8,-0.5,0.4>,<-0.4,-0.2,-0.9>,<0.4,-0.2,-0.9>,<0.0,0.4,-0.9>,rgbt<0.500,1.000,0.500,0.000>)
// End of POV-Ray 3.x generation
