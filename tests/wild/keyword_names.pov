// Names of an author that became keywords later.
camera { location <0, 1, -5> look_at 0 }
light_source { <-4, 5, -6> rgb 1 }
#declare slope = 0.3;
#declare thickness = 0.25;
#declare poly = <0.2, 0.5, 0.9>;
#declare translucency = 0.4;
#declare emission = 2;
sphere { 0, 1 pigment { rgb poly } finish { ambient translucency } }
cylinder { <-2, slope, 0>, <2, slope, 0>, thickness pigment { rgb 0.5 * emission } }
